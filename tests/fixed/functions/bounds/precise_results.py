"""The errors of the results that are computed again with 184 bits, in units in the last place of the result (ulps).

Each is the sum of what precise.py proves of the parts, in the format that makes it largest. B is the bound that the
code promises for a precise part, and U is the unit 2^-184. A result that fits is below 2^33 ulps and has up to 32
fraction bits.
"""
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_10, LOG_2, Exact, NotProven
from bounds.precise import HEADER
from bounds.results import HYPERBOLIC, exponent_range

U = Fraction(1, 2**184)
HIGHEST, ULPS = 2**33, 2**32


def promised(source):
    bits = source.read(HEADER, r"with an error below 2\^-(\d+)")
    if source.read("arctangent.hpp", r"with an error below 2\^-(\d+)") != bits:
        raise NotProven("the precise parts promise different errors")
    return Fraction(1, 2**bits)


def off(source, name, exact):
    return abs(source.real(name) - exact * 2**184) * U


def power(source, exponent):
    """2^e below 2, for an e that is off by `exponent`. 2^d - 1 is below d for a small d, so 2 d bounds the growth."""
    return promised(source) + 2 * exponent


def exponent(source, highest=None):
    """x log2(e), rounded down, for an x of up to `highest`; without it, for every x whose exponential may fit."""
    return (highest or (exponent_range(source) + 1) * LOG_2) * off(source, "real_log2_e", LOG2_E) + U


def both(name, error, bits):
    return [Exact(name, -error * 2**bits, error * 2**bits, bits)]


def precise_exponentials(source):
    # A result below 1 is shifted down.
    return both("the precise result, in ulps", HIGHEST * power(source, exponent(source)) + ULPS * U, 137)


def precise_logarithms(source):
    """Up to 33 whole bits, and the scale of base e or 10."""
    scale = max(off(source, "real_log_2", LOG_2), off(source, "real_log10_2", LOG_2 / LOG_10))
    return both("the precise result, in ulps", ULPS * (promised(source) + 34 * scale + U), 138)


def precise_hyperbolics(source):
    """Half of the sum of e^x, up to twice the highest result, and of e^-x, up to 1."""
    one = power(source, exponent(source)) + U
    return both("sinh and cosh: the precise result, in ulps", (HIGHEST + ULPS) * one + ULPS * U, 136)


def precise_hyperbolic_tangents(source):
    """(1 - t) / (1 + t), whose derivative is at least -2, for t = e^-2x."""
    flat = source.read(HYPERBOLIC, r"flat = std::int64_t\{(\d+)\} << 32")
    one = power(source, exponent(source, 2 * flat)) + U
    return both("tanh: the precise result, in ulps", ULPS * (2 * one + U), 137)


def phase(source):
    return Fraction(1, 2 ** source.read("phase.hpp", r"The error of the rest is below 2\^-(\d+)")) + promised(source)


def precise_sines(source):
    return both("the precise result, in ulps", ULPS * phase(source), 118)


def precise_tangents(source):
    """The ratio of a sine and a cosine that are off by d. It is off by d (1 + t)^2 / (1 - 2d) for a tangent t. Covers
    twice the range, because a result that does not fit may seem to."""
    shift = source.read("phase.hpp", r"d < n >> (\d+)\)")
    if shift < 33:
        raise NotProven("a tangent in range is called out of range")
    one = phase(source)
    most = max((1 + Fraction(HIGHEST, 2**bits)) ** 2 * 2**bits for bits in range(33))
    return both("the precise result, in ulps", most * one / (1 - 3 * one) + ULPS * U, 84)


def precise_angles(source):
    """The ratio of the vector, the arctangent, and pi and its half."""
    return both("the precise result, in ulps", ULPS * (promised(source) + 4 * U), 138)


def precise_triangles(source):
    """Like precise_angles(), for a side that is a root rounded to nearest."""
    return both("the precise result, in ulps", ULPS * (promised(source) + 5 * U), 138)


def precise_powers(source):
    """The exponent is y log2(x) for |y| up to 2^32, rounded down."""
    return both("the precise result, in ulps", HIGHEST * power(source, 2**32 * promised(source) + U) + ULPS * U, 104)
