; Right results, but the routine leaves one value on the x87 stack. After eight calls, a caller's
; values no longer fit.
        push eax
        push ebx
        fild dword [esp]
        fild dword [esp+4]
        fmul st1                        ; FMULP would pop the other factor
        push dword 0x37800000           ; 1 / 65536
        fmul dword [esp]
        fnstcw [esp]
        and byte [esp+1], 0xF3
        or byte [esp+1], 4              ; round down
        fldcw [esp]
        fistp qword [esp+4]
        and byte [esp+1], 0xF3
        fldcw [esp]
        pop eax
        pop eax
        pop ebx
        ret
