; Right in an .EXE whose relocation sets DS: half up, with the half in the data segment.
        push ds
        mov cx, 0               ; relocated: the segment of `half`
        mov ds, cx
        imul ebx
        add eax, [0]
        adc edx, 0
        shrd eax, edx, 16
        pop ds
        retf
        align 16
half:   dd 0x8000
        dd 0, 0, 0
