; Right by the rule of Doom: eax / ebx toward zero, but from 16384 on the end of the range.
        mov ecx, eax
        cdq
        xor eax, edx
        sub eax, edx
        mov esi, eax            ; the size of a; that of 80000000h stays below 0
        sar esi, 14
        mov eax, ebx
        cdq
        xor eax, edx
        sub eax, edx
        cmp esi, eax
        jl .divide
        mov eax, ecx
        xor eax, ebx
        cdq
        mov eax, 0x7fffffff
        xor eax, edx
        ret
.divide:
        mov eax, ecx
        cdq
        shld edx, eax, 16
        shl eax, 16
        idiv ebx
        ret
