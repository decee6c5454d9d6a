; Right by the rule of Wolfenstein 3-D: a near C function for the 8088, a number times a fraction of 16 bits that has its
; sign in bit 31.
        push bp
        mov bp, sp
        push si
        mov ax, [bp+4]
        mov cx, [bp+6]
        mov si, [bp+10]
        xor si, cx              ; its sign is that of the result
        test cx, cx
        jns .multiply
        not cx
        neg ax
        sbb cx, -1
.multiply:
        mul word [bp+8]
        mov bx, dx
        mov ax, cx
        mul word [bp+8]
        add ax, bx
        adc dx, 0
        test si, si
        jns .done
        not dx
        neg ax
        sbb dx, -1
.done:  pop si
        pop bp
        ret
