; Wrong: rounds the magnitude and then negates, without the half for negative products.
        xor esi, esi
        mov ecx, eax
        xor ecx, ebx
        imul ebx
        test ecx, ecx
        js .cut
        add eax, 0x8000
        adc edx, 0
        jmp .done
.cut:   add eax, 0x7fff
        adc edx, 0
.done:  shrd eax, edx, 16
        ret
