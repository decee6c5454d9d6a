; Wrong: adds the caller's carry.
        imul ebx
        shrd eax, edx, 16
        adc eax, ecx
        ret
