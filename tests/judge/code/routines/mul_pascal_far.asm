; Right: a far Pascal function in 16-bit code, rounded down. The last argument is at the lowest
; address.
        push bp
        mov bp, sp
        mov eax, [bp+10]
        imul dword [bp+6]
        shrd eax, edx, 16
        mov edx, eax
        shr edx, 16
        pop bp
        retf 8
