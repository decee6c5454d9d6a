; Wrong for half up: a tie of a negative product goes away from zero.
        mov ecx, eax
        xor ecx, ebx
        imul ebx
        mov edi, 0x8000
        add ecx, ecx
        sbb edi, 0
        add eax, edi
        adc edx, 0
        shrd eax, edx, 16
        ret
