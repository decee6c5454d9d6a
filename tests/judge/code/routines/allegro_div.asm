; Right by the rule of Allegro on the 386: eax / ebx toward zero, or 7fffffffh with a sign.
        mov ecx, eax
        xor ecx, ebx            ; its sign is that of the result
        test ebx, ebx
        jnz .sized
        mov ecx, eax            ; no sign of a zero counts
.sized: cdq
        xor eax, edx
        sub eax, edx
        mov edx, ebx
        sar edx, 31
        xor ebx, edx
        sub ebx, edx
        mov edx, eax
        shr edx, 16
        shl eax, 16
        cmp edx, ebx
        jae .end
        div ebx
        test eax, eax
        jns .signed
.end:   mov eax, 0x7fffffff
.signed:
        test ecx, ecx
        jns .done
        neg eax
.done:  ret
