"""The bounds that the code passes to nearest_within(), for each function, from those of the parts."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_10, LOG_2, PI, Exact, NotProven, Proof, between, near, of_constant, within
from bounds.parts import (ARCSINE, ARCTANGENT, COSINE, EXPONENTIAL, PHASE, cosine, few_terms, in_large_units,
                          logarithm_terms, phase_error, power_terms)

HYPERBOLIC, POWER = "hyperbolic.hpp", "power.hpp"

# (2^d - 1) / d for 0 < d < 2^-10 is between log(2) and this.
GROWTH = LOG_2 * (1 + Fraction(1, 2**10))


def power_given(low):
    """The code's y for the power Y of the exponent that the code has."""
    return ["y in [1,2]", "Y in [1,2]", f"y - Y in [-{low}b-63,0]"]


def exponent_range(source):
    """power_within() takes exponents from here on as they are. Above, results are out of range, and below less than
    1/4."""
    highest = source.read(EXPONENTIAL, r"highest = (\d+);")
    lowest = source.read(EXPONENTIAL, r"lowest = -(\d+);")
    if lowest < 2 or highest < 34:
        raise NotProven("a result in range is changed")
    return max(highest, 32 + lowest)


def power_within(source):
    """2^e for an exponent that is off by up to `error` units of 2^-64, any number of them up to 2^54."""
    shift, quarter, bits = source.read(
        EXPONENTIAL, r"power_of_two<Terms>\(fraction\) >> (\d+)\)"
                     r".*?nearest_within\(power, error / (\d+) \+ own_error, (\d+) - place")
    quick, exact = source.read(EXPONENTIAL, r"own_error = Terms == quick_power_terms \? (\d+) : (\d+);")
    if (shift, quarter, bits) != (2, 4, 61):
        raise NotProven("power_within() has other units")
    proofs = []
    for (terms, low), more in zip(power_terms(source), (exact, quick)):
        few = few_terms(terms, "power_coefficients", source)
        # The exact power is Y (1 + k e).
        for sign, k in (("-", f"k in {between(0, GROWTH)}"), ("+", f"k in {between(-GROWTH, 0)}")):
            lines = ["v = fixed<-61,dn>(y);", "q = fixed<0,dn>(0.25 * e);", "W = Y + Y * (k * (e * 1b-64));"]
            error = f"(v - W) {'+' if sign == '-' else '-'} (q + {more}) * 1b-61"
            inverse = "+" if sign == "-" else "-"
            hint = (f"{error} -> (v - y) + (y - Y) + e * (({inverse}0.25 * 1b-61) - Y * k * 1b-64) "
                    f"{inverse} (q - 0.25 * e) * 1b-61 {inverse} {more}b-61;")
            least, most = (0, 2**80) if sign == "-" else (-2**80, 0)
            parts = [(few + "the power of the code's exponent", "y - Y", 61), ("its shift", "v - y", 61),
                     ("e/4, rounded down", "q * 1b-61 - 0.25 * e * 1b-61", 61)]
            proofs.append(Proof(lines, [*power_given(low), "e in [0,1b54]", k], error, least, most, 61, [hint],
                                name=few + "sum", parts=parts, grows=("e/4", more, -1 if sign == "-" else 1)))
    return proofs


def exponential(source):
    """x log2(e) for |x| up to where results are out of range."""
    units = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    highest = (exponent_range(source) + Fraction(1, 2**20)) * LOG_2
    return [of_constant("log2(e)", source.word("log2_e"), 63, LOG2_E),
            *(exponent(source, sign, highest, units) for sign in "+-")]


def exponent(source, sign, highest, units):
    """Of e^x, or of e^-x, for x >= 0."""
    word = source.word("log2_e")
    lines = ["e = fixed<-64,dn>(x * l);"] if sign == "+" else ["e = fixed<-64,dn>(-(x * l));"]
    given = [f"x in {between(0, highest)}", within("L", word, 63, LOG2_E), f"l = {word}b-63"]
    error, effect = ("e - x * L", "x * (l - L)") if sign == "+" else ("e + x * L", "-(x * (l - L))")
    rounding = "e - x * l" if sign == "+" else "e - (-(x * l))"
    low, high = (-units, 0) if sign == "+" else (-1, units)
    parts = [("log2(e), times x", effect, 64), ("the product, rounded down", rounding, 64)]
    return Proof(lines, given, error, low, high, 64, [f"{error} -> ({rounding}) + {effect};"],
                 name="x > 0: sum" if sign == "+" else "x < 0: sum", parts=parts)


def logarithm(source):
    divisor, more, bits = source.read(
        EXPONENTIAL, r"error = logarithm_error<Terms> / (\d+) \+ (\d+); return nearest_within\(value, error, (\d+) -",
        "constexpr nearest_ends logarithm_within")
    proofs = []
    for terms, off in logarithm_terms(source)[:2]:
        few_of = few_terms(terms, "logarithm_coefficients", source).replace(":", ",")
        units = off // divisor + more
        for base, scale in (("e", LOG_2), ("10", LOG_2 / LOG_10)):
            whole = math.floor(scale * 2 ** (bits + 1) + 1) >> 1
            part = math.floor(scale * 2**64)
            lines = [f"w = {whole}b-{bits};", f"s = {part}b-64;", f"t = fixed<-{bits},dn>(fixed<-64,dn>(f * s));"]
            short = between(Fraction(part, 2**64) - scale, Fraction(part, 2**64) - scale)
            given = ["n in [-32,32]", "f in [0,1]", f"f - F in [-{off}b-64,{off}b-64]", "F in [-0.1,1.1]",
                     within("S", whole, bits, scale), f"s - S in {short}"]
            hint = "(n * w + t) - (n + F) * S -> n * (w - S) + (t - f * s) + f * (s - S) + (f - F) * S;"
            parts = [(f"base {base}: the scale, times the whole exponent", "n * (w - S)", bits),
                     (f"base {base}: the scale, times the logarithm of m", "f * (s - S)", bits),
                     (f"{few_of}base {base}: the logarithm of m, times the scale", "(f - F) * S", bits),
                     (f"base {base}: the product, rounded down and shifted", "t - f * s", bits)]
            proofs.append(Proof(lines, given, "(n * w + t) - (n + F) * S", -units, units, bits, [hint],
                                name=f"{few_of}base {base}: sum", parts=parts))
        proofs.append(Proof([f"t = fixed<-{bits},dn>(f);"], ["f in [0,1]", f"f - F in [-{off}b-64,{off}b-64]"],
                            "(n + t) - (n + F)", -units, units, bits, ["(n + t) - (n + F) -> (t - f) + (f - F);"],
                            name=f"{few_of}base 2: sum",
                            parts=[(f"{few_of}base 2: the logarithm of m", "f - F", bits),
                                   ("base 2: its shift", "t - f", bits)]))
    return proofs


def falling_off(source):
    """The error with all terms and with few."""
    return (source.read(HYPERBOLIC, r"The error is below (\d+) units", "e^-y for y"),
            source.read(HYPERBOLIC, r"quick_power_terms below (\d+)\.", "e^-y for y"))


def falling_exponential(source):
    """e^-x for x > 0 is T. The code has T + M, because its exponent is too high by up to 2x units of 2^-64, or too
    low by up to 1. 2 x e^-x is at most 2/e < 0.74."""
    highest = 27
    whole, growing = (exponent(source, "-", highest, 2 * highest) for _ in "12")
    whole.name, whole.parts = f"the exponent of e^-y, for y up to {highest}", ()
    growing.error = "(e + x * L) - 2 * x * 1b-64"
    growing.low, growing.high = Fraction(-2 * highest - 1), Fraction(0)
    growing.hints = [f"{growing.error} -> (e - (-(x * l))) - x * ((l - L) + 1b-63);"]
    growing.name, growing.parts = "the same, less 2y", ()
    proofs = [whole, growing]
    for (terms, low), off in zip(power_terms(source), falling_off(source)):
        few = few_terms(terms, "power_coefficients", source)
        lines = ["t = fixed<-62,dn>(y * h);", "T = Y * h - M;"]
        given = [*power_given(low), "h in [0,0.5]",
                 f"M in {between(-GROWTH / 2**64, Fraction('0.74') * GROWTH / 2**64)}"]
        units, bits = in_large_units(off, 62)
        parts = [("the effect of that error on e^-y", "M", 62),
                 (few + "the power of the code's exponent", "(y - Y) * h", 62), ("its shift", "t - y * h", 62)]
        proofs.append(Proof(lines, given, "t - T", -units, units, bits, ["t - T -> (t - y * h) + (y - Y) * h + M;"],
                            name=few + "sum", parts=parts))
    return proofs


def sinh_and_cosh(source):
    quick, exact, bits = source.read(
        HYPERBOLIC, r"error = Terms == quick_power_terms \? (\d+) : (\d+); "
                    r"return nearest_within\(value, error, (\d+) - whole", "hyperbolic_within")
    off = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    proofs = []
    for (terms, low), falling, units in zip(power_terms(source), falling_off(source), (exact, quick)):
        few = few_terms(terms, "power_coefficients", source)
        for name, sign in (("sinh", "-"), ("cosh", "+")):
            lines = [f"r = fixed<-{bits},dn>(0.5 * y);", "U = 0.5 * Y + 0.5 * Y * k;", f"d = fixed<-{bits},dn>(t * h);"]
            given = [*power_given(low), f"k in {between(0, off * GROWTH / 2**64)}", "h in [0,0.5]",
                     f"t - T in [-{falling}b-62,{falling}b-62]"]
            error = f"(r {sign} d) - (U {sign} T * h)"
            parts = [(few + "the power of the code's exponent, for e^x / 2", "0.5 * (y - Y)", bits),
                     ("its shift", "r - 0.5 * y", bits),
                     ("the exponent of e^x", "-0.5 * Y * k", bits), (few + "e^-x / 2", "(t - T) * h", bits),
                     ("its shift to the unit of e^x", "d - t * h", bits)]
            hint = (f"{error} -> (r - 0.5 * y) + 0.5 * (y - Y) - 0.5 * Y * k "
                    f"{sign} ((d - t * h) + (t - T) * h);")
            proofs.append(Proof(lines, given, error, -units, units, bits, [hint],
                                name=f"{few.replace(':', ',')}{name}: sum", parts=parts))
    return proofs


def tanh(source):
    units, bits = source.read(
        HYPERBOLIC, r"error = (\d+); const nearest_ends ends = nearest_within\(value, error, (\d+) - fraction_bits",
        "nearest_hyperbolic_tangent")
    falling, _ = falling_off(source)
    flat = source.read(HYPERBOLIC, r"flat = std::int64_t\{(\d+)\} << 32")
    # Beyond, the distance from 1 is below 2 e^(-2 flat), less than half a unit of 2^-32.
    distance = 2 * sum(Fraction(2 * flat) ** n / math.factorial(n) for n in range(120)) ** -1
    lines = [f"v = fixed<-{bits},dn>((1 - t) / (1 + t));", "V = (1 - T) / (1 + T);"]
    given = ["t in [0,1]", "T in [0,1]", f"t - T in [-{falling}b-62,{falling}b-62]"]
    parts = [("t = e^(-2x)", "t - T", bits), ("its effect on the quotient", "-2 * (t - T) / ((1 + t) * (1 + T))", bits),
             ("the quotient, rounded down", "v - (1 - t) / (1 + t)", bits)]
    return [Exact(f"1 in place of tanh x, from x = {flat} on", 0, distance * 2**32, 32, (None, Fraction(1, 2))),
            Proof(lines, given, "v - V", -units, units, bits,
                  ["v - V -> (v - (1 - t) / (1 + t)) - 2 * (t - T) / ((1 + t) * (1 + T));"], parts=parts)]


def quick_tanh(source):
    """As tanh(), with few terms and a divisor c of 32 bits."""
    units, bits = source.read(
        HYPERBOLIC, r"quick_error = (\d+); .*?nearest_within\(quick, quick_error, (\d+) - fraction_bits")
    _, falling = falling_off(source)
    lines = ["c = fixed<-31,dn>(1 + t);", f"v = fixed<-{bits},dn>((1 - t) / c);", "V = (1 - T) / (1 + T);"]
    given = ["t in [0,1]", "T in [0,1]", f"t - T in [-{falling}b-62,{falling}b-62]"]
    shortened, effect = "(1 - t) * ((1 + t) - c) / (c * (1 + t))", "2 * (t - T) / ((1 + t) * (1 + T))"
    parts = [("t = e^(-2x)", "t - T", 41), ("its effect on the quotient", f"-({effect})", 41),
             ("the divisor, rounded down", "c - (1 + t)", 31), ("its effect on the quotient, too", shortened, bits),
             ("the quotient, rounded down", "v - (1 - t) / c", bits)]
    return [Proof(lines, given, "v - V", -units, units, bits,
                  [f"v - V -> (v - (1 - t) / c) + {shortened} - {effect};"], parts=parts)]


def sine_off(source):
    bits = source.read(PHASE, r"The error is below 2\^-(\d+)\.", "The magnitude of the sine of a phase")
    if bits != source.read(COSINE, r"The error is below 2\^-(\d+) even if"):
        raise NotProven("the sine is better than the cosine")
    return bits


def proof_of_cosine(source, units):
    """The proof that a cosine is off by less than `units`, without its parts."""
    proof = cosine(source)[-1]
    proof.low, proof.high, proof.parts = Fraction(1 - units), Fraction(units - 1), ()
    return proof


def sine(source):
    """The sine of a phase is that of cosine(), whose error must be below the constant, not equal to it: 1/2 is a
    tie of degrees."""
    units, bits = source.read(
        PHASE, r"error = (\d+); const nearest_ends ends = nearest_within\(sine, error, (\d+) -", "nearest_sine_of")
    if bits != 62 or sine_off(source) < 56:
        raise NotProven("the sine has other units")
    # A quick sine rounds the phase to 31 bits of a quarter turn.
    hundredths = source.read("radian.hpp", r"even if d is 0\.(\d\d) units off")
    rounded, allowed = Fraction(1, 2) + phase_error(source) / 2**31, Fraction(hundredths, 100)
    return [proof_of_cosine(source, units),
            Exact("a quick sine's phase, rounded to d", -rounded, rounded, 33, (-allowed, allowed))]


def turned(source, bits=58):
    """What the octants add: pi - (pi/2 - angle), with pi in units of 2^-bits."""
    pi = source.word("pi_58") >> (58 - bits)
    half = pi >> 1
    return max(abs(n - exact * 2**bits) for n, exact in ((half, PI / 2), (pi, PI), (pi - half, PI / 2)))


def angle(source):
    units, bits = source.read(
        ARCTANGENT, r" error = (\d+); const nearest_ends ends = nearest_within\(angle, error, (\d+) -")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    given = [f"a - A in [-{off}b-58,{off}b-58]", near("q", Fraction(0), turned(source) / 2**58)]
    return [Proof([], given, "(a + q) - A", -units, units, bits, ["(a + q) - A -> (a - A) + q;"],
                  parts=[("the arctangent", "a - A", 58), ("pi, pi/2 or their difference", "q", 58)])]


def quick_angle(source):
    units, bits = source.read(
        ARCTANGENT, r"quick_error = (\d+); .*?nearest_within\(quick, quick_error \+ more, (\d+) -")
    shift = source.read(ARCTANGENT, r"pi_58 >> (\d+)\)")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-32")
    if bits != 58 - shift:
        raise NotProven("pi has other units")
    given = [f"a - A in [-{off}b-{bits},{off}b-{bits}]", near("q", Fraction(0), turned(source, bits) / 2**bits)]
    return [Proof([], given, "(a + q) - A", -units, units, bits, ["(a + q) - A -> (a - A) + q;"],
                  parts=[("the arctangent", "a - A", bits), ("pi, pi/2 or their difference", "q", bits)])]


def triangle(source):
    """The vector (c, o) for the exact (c, O) of length 1: the angle moves by (o - O) k, |k| <= 1 / (c^2 + o^2)."""
    units, bits = source.read(
        ARCSINE, r"error = (\d+); const nearest_ends ends = nearest_within\(angle, error, (\d+) -")
    side = source.read(ARCSINE, r"constexpr int bits = (\d+);")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    root = source.read(ARCSINE, r"The error is below (\d+) units")
    # The root's units are at most 2^-63 of the hypotenuse: 31 bits, and 32 of the hypotenuse at least.
    lines = [f"o = fixed<-{side},dn>(r);"]
    given = ["k in [-1.0001,1.0001]", f"r - O in [-{root}b-63,{root}b-63]", f"a - A in [-{off}b-58,{off}b-58]",
             near("q", Fraction(0), turned(source) / 2**58)]
    error = "(a + q) - (A - (o - O) * k)"
    parts = [("the root", "r - O", 63), ("the root, shifted to the unit of the sides", "o - r", side),
             ("the effect of both on the angle", "(o - O) * k", 58), ("the arctangent", "a - A", 58),
             ("pi, pi/2 or their difference", "q", 58)]
    return [Proof(lines, given, error, -units, units, bits,
                  [f"{error} -> (a - A) + q + ((o - r) + (r - O)) * k;", "(o - O) * k -> ((o - r) + (r - O)) * k;"],
                  parts=parts)]


def quick_triangle(source):
    """As triangle(), with the sides in units of 2^-32: what moves the vector is below `more`."""
    more = source.read(ARCSINE, r"quick_angle_within\(part, fraction_bits, (\d+)\)")
    hundredths = source.read(ARCSINE, r"off by less than 1\.0(\d) units", "in units of 2^-shift")
    off = 1 + Fraction(hundredths, 100)
    given = ["k in [-1.0001,1.0001]", f"o - O in {between(-off / 2**32, off / 2**32)}"]
    return [Proof([], given, "(o - O) * k", -more, more, 32, name="its effect on the angle",
                  parts=[("the root", "o - O", 32)])]


def power(source):
    """The exponent: y times the logarithm. The bound is a multiple of |y|; y and -y differ in the rounding only. A
    quick logarithm loses bits first."""
    added = source.read(POWER, r"is_quick \? (\d+) : 0\);")
    more = source.read(POWER, r"log_error >> fraction_bits\) \+ (\d+);")
    quick_bits = source.read(POWER, r"bits = is_quick \? (\d+) : 64;")
    exact, _, quick = logarithm_terms(source)
    proofs = []
    for (terms, log), added, bits in ((exact, 0, 64), (quick, added, quick_bits)):
        off = log + added
        few = few_terms(terms, "logarithm_coefficients", source)
        if 2 ** (64 - bits) > max(added, 1):
            raise NotProven("a quick logarithm loses more")
        for sign in "+-":
            rounding = "dn" if sign == "+" else "up"
            lines = [f"l = fixed<-{bits},dn>(m);" if few else "l = m;", f"e = fixed<-64,{rounding}>(l * y);",
                     f"q = fixed<0,dn>({off} * y);"]
            given = ["y in [0,1b32]", "m in [-32,33]", f"m - M in [-{log}b-64,{log}b-64]"]
            for side, low, high in (("-", -2**80, 0), ("+", 0, 2**80)):
                error = f"(e - M * y) {side} (q + {more}) * 1b-64"
                hint = (f"{error} -> (e - l * y) + y * (((l - m) + (m - M)) {side} {off}b-64) "
                        f"{side} (q - {off} * y) * 1b-64 {side} {more}b-64;")
                parts = [(few + "the logarithm", "m - M", 64), ("the product, rounded", "e - l * y", 64),
                         (f"{off} abs(y), rounded down", f"q * 1b-64 - {off} * y * 1b-64", 64)]
                if few:
                    parts.insert(1, (few + "its shift", "l - m", 64))
                proofs.append(Proof(lines, given, error, low, high, 64, [hint], name=few + "sum", parts=parts,
                                    grows=(f"{off} abs(y)", more, -1 if side == "+" else 1)))
    return proofs
