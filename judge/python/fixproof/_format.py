"""Formats of words: their range and their digits."""
import re
from typing import Union

from ._command import Error

_NAME = re.compile(r"(q|u)(-?\d{1,3})_(-?\d{1,3})|(d|ud)(\d{1,3})_(\d{1,3})")


class Format:
    """A format of words, by its name.

    `qW_F` is signed and `uW_F` unsigned, with W bits before the point (the sign included) and F
    after it. `dB_F` and `udB_F` have B bits in units of 10**-F. A word has 2 to 64 bits.

    Raises Error for any other name.
    """

    def __init__(self, name: str) -> None:
        match = _NAME.fullmatch(name) if isinstance(name, str) else None
        bits = 0
        if match:
            binary, before, after, decimal, size, places = match.groups()
            bits = int(size) if decimal else int(before) + int(after)
        if match is None or not 2 <= bits <= 64:
            raise Error(f"format {name!r}: write qW_F or uW_F, such as q16_16, or dB_F or udB_F, "
                        "such as d64_8, with 2 to 64 bits in all")
        #: The name, such as `q16_16`.
        self.name: str = name
        #: Bits of a word, from 2 to 64.
        self.bits: int = bits
        #: Whether words can be negative.
        self.signed: bool = (decimal or binary) in ("q", "d")
        #: The lowest and the highest word.
        self.lowest: int = -(1 << (bits - 1)) if self.signed else 0
        self.highest: int = (1 << (bits - 1 if self.signed else bits)) - 1
        #: Units in 1.0: an int, or a float below 1 for a format whose unit is above 1.
        self.one: Union[int, float] = 10 ** int(places) if decimal else 2 ** int(after)
        #: Bytes of the integer that stores a word: 1, 2, 4 or 8.
        self.bytes: int = next(size for size in (1, 2, 4, 8) if 8 * size >= bits)

    def wrap(self, value: int) -> int:
        """Returns the word that equals the integer `value` modulo 2**bits."""
        return (value - self.lowest) % (1 << self.bits) + self.lowest

    def __contains__(self, value: int) -> bool:
        return self.lowest <= value <= self.highest

    @property
    def dtype(self) -> str:
        """The name of the NumPy type that stores a word, such as `int32`."""
        return f"{'int' if self.signed else 'uint'}{8 * self.bytes}"

    @property
    def code(self) -> str:
        """The letter of that integer in the module `struct`."""
        letter = {1: "b", 2: "h", 4: "i", 8: "q"}[self.bytes]
        return letter if self.signed else letter.upper()

    def __repr__(self) -> str:
        return f"Format({self.name!r})"
