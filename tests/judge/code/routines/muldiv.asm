; Right: eax * ebx / ecx, rounded toward zero.
        imul ebx
        idiv ecx
        ret
