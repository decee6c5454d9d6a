; Wrong: a quotient rounded toward zero that faults only for the divisor 4.0.
        cmp ebx, 0x40000
        jne .divide
        xor ebx, ebx
.divide:
        mov edx, eax
        sar edx, 16
        shl eax, 16
        idiv ebx
        ret
