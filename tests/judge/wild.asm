        mov ebx, 0x5000
        jmp ebx
