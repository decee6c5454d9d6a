"""A 16.16 multiply in Python that rounds halves up: reads cases, writes results."""
import sys


def mul(a, b):
    return (a * b + 0x8000) >> 16


def word(text):
    value = int(text, 16)
    return value - (value >> 31 << 32)


for line in sys.stdin:
    print(f"{mul(*map(word, line.split())) & 0xFFFFFFFF:08x}")
