; Right: a near C function for a 386 in 16-bit code, half up.
mul_c:  push bp
        mov bp, sp
        mov eax, [bp+4]
        imul dword [bp+8]
        add eax, 0x8000
        adc edx, 0
        shrd eax, edx, 16
        mov edx, eax
        shr edx, 16
        pop bp
        ret
