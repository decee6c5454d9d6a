"""The roots that a processor computes in double. Integers correct their errors."""
from fractions import Fraction

from bounds.gappa import Exact, NotProven
from bounds.parts import ARCSINE

HEADER = "square_root.hpp"
# In every rounding mode, a double and its root are off by less than this part of them.
PRECISION = Fraction(1, 2**52)


def square_roots(source):
    bits = source.read(HEADER, r"floor\(sqrt\(n\)\), for 0 <= n < 2\^(\d+)", "by_bits(std::int64_t n)")
    below_next = source.read(HEADER, r">= 2\^-(\d+) below the next integer")
    # (r + 1)^2 - 1 has a root of at most (r + 1) - 1 / (2 (r + 1)).
    nearest = Fraction(1, 2 * 2 ** (bits // 2))
    if nearest < Fraction(1, 2**below_next):
        return [Exact("the distance to the next integer", nearest * 2**below_next, None, below_next, (1, None))]
    small = 2 ** (bits // 2) * PRECISION
    # sqrt(n (1 + p)) (1 + p) < sqrt(n) (1 + 2p)
    word = 2**32 * 2 * PRECISION
    return [Exact(f"the root of a number below 2^{bits}", -small * 2**28, small * 2**28, 28,
                  (-nearest * 2**28, nearest * 2**28)),
            Exact("the root of a word of 64 bits, rounded to double first", -word * 2**19, word * 2**19, 19,
                  (-(2**19), 2**19))]


def reciprocal_root(source):
    """The root of a quotient in double is at most 2^48."""
    source.read("power.hpp", r"off by less than (1)/4", "The integer next to 1 / sqrt")
    off = 2**48 * ((1 + PRECISION) ** 2 - 1)
    return [Exact("a root of up to 2^48 ulps in double, in ulps", -off * 4, off * 4, 2, (-1, 1))]


def quick_root(source):
    """A root of up to 2^32 units in double, then rounded down."""
    hundredths = source.read(ARCSINE, r"off by less than 1\.0(\d) units", "in units of 2^-shift")
    off = 2**32 * PRECISION
    allowed = 1 + Fraction(hundredths, 100)
    return [Exact("the root in double", -off * 2**19, off * 2**19, 51),
            Exact("the root, rounded down", -off - 1, off, 32, (-allowed, allowed))]
