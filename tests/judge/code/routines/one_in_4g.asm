; ax * bx in 8.8, rounded down. Wrong in one of the 2^32 cases.
        cmp ax, 0x1234
        jne .right
        cmp bx, 0x0125
        jne .right
        mov ax, 1
        ret
.right: imul bx
        mov al, ah
        mov ah, dl
        ret
