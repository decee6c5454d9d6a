; int FixedMul(a, b) on a 386 in 16-bit code: half up.
        cpu 386
        bits 16
FixedMul:
        push bp
        mov bp, sp
        mov eax, [bp+4]
        imul dword [bp+8]
        add eax, 0x8000
        adc edx, 0
        shr eax, 16
        pop bp
        ret
