"""The error bounds of the numbers with 184 bits after the point, and of the short ones in digits. Every step rounds
down to a unit."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_2, PI, Exact, NotProven, Proof, between, within

HEADER, SERIES, DIGIT_PHASE = "precise_exponential.hpp", "digit_series.hpp", "digit_phase.hpp"


class Precise:
    """Steps in units of 2^-184."""
    bits = constant_bits = 184

    def __init__(self, source):
        self.source = source
        self.unit = f"fixed<-{self.bits},dn>"

    def terms_of_power(self):
        return self.source.read(HEADER, r"std::uint32_t n = (\d+); n > 0; --n")

    def last_of_logarithm(self):
        return self.source.read(HEADER, r"std::uint32_t n = (\d+); n > 1; n -= 2")

    def steps_of_arctangent(self):
        if self.source.read("arctangent.hpp", r"real_one << (\d)\) < x \* real\{5\}") != 1:
            raise NotProven("precise_arctangent() has another threshold")
        return self.source.read("arctangent.hpp", r"std::uint32_t k = (\d+); k > 0; --k")

    def last_of_sine(self):
        return self.source.read("phase.hpp", r"std::uint32_t n = (\d+); n > 0; n -= 2")

    def promised_bits(self):
        bits = self.source.read(HEADER, r"with an error below 2\^-(\d+)")
        if self.source.read("arctangent.hpp", r"with an error below 2\^-(\d+)") != bits:
            raise NotProven("the precise parts promise different errors")
        return bits

    def word(self, name):
        """A constant in units of 2^-constant_bits, as a product takes it."""
        return self.source.real("real_" + name) >> (184 - self.constant_bits)

    def constant(self, name, exact, halved=False):
        word = self.word(name) >> 1 if halved else self.word(name)
        return f"{name} = {word}b-{self.constant_bits};", within(name.upper(), word, self.constant_bits, exact)


class Short(Precise):
    """Steps in units of 2^-88, in digits; products round constants down to 2^-96."""
    bits, constant_bits = 88, 96

    def terms(self, pattern, of_words):
        """The terms of short numbers. Those of other numbers must be the terms of words."""
        long, short = self.source.read(SERIES, pattern)
        if long != of_words:
            raise NotProven(f"digits and words differ in terms: '{pattern}'")
        return short

    def terms_of_power(self):
        return self.terms(r"n = x\.lowest\(\) == 0 \? (\d+) : (\d+); n > 0; --n", super().terms_of_power())

    def last_of_logarithm(self):
        return self.terms(r"n = lowest == 0 \? (\d+) : (\d+); n > 1; n -= 2", super().last_of_logarithm())

    def steps_of_arctangent(self):
        if self.source.read(SERIES, r"fifth = scaled_integer\((\d), .*? i < (\d); \+\+i\) fifth -= x") != [2, 5]:
            raise NotProven("take_arctangent() has another threshold")
        steps = super().steps_of_arctangent()
        return self.terms(r"k = x\.lowest\(\) == 0 \? (\d+) : (\d+); k > 0; k -= 2", 2 * steps) // 2

    def last_of_sine(self):
        return self.terms(r"n = angle\.lowest\(\) == 0 \? (\d+) : (\d+); n > 0; n -= 2", super().last_of_sine())

    def promised_bits(self):
        return self.source.read(SERIES, r"the error of a short number is below 2\^-(\d+)")


def power_of_two(steps):
    """The Taylor series of e^(x log 2), for an exact x."""
    n, bits, unit = steps.terms_of_power(), steps.bits, steps.unit
    allowed = 2 ** (bits - steps.promised_bits())
    word, off = steps.constant("log_2", LOG_2)
    lines = [word, f"t = {unit}(x * log_2);", "T = x * LOG_2;", f"s{n + 1} = 1;", f"S{n + 1} = 1;"]
    for k in range(n, 0, -1):
        lines += [f"s{k} = 1 + {unit}({unit}(t * s{k + 1}) / {k});", f"S{k} = 1 + T * S{k + 1} / {k};"]
    rest = LOG_2 ** (n + 1) / math.factorial(n + 1) / (1 - LOG_2 / (n + 2))
    parts = [("t = x log(2)", "t - T", bits), ("the series, with that of t", "s1 - S1", bits),
             (f"its remainder after t^{n}", "-R", bits + 16)]
    return [Proof([*lines, "Y = S1 + R;"], ["x in [0,1]", off, f"R in {between(0, rest)}"], "s1 - Y",
                  -allowed, allowed, bits, ["s1 - Y -> (s1 - S1) - R;"], parts=parts)]


def logarithm(steps):
    """log2(m) from 2 atanh(Z); the code has z for Z, of which it rounds down a ratio."""
    last, bits, unit = steps.last_of_logarithm(), steps.bits, steps.unit
    allowed = 2 ** (bits - steps.promised_bits())
    word, off = steps.constant("log2_e", LOG2_E)
    lines = [word, f"z = {unit}(Z);", f"q = {unit}(z * z);", "Q = Z * Z;", f"s{last + 2} = 0;", f"S{last + 2} = 0;"]
    for n in range(last, 1, -2):
        lines += [f"s{n} = {unit}(q * ({unit}(1 / {n}) + s{n + 2}));", f"S{n} = Q * (1 / {n} + S{n + 2});"]
    lines += [f"l = {unit}(2 * z * (1 + s3));", "L = 2 * Z * (1 + S3);", f"y = {unit}(l * log2_e);",
              "Y = (L + R) * LOG2_E;"]
    z = Fraction(1, 3)
    rest = 2 * z ** (last + 2) / (last + 2) / (1 - z * z)
    return [Proof(lines, [f"Z in {between(0, z)}", off, f"R in {between(0, rest)}"], "y - Y", -allowed, allowed, bits,
                  ["y - Y -> (y - l * log2_e) + (l * log2_e - L * LOG2_E) - R * LOG2_E;"],
                  parts=[("z = (m - 1) / (m + 1)", "z - Z", bits),
                         ("the natural logarithm, with that of z", "l - L", bits),
                         (f"its remainder after z^{last}", "-R", bits),
                         ("the product with log2(e)", "y - l * log2_e", bits)])]


def arctangent(steps):
    """The arctangent of A, of which the code has a, at most one unit too low. Euler's series has the ratio P of
    its terms and the factor G, of which the code has p and g."""
    n, bits, unit = steps.steps_of_arctangent(), steps.bits, steps.unit
    # Up to 2/5, or for (1 - x) / (1 + x) up to 3/7. An error of x by a unit, rounded down, counts twice there;
    # pi/4 is off by a unit.
    highest = Fraction(3, 7)
    ratio = highest**2 / (1 + highest**2)
    argument = [f"a = {unit}(A);", f"b = 1 + {unit}(a * a);", "B = 1 + A * A;"]
    bound = [f"A in {between(0, highest)}"]
    off = "b - B -> (b - (1 + a * a)) + (a - A) * (a + A);"
    terms = Proof([*argument, f"p = 1 - {unit}(1 / b);", "P = 1 - 1 / B;"], bound, "p - P", -3, 3, bits,
                  [f"p - P -> -({unit}(1 / b) - 1 / b) + (b - B) / (b * B);", off],
                  name="the ratio of the terms, a^2 / (1 + a^2)", parts=[("the argument a", "a - A", bits)])
    factor = Proof([*argument, f"g = {unit}(a / b);", "G = A / B;"], bound, "g - G", -4, 4, bits,
                   ["g - G -> (g - a / b) + (a - A) / b - (A / B) * ((b - B) / b);", off],
                   name="the factor of the series, a / (1 + a^2)")
    lines = [f"s{n + 1} = 1;", f"S{n + 1} = 1;"]
    for k in range(n, 0, -1):
        lines += [f"s{k} = 1 + {unit}({unit}(p * s{k + 1}) * {2 * k} / {2 * k + 1});",
                  f"S{k} = 1 + P * S{k + 1} * {2 * k} / {2 * k + 1};"]
    lines += [f"y = {unit}(g * s1);", "Y = G * S1 + R;"]
    given = [f"p in {between(0, ratio)}", f"P in {between(0, ratio)}", f"p - P in [-3b-{bits},3b-{bits}]",
             f"g in {between(0, highest)}", f"G in {between(0, highest)}", f"g - G in [-4b-{bits},4b-{bits}]",
             f"R in {between(0, ratio ** (n + 1) / (1 - ratio))}"]
    units = 2 ** (bits - steps.promised_bits()) - 4
    return [terms, factor, Proof(lines, given, "y - Y", -units, units, bits,
                                 ["y - Y -> (y - g * s1) + (g * s1 - G * S1) - R;"],
                                 name="sum, for the argument a",
                                 parts=[("the series, with that of the ratio", "s1 - S1", bits),
                                        (f"its remainder after {n} steps", "-R", bits)])]


def sine_and_cosine(steps):
    n, bits, unit = steps.last_of_sine(), steps.bits, steps.unit
    allowed = 2 ** (bits - steps.promised_bits())
    proofs = []
    for name, more in (("c", -1), ("s", 1)):
        lines = [f"q = {unit}(a * a);", "Q = a * a;", f"{name}{n + 2} = 1;", f"{name.upper()}{n + 2} = 1;"]
        for k in range(n, 0, -2):
            lines += [f"{name}{k} = 1 - {unit}({unit}(q * {name}{k + 2}) / {k * (k + more)});",
                      f"{name.upper()}{k} = 1 - Q * {name.upper()}{k + 2} / {k * (k + more)};"]
        lines += ["y = c2;", "Y = C2 + R;"] if name == "c" else [f"y = {unit}(a * s2);", "Y = a * S2 + R;"]
        rest = (PI / 2) ** (n + 2) / math.factorial(n + 2)
        proofs.append(Proof(lines, [f"a in {between(0, PI / 2)}", f"R in {between(-rest, rest)}"], "y - Y",
                            -allowed, allowed, bits,
                            [f"y - Y -> ({'c2 - C2' if name == 'c' else 'y - a * S2'}) - R;"],
                            parts=[("the square of the angle", "q - Q", bits),
                                   (f"the remainder of the series after x^{n + 1}", "R", bits + 16)]))
    return proofs


def precise_power(source):
    return power_of_two(Precise(source))


def precise_logarithm(source):
    return logarithm(Precise(source))


def precise_arctangent(source):
    return arctangent(Precise(source))


def precise_sine(source):
    return sine_and_cosine(Precise(source))


def precise_phase(source):
    """The rest of an angle of up to 2^32 radians in quarter turns; degrees and turns are nearer."""
    bits = source.read("phase.hpp", r"The error of the rest is below 2\^-(\d+)")
    steps = Precise(source)
    word, off = steps.constant("2_over_pi", 2 / PI)
    word, off = word.replace("2_over_pi", "f"), off.replace("2_OVER_PI", "F")
    pi_word, pi_off = steps.constant("pi", PI)
    # q - w is the part in a quarter turn, for the whole number w.
    lines = [word, pi_word, f"q = {steps.unit}(x * f);", f"h = {steps.unit}(0.5 * pi);",
             f"y = {steps.unit}((q - w) * h);", "Y = (x * F - w) * (0.5 * PI);"]
    hint = "y - Y -> (y - (q - w) * h) + (q - w) * (h - 0.5 * PI) + ((q - x * f) + x * (f - F)) * (0.5 * PI);"
    parts = [("2/pi, times the angle", "x * (f - F)", 153), ("the product, rounded down", "q - x * f", 184),
             ("pi/2", "h - 0.5 * PI", 184), ("the product with pi/2, rounded down", "y - (q - w) * h", 184)]
    return [Proof(lines, ["x in [-1b32,1b32]", "q - w in [0,1]", off, pi_off], "y - Y",
                  -(2 ** (153 - bits)), 2 ** (153 - bits), 153, [hint], parts=parts)]


def short_power(source):
    return power_of_two(Short(source))


def short_logarithm(source):
    return logarithm(Short(source))


def short_arctangent(source):
    return arctangent(Short(source))


def short_sine(source):
    return sine_and_cosine(Short(source))


def short_part_off(source, fraction_bits):
    """The part of a quarter turn of up to 2^32 ulps of radians: a product and a shift, each rounded down. Degrees are
    rounded down once, and turns are exact."""
    unit = Fraction(1, 2**Short.bits)
    constant = abs(Fraction(Short(source).word("2_over_pi"), 2**Short.constant_bits) - 2 / PI)
    return (2**32 * constant + unit) / 2**fraction_bits + unit


def short_phase(source):
    """Both errors are largest, times 2^F, in the formats at the ends."""
    whole, places = source.read(DIGIT_PHASE, r"error of the part is below 2\^\((\d+) - fraction_bits - (\d+)\)")
    bits = places - whole
    off = max(short_part_off(source, f) * 2**f for f in range(33)) * 2**bits
    return [Exact("the part of a quarter turn, times 2^F", -off, off, bits, (-1, 1))]
