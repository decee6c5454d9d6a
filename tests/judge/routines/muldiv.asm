; Right: eax * ebx / ecx toward zero.
        imul ebx
        idiv ecx
        ret
