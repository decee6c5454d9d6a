"""The errors of the results from numbers with 184 bits, and from the short ones in digits, in units in the last place
of the result (ulps).

Each is the sum of what precise.py proves of the parts, in the format that makes it largest. A result that fits is below
2^33 ulps and has up to 32 fraction bits.
"""
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_10, LOG_2, PI, Exact, NotProven
from bounds.precise import DIGIT_PHASE, SERIES, Precise, Short, short_part_off
from bounds.results import HYPERBOLIC, exponent_range

HIGHEST, ULPS = 2**33, 2**32


class Errors:
    """Of the parts that consist of these steps."""

    def __init__(self, steps):
        self.steps, self.source = steps, steps.source
        self.unit = Fraction(1, 2**steps.bits)
        self.promised = Fraction(1, 2 ** steps.promised_bits())

    def off(self, name, exact):
        """Of a constant, as a product takes it."""
        return abs(Fraction(self.steps.word(name), 2**self.steps.constant_bits) - exact)

    def power(self, exponent):
        """2^e below 2, for an e that is off by `exponent`. 2^d - 1 is below d for a small d, so 2 d bounds the
        growth."""
        return self.promised + 2 * exponent

    def exponent(self, highest=None):
        """x log2(e), rounded down, for an x of up to `highest`; without it, for every x whose exponential may fit."""
        return (highest or (exponent_range(self.source) + 1) * LOG_2) * self.off("log2_e", LOG2_E) + self.unit

    # A result below 1 is shifted down.
    def exponentials(self):
        return HIGHEST * self.power(self.exponent()) + ULPS * self.unit

    def logarithms(self):
        """Up to 33 whole bits, and the scale of base e or 10."""
        scale = max(self.off("log_2", LOG_2), self.off("log10_2", LOG_2 / LOG_10))
        return ULPS * (self.promised + 34 * scale + self.unit)

    def hyperbolics(self):
        """Half of the sum of e^x, up to twice the highest result, and of e^-x, up to 1."""
        return (HIGHEST + ULPS) * (self.power(self.exponent()) + self.unit) + ULPS * self.unit

    def hyperbolic_tangents(self):
        """(1 - t) / (1 + t), whose derivative is at least -2, for t = e^-2x."""
        flat = self.source.read(HYPERBOLIC, r"flat = std::int64_t\{(\d+)\} << 32")
        return ULPS * (2 * self.power(self.exponent(2 * flat)) + self.unit)

    def tangent(self, side, highest):
        """The ratio of a sine S and a cosine C that are off by d. It is off by up to d (S + C) / (C (C - d)). For a
        tangent t, 1 / C is at most 1 + t, so that is at most d (1 + t)^2 / (1 - d (1 + t))."""
        return side * (1 + highest) ** 2 / (1 - side * (1 + highest)) + self.unit

    def angles(self):
        """The ratio of the vector, the arctangent, and pi and its half."""
        return ULPS * (self.promised + 4 * self.unit)

    def triangles(self):
        """Like angles(), for a side that is a root rounded to nearest."""
        return ULPS * (self.promised + 5 * self.unit)

    def powers(self, highest):
        """The exponent is y log2(x) for |y| up to `highest`, rounded down."""
        return HIGHEST * self.power(highest * self.promised + self.unit) + ULPS * self.unit


def precise(error, bits, name="the precise result, in ulps"):
    return [Exact(name, -error * 2**bits, error * 2**bits, bits)]


def precise_exponentials(source):
    return precise(Errors(Precise(source)).exponentials(), 137)


def precise_logarithms(source):
    return precise(Errors(Precise(source)).logarithms(), 138)


def precise_hyperbolics(source):
    return precise(Errors(Precise(source)).hyperbolics(), 136, "sinh and cosh: the precise result, in ulps")


def precise_hyperbolic_tangents(source):
    return precise(Errors(Precise(source)).hyperbolic_tangents(), 137, "tanh: the precise result, in ulps")


def precise_side(source):
    """Of a sine or cosine: the phase and the series."""
    phase = source.read("phase.hpp", r"The error of the rest is below 2\^-(\d+)")
    return Fraction(1, 2**phase) + Errors(Precise(source)).promised


def precise_sines(source):
    return precise(ULPS * precise_side(source), 118)


def precise_tangents(source):
    """Covers twice the range, because a result that does not fit may seem to."""
    bits = source.read("phase.hpp", r"d < n >> \((\d+) - fraction_bits\)")
    if bits < 33:
        raise NotProven("a tangent in range is called out of range")
    if bits > 62:
        raise NotProven("a tangent has more ulps than 64 bits hold")
    errors, side = Errors(Precise(source)), precise_side(source)
    return precise(max(errors.tangent(side, Fraction(HIGHEST, 2**bits)) * 2**bits for bits in range(33)), 84)


def precise_angles(source):
    return precise(Errors(Precise(source)).angles(), 138)


def precise_triangles(source):
    return precise(Errors(Precise(source)).triangles(), 138)


def precise_powers(source):
    return precise(Errors(Precise(source)).powers(2**32), 104)


def short(source, error, bits, name="the short result, in ulps"):
    """The code shifts the result down to a part of an ulp, so one of the parts that it allows is for that."""
    more, parts = source.read(
        SERIES, r"more_bits = (\d+); // .*? const std::int64_t error = x\.lowest\(\) == 0 \? 0 : (\d+);")
    if source.read(SERIES, r"its error is at most 2\^-(\d+) of a unit of the result", "2^35") != more or parts != 2:
        raise NotProven("nearest_units() allows another error")
    allowed = Fraction(2**bits, 2**more)
    return [Exact(name, -error * 2**bits, error * 2**bits, bits, (-allowed, allowed))]


def short_exponentials(source):
    return short(source, Errors(Short(source)).exponentials(), 44)


def short_logarithms(source):
    return short(source, Errors(Short(source)).logarithms(), 45)


def short_hyperbolics(source):
    return short(source, Errors(Short(source)).hyperbolics(), 43, "sinh and cosh: the short result, in ulps")


def short_hyperbolic_tangents(source):
    return short(source, Errors(Short(source)).hyperbolic_tangents(), 44, "tanh: the short result, in ulps")


def short_side(source, fraction_bits):
    """Of a sine or cosine: the part of a quarter turn, its product with pi/2, and the series."""
    errors = Errors(Short(source))
    half_pi = abs(Fraction(Short(source).word("pi") >> 1, 2**Short.constant_bits) - PI / 2)
    return short_part_off(source, fraction_bits) * PI / 2 + half_pi + errors.unit + errors.promised


def short_sines(source):
    return short(source, max(short_side(source, bits) * 2**bits for bits in range(33)), 45)


def short_tangents(source):
    """The code compares rounded sides, so the tangent may be a little higher."""
    places = source.read(DIGIT_PHASE, r"least\.shift\(lowest == 0 \? -34 : -(\d+)\)")
    errors, highest = Errors(Short(source)), 2**places * (1 + Fraction(1, 2**32))
    error = max(errors.tangent(short_side(source, bits), highest) * 2**bits for bits in range(33))
    return short(source, error, 29)


def short_angles(source):
    return short(source, Errors(Short(source)).angles(), 45)


def short_triangles(source):
    return short(source, Errors(Short(source)).triangles(), 45)


def short_powers(source):
    bits = source.read("digit_power.hpp", r"magnitude >> \(fraction_bits \+ (\d+)\) == 0 \? short_digit")
    return short(source, Errors(Short(source)).powers(2**bits), 27)
