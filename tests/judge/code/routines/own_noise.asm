; Wrong: adds ECX, which the caller does not set, and the last bit that SHRD shifts out.
        imul ebx
        shrd eax, edx, 16
        adc eax, ecx
        ret
