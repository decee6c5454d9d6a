        jmp $
