; floor(a * b / 65536) on the x87: AGREES only if the control word that it keeps masks exceptions and
; asks for full precision
        push eax
        push ebx
        fild dword [esp]
        fimul dword [esp+4]
        push dword 0x37800000           ; 1 / 65536
        fmul dword [esp]
        push eax
        fnstcw [esp]
        mov ax, [esp]
        and ah, 0xF3
        or ah, 4                        ; round down
        mov [esp+2], ax
        fldcw [esp+2]
        fistp qword [esp+8]
        fldcw [esp]
        add esp, 8
        pop eax
        pop ebx
        ret
