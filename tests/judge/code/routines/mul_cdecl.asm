; Right: a C function in 32-bit code, rounded down.
        global  mul_cdecl
mul_cdecl:
        push ebp
        mov ebp, esp
        mov eax, [ebp+8]
        imul dword [ebp+12]
        shrd eax, edx, 16
        pop ebp
        ret
