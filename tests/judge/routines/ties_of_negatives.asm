; Wrong for half up: ties of negative products go away from zero.
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
