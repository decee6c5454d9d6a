; Right in an .EXE whose relocation sets DS: half away from zero, with a table of what is added.
        push ds
        imul ebx
        mov ebx, edx
        shr ebx, 31             ; the sign
        shl bx, 2
        mov cx, 0               ; relocated: the segment of `halves`
segment_at equ $ - 2
        mov ds, cx
        add eax, [bx]
        adc edx, 0
        shrd eax, edx, 16
        pop ds
        ret
        align 16, db 0x90
halves: dd 0x8000, 0x7FFF
        dd 0, segment_at
