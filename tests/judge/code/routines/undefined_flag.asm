; Relies on SF, which IMUL leaves undefined. The result is right, because both ways are the same.
        imul ebx
        js .next
.next:  shrd eax, edx, 16
        ret
