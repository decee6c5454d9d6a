#!/usr/bin/env python3
"""Python's round() as a subject of `fixproof check`: mul or div of the cases on standard input."""
import sys


def signed(word):
    value = int(word, 16)
    return value - (1 << 32) if value >> 31 else value


def mul(a, b):
    return round(a * b / 65536)


def div(a, b):
    return round(a * 65536 / b)


operation = {"mul": mul, "div": div}[sys.argv[1]]
for line in sys.stdin:
    a, b = map(signed, line.split())
    try:
        print(f"{operation(a, b) & 0xFFFFFFFF:08x}")
    except ZeroDivisionError:
        print("DE")
