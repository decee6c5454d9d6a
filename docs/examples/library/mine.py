#!/usr/bin/env python3
"""usage: mine.py FIXPROOF LIBRARY

A class of numbers whose product is my_mul of a shared library, called by ctypes, and its test: Fixproof
verifies the function in the same file that Python has loaded, then a few products go through the class."""
import ctypes
import subprocess
import sys


def load(library):
    """Returns my_mul. Without the types, ctypes takes every argument for an int of C."""
    function = ctypes.CDLL(library).my_mul
    function.argtypes = [ctypes.c_int32, ctypes.c_int32]
    function.restype = ctypes.c_int32
    return function


class Fixed:
    """A number of 16.16. `mul` is my_mul."""

    mul = None

    def __init__(self, word):
        self.word = word

    def __mul__(self, other):
        return Fixed(Fixed.mul(self.word, other.word))

    def __float__(self):
        return self.word / 65536


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: mine.py FIXPROOF LIBRARY")
    fixproof, library = sys.argv[1:]
    verified = subprocess.run([fixproof, "verify", "mul", "--target", "standard", "--against", f"{library}:my_mul"])
    Fixed.mul = staticmethod(load(library))
    for a, b in ((1.5, 2.5), (-1.5, 2.5), (1 / 65536, 0.5)):
        product = Fixed(round(a * 65536)) * Fixed(round(b * 65536))
        print(f"{a} * {b} = {float(product)}")
    return verified.returncode


if __name__ == "__main__":
    sys.exit(main())
