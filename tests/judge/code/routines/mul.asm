; Right: eax * ebx in 16.16, half up. The carry from adding the half goes into edx.
mul_half_up:
        imul ebx
        add eax, 0x8000
        adc edx, 0
        shrd eax, edx, 16
        ret
