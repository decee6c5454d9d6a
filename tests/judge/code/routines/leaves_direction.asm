; Right results, but the routine returns with the direction flag set, which callers expect clear.
        imul ebx
        shrd eax, edx, 16
        std
        ret
