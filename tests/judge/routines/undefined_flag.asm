; Wrong on some processors: IMUL leaves SF undefined.
        imul ebx
        js .next
.next:  shrd eax, edx, 16
        ret
