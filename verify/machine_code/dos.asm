; The frame of a DOS command. It reads lines of operands in hex digits from standard input and
; answers each with a line of results or DE, like `fixproof eval`. It exits with status 2 if a line
; is invalid or the output cannot be written. write_sources defines ROUTINE, WORDS_IN and WORDS_OUT
; and appends the listing. 8086 instructions only.
        cpu 8086
        bits 16
        org 0x100

%if WORDS_IN = 1
%define DIGITS 4                        ; CosSin's angle is one machine word
%else
%define DIGITS 8
%endif
%define INPUT_SIZE 512
%define LINE_SIZE 256                   ; longer than any line of operands

start:
        cld
        mov ax, 0x3500                  ; the previous handler of #DE in ES:BX
        int 0x21
        mov [old_handler], bx
        mov [old_handler + 2], es
        push ds
        pop es
        mov dx, divide_error
        mov ax, 0x2500
        int 0x21
        mov [stack_before], sp

next_line:
        call read_line
        jc finished
        inc word [line_number]
        call is_passed_over
        je next_line
        call parse_line
        jc bad_line
        call call_routine
        mov si, results
        mov di, output
        mov cx, WORDS_OUT
.word:
        push cx
        lodsw
        mov dx, [si]
        inc si
        inc si
        call put_word
        pop cx
        dec cx
        jz print
        mov al, ' '
        stosb
        jmp .word

; The handler of INT 0. It abandons the routine and its stack.
divide_error:
        mov sp, [stack_before]
        sti
        mov di, output
        mov ax, 'DE'
        stosw
print:                                  ; prints `output` up to DI and a line end
        mov ax, 0x0A0D
        stosw
        mov dx, output
        mov cx, di
        sub cx, dx
        mov bx, 1
        mov ah, 0x40
        int 0x21
        jc not_written
        cmp ax, cx
        jb not_written
        jmp next_line

finished:
        mov al, 0
leave:                                  ; exits with status AL
        push ax
        lds dx, [old_handler]
        mov ax, 0x2500
        int 0x21
        pop ax
        mov ah, 0x4C
        int 0x21

not_written:
        mov dx, not_written_text
        mov cx, not_written_end - not_written_text
        jmp complain
bad_line:
        mov ax, [line_number]
        mov di, bad_line_number + 5     ; from its last digit to its first
        mov bx, 10
.digit:
        xor dx, dx
        div bx
        add dl, '0'
        dec di
        mov [di], dl
        or ax, ax
        jnz .digit
        mov dx, bad_line_text
        mov cx, bad_line_end - bad_line_text
complain:
        mov bx, 2
        mov ah, 0x40
        int 0x21
        mov al, 2
        jmp leave

; Reads the next byte of standard input into AL. Carry flag: the input has ended, or Ctrl-Z ends it.
next_byte:
        mov si, [input_next]
        cmp si, [input_end]
        jb .there
        mov dx, input
        mov cx, INPUT_SIZE
        xor bx, bx
        mov ah, 0x3F
        int 0x21
        jc .none
        or ax, ax
        jz .none
        mov si, input
        add ax, si
        mov [input_end], ax
        mov [input_next], si
.there:
        lodsb
        cmp al, 0x1A
        je .none
        mov [input_next], si
        clc
        ret
.none:
        stc
        ret

; Reads the next line into `line` without its line end, appends a 0 and sets line_end. Carry flag:
; the input has ended. Truncates a long line to LINE_SIZE bytes, still too long to be valid.
read_line:
        mov di, line
.more:
        call next_byte
        jc .last
        cmp al, 0x0A
        je .whole
        cmp di, line + LINE_SIZE
        jae .more
        stosb
        jmp .more
.last:
        cmp di, line
        je .none
.whole:
        cmp di, line
        je .ended
        cmp byte [di - 1], 0x0D
        jne .ended
        dec di
.ended:
        mov byte [di], 0
        mov [line_end], di
        clc
        ret
.none:
        stc
        ret

; Zero flag: the line is blank or begins with #.
is_passed_over:
        mov si, line
        cmp byte [si], '#'
        je .decided
.blank:
        cmp si, [line_end]
        je .decided
        lodsb
        cmp al, ' '
        je .blank
        cmp al, 0x09
        je .blank
.decided:
        ret

; Parses the line into `operands`. Carry flag: the line is not WORDS_IN words of DIGITS digits,
; separated by single spaces.
parse_line:
        mov si, line
        mov di, operands
        mov cx, WORDS_IN
.word:
        xor dx, dx
        xor bx, bx
        mov bp, DIGITS
.digit:
        lodsb
        sub al, '0'
        cmp al, 10
        jb .append
        sub al, 'a' - '0' - 10
        cmp al, 10
        jb .wrong
        cmp al, 16
        jae .wrong
.append:
%rep 4
        shl bx, 1
        rcl dx, 1
%endrep
        or bl, al
        dec bp
        jnz .digit
        mov [di], bx
        mov [di + 2], dx
        add di, 4
        lodsb
        dec cx
        jz .end
        cmp al, ' '
        je .word
.wrong:
        stc
        ret
.end:
        dec si
        cmp si, [line_end]
        jne .wrong
        clc
        ret

; Calls the routine as C does, last argument first, and stores its results in `results`.
%if WORDS_OUT = 1
%define ARGUMENT_BYTES 8
%else
%define ARGUMENT_BYTES 6
%endif
call_routine:
%if WORDS_OUT = 1
        push word [operands + 6]
        push word [operands + 4]
        push word [operands + 2]
        push word [operands]
        call ROUTINE
        mov [results], ax
        mov [results + 2], dx
%elif WORDS_IN = 1
        mov ax, results + 4
        push ax
        mov ax, results
        push ax
        push word [operands]
        call ROUTINE
%else
        mov ax, results
        push ax
        mov ax, operands + 12 * 4
        push ax
        mov ax, operands
        push ax
        call ROUTINE
%endif
        add sp, ARGUMENT_BYTES
        ret

; put_word writes DX:AX as 8 digits at DI; put_half writes AX as 4.
put_word:
        push ax
        mov ax, dx
        call put_half
        pop ax
put_half:
        mov bx, ax
        mov cx, 0x0404
.digit:
        rol bx, cl
        mov al, bl
        and al, 0x0F
        add al, '0'
        cmp al, '9'
        jbe .put
        add al, 'a' - '0' - 10
.put:
        stosb
        dec ch
        jnz .digit
        ret

%defstr WANTED_WORDS WORDS_IN
%defstr WANTED_DIGITS DIGITS
bad_line_text:
        db "line "
bad_line_number:
        db "     : not ", WANTED_WORDS, " x ", WANTED_DIGITS
        db " lower-case hex digits, single spaces between", 0x0D, 0x0A
bad_line_end:
not_written_text:
        db "cannot write standard output", 0x0D, 0x0A
not_written_end:

input_next:  dw input
input_end:   dw input
line_number: dw 0

        section .bss
old_handler:  resw 2
stack_before: resw 1
line_end:     resw 1
operands:     resd WORDS_IN
results:      resd WORDS_OUT
input:        resb INPUT_SIZE
line:         resb LINE_SIZE + 1
output:       resb WORDS_OUT * 9 + 2

        section .text
