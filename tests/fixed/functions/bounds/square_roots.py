"""The roots that a processor computes in double."""
import math
from fractions import Fraction

from bounds.gappa import Exact
from bounds.parts import ARCSINE

HEADER = "square_root.hpp"
# In every rounding mode, a double and its root are off by less than this part of them.
PRECISION = Fraction(1, 2**52)


def square_roots(source):
    bits = source.read(HEADER, r"digits \+ FractionBits < (\d+)", "has_fast_root") - 1
    root = math.isqrt(2**bits) + 1
    # The root and its sum with 1/2 are rounded. Every root of an integer is at least this far from a half.
    both, nearest = 2 * (root + 1) * PRECISION, Fraction(1, 8 * root + 4)
    # sqrt(n (1 + p)) (1 + p) < sqrt(n) (1 + 2p)
    word = 2**32 * 2 * PRECISION
    return [Exact(f"the root of a number below 2^{bits}, plus 1/2", -both * 2**28, both * 2**28, 28,
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
