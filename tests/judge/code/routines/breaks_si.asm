; Right results, but the routine changes SI, which C compilers rely on.
        push bp
        mov bp, sp
        mov si, 1
        mov eax, [bp+4]
        imul dword [bp+8]
        shrd eax, edx, 16
        mov edx, eax
        shr edx, 16
        pop bp
        ret
