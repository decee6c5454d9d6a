; Wrong: the carry from adding the half is lost.
        imul ebx
        add eax, 0x8000
        shrd eax, edx, 16
        ret
