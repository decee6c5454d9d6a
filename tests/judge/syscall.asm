        mov eax, 1
        int 0x80
        ret
