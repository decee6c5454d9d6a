; Wrong: a quotient toward zero that faults for the divisor 4.0 alone.
        cmp ebx, 0x40000
        jne .divide
        xor ebx, ebx
.divide:
        mov edx, eax
        sar edx, 16
        shl eax, 16
        idiv ebx
        ret
