"""The bounds that the code passes to nearest_within(), for each function, from those of the parts."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_10, LOG_2, PI, NotProven, Proof, between, near, within
from bounds.parts import (ARCSINE, ARCTANGENT, COSINE, EXPONENTIAL, PHASE, cosine, logarithm_terms, phase_error,
                          power_terms)

HYPERBOLIC, POWER = "hyperbolic.hpp", "power.hpp"

# (2^d - 1) / d for 0 < d < 2^-10 is between log(2) and this.
GROWTH = LOG_2 * (1 + Fraction(1, 2**10))


def power_given(low):
    """The code's y for the power Y of the exponent that the code has."""
    return ["y in [1,2]", "Y in [1,2]", f"y - Y in [-{low}b-63,0]"]


def exponent_range(source):
    """power_within() takes exponents from here on as they are. Above, results are out of range, and below less than 1/4."""
    highest = source.read(EXPONENTIAL, r"highest = (\d+);")
    lowest = source.read(EXPONENTIAL, r"lowest = -(\d+);")
    if lowest < 2 or highest < 34:
        raise NotProven("a result in range is changed")
    return max(highest, 32 + lowest)


def power_within(source):
    """2^e for an exponent that is off by up to `error` units of 2^-64, any number of them up to 2^53."""
    shift, quarter, bits = source.read(
        EXPONENTIAL, r"power_of_two<Terms>\(fraction\) >> (\d+)\).*?nearest_within\(power, error / (\d+) \+ own_error, (\d+) - place")
    quick, exact = source.read(EXPONENTIAL, r"own_error = Terms == quick_power_terms \? (\d+) : (\d+);")
    if (shift, quarter, bits) != (2, 4, 61):
        raise NotProven("power_within() has other units")
    proofs = []
    for (_, low), more in zip(power_terms(source), (exact, quick)):
        # The exact power is Y (1 + k e).
        for sign, k in (("-", f"k in {between(0, GROWTH)}"), ("+", f"k in {between(-GROWTH, 0)}")):
            lines = ["v = fixed<-61,dn>(y);", "q = fixed<0,dn>(0.25 * e);", "W = Y + Y * (k * (e * 1b-64));"]
            error = f"(v - W) {'+' if sign == '-' else '-'} (q + {more}) * 1b-61"
            inverse = "+" if sign == "-" else "-"
            hint = (f"{error} -> (v - y) + (y - Y) + e * (({inverse}0.25 * 1b-61) - Y * k * 1b-64) "
                    f"{inverse} (q - 0.25 * e) * 1b-61 {inverse} {more}b-61;")
            least, most = (0, 2**80) if sign == "-" else (-2**80, 0)
            proofs.append(Proof(lines, [*power_given(low), "e in [0,1b53]", k], error, least, most, 61, [hint]))
    return proofs


def exponential(source):
    """x log2(e) for |x| up to where results are out of range."""
    units = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    highest = (exponent_range(source) + Fraction(1, 2**20)) * LOG_2
    return [exponent(source, sign, highest, units) for sign in "+-"]


def exponent(source, sign, highest, units):
    """Of e^x, or of e^-x, for x >= 0."""
    word = source.word("log2_e")
    lines = ["e = fixed<-64,dn>(x * l);"] if sign == "+" else ["e = fixed<-64,dn>(-(x * l));"]
    given = [f"x in {between(0, highest)}", within("L", word, 63, LOG2_E), f"l = {word}b-63"]
    error, hint = (("e - x * L", "e - x * L -> (e - x * l) + x * (l - L);") if sign == "+"
                   else ("e + x * L", "e + x * L -> (e + x * l) - x * (l - L);"))
    low, high = (-units, 0) if sign == "+" else (-1, units)
    hints = [hint] if sign == "+" else [hint, "e + x * l -> e - (-(x * l));"]
    return Proof(lines, given, error, low, high, 64, hints)


def logarithm(source):
    divisor, more, bits = source.read(EXPONENTIAL, r"error = logarithm_error<Terms> / (\d+) \+ (\d+); return nearest_within\(value, error, (\d+) -",
                                      "constexpr nearest_ends logarithm_within")
    proofs = []
    for _, off in logarithm_terms(source)[:2]:
        units = off // divisor + more
        for scale in (LOG_2, LOG_2 / LOG_10):
            whole = math.floor(scale * 2 ** (bits + 1) + 1) >> 1
            part = math.floor(scale * 2**64)
            lines = [f"w = {whole}b-{bits};", f"s = {part}b-64;", f"t = fixed<-{bits},dn>(fixed<-64,dn>(f * s));"]
            given = ["n in [-32,32]", "f in [0,1]", f"f - F in [-{off}b-64,{off}b-64]", "F in [-0.1,1.1]",
                     within("S", whole, bits, scale), f"s - S in {between(Fraction(part, 2**64) - scale, Fraction(part, 2**64) - scale)}"]
            proofs.append(Proof(lines, given, "(n * w + t) - (n + F) * S", -units, units, bits,
                                ["(n * w + t) - (n + F) * S -> n * (w - S) + (t - f * s) + f * (s - S) + (f - F) * S;"]))
        proofs.append(Proof([f"t = fixed<-{bits},dn>(f);"], ["f in [0,1]", f"f - F in [-{off}b-64,{off}b-64]"],
                            "(n + t) - (n + F)", -units, units, bits, ["(n + t) - (n + F) -> (t - f) + (f - F);"]))
    return proofs


def falling_off(source):
    """The error with all terms and with few."""
    return (source.read(HYPERBOLIC, r"The error is below (\d+) units", "e^-y for y"),
            source.read(HYPERBOLIC, r"quick_power_terms below (\d+)\.", "e^-y for y"))


def falling_exponential(source):
    """e^-x for x > 0 is T. The code has T + M, because its exponent is too high by up to 2x units of 2^-64, or too
    low by up to 1. 2 x e^-x is at most 2/e < 0.74."""
    exponents = exponent(source, "-", 27, 1)
    exponents.error = "(e + x * L) - 2 * x * 1b-64"
    exponents.low, exponents.high = Fraction(-(2**70)), Fraction(0)
    exponents.hints = [f"{exponents.error} -> (e - (-(x * l))) - x * ((l - L) + 1b-63);"]
    proofs = [exponents]
    for (_, low), units in zip(power_terms(source), falling_off(source)):
        lines = ["t = fixed<-62,dn>(y * h);", "T = Y * h - M;"]
        given = [*power_given(low), "h in [0,0.5]", f"M in {between(-GROWTH / 2**64, Fraction('0.74') * GROWTH / 2**64)}"]
        proofs.append(Proof(lines, given, "t - T", -units, units, 62, ["t - T -> (t - y * h) + (y - Y) * h + M;"]))
    return proofs


def sinh_and_cosh(source):
    quick, exact, bits = source.read(HYPERBOLIC, r"error = Terms == quick_power_terms \? (\d+) : (\d+); return nearest_within\(value, error, (\d+) - whole",
                                     "hyperbolic_within")
    off = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    proofs = []
    for (_, low), falling, units in zip(power_terms(source), falling_off(source), (exact, quick)):
        for sign in "-+":
            lines = [f"r = fixed<-{bits},dn>(0.5 * y);", "U = 0.5 * Y + 0.5 * Y * k;", f"d = fixed<-{bits},dn>(t * h);"]
            given = [*power_given(low), f"k in {between(0, off * GROWTH / 2**64)}", "h in [0,0.5]",
                     f"t - T in [-{falling}b-62,{falling}b-62]"]
            error = f"(r {sign} d) - (U {sign} T * h)"
            proofs.append(Proof(lines, given, error, -units, units, bits,
                                [f"{error} -> (r - 0.5 * y) + 0.5 * (y - Y) - 0.5 * Y * k {sign} ((d - t * h) + (t - T) * h);"]))
    return proofs


def tanh(source):
    units, bits = source.read(HYPERBOLIC, r"error = (\d+); const nearest_ends ends = nearest_within\(value, error, (\d+) - fraction_bits",
                              "nearest_hyperbolic_tangent")
    falling, quick_falling = falling_off(source)
    flat = source.read(HYPERBOLIC, r"flat = std::int64_t\{(\d+)\} << 32")
    # Beyond, the distance from 1 is below 2 e^(-2 flat), less than half a unit of 2^-32.
    if 2 * sum(Fraction(2 * flat) ** n / math.factorial(n) for n in range(120)) ** -1 >= Fraction(1, 2**33):
        raise NotProven("tanh is not flat")
    lines = [f"v = fixed<-{bits},dn>((1 - t) / (1 + t));", "V = (1 - T) / (1 + T);"]
    given = ["t in [0,1]", "T in [0,1]", f"t - T in [-{falling}b-62,{falling}b-62]"]
    quick_units, quick_bits = source.read(HYPERBOLIC, r"quick_error = (\d+); .*?nearest_within\(quick, quick_error, (\d+) - fraction_bits")
    quick_lines = ["c = fixed<-31,dn>(1 + t);", f"v = fixed<-{quick_bits},dn>((1 - t) / c);", "V = (1 - T) / (1 + T);"]
    quick_given = [*given[:2], f"t - T in [-{quick_falling}b-62,{quick_falling}b-62]"]
    return [Proof(lines, given, "v - V", -units, units, bits,
                  ["v - V -> (v - (1 - t) / (1 + t)) - 2 * (t - T) / ((1 + t) * (1 + T));"]),
            Proof(quick_lines, quick_given, "v - V", -quick_units, quick_units, quick_bits,
                  ["v - V -> (v - (1 - t) / c) + (1 - t) * ((1 + t) - c) / (c * (1 + t)) - 2 * (t - T) / ((1 + t) * (1 + T));"])]


def sine_off(source):
    bits = source.read(PHASE, r"The error is below 2\^-(\d+)\.", "The magnitude of the sine of a phase")
    if bits != source.read(COSINE, r"The error is below 2\^-(\d+) even if"):
        raise NotProven("the sine is better than the cosine")
    return bits


def sine(source):
    """The sine of a phase is that of cosine(), whose error must be below the constant, not equal to it: 1/2 is a
    tie of degrees."""
    units, bits = source.read(PHASE, r"error = (\d+); const nearest_ends ends = nearest_within\(sine, error, (\d+) -", "nearest_sine_of")
    if bits != 62 or sine_off(source) < 56:
        raise NotProven("the sine has other units")
    (proof,) = cosine(source)
    proof.low, proof.high = Fraction(1 - units), Fraction(units - 1)
    # A quick sine rounds the phase to 31 bits of a quarter turn.
    allowed = source.read("radian.hpp", r"even if d is 0\.(\d\d) units off")
    if Fraction(1, 2) + phase_error(source) * 4 / 2**33 > Fraction(allowed, 100):
        raise NotProven("a quick sine takes a phase that is off by more")
    return [proof]


def distance_from_pole():
    """The least distance of an angle of up to 2^32 ulps from an odd number of quarter turns, in radians; in degrees
    and turns it is at least 2^-32 degrees."""
    least = PI / 180 / 2**32
    for fraction_bits in range(33):
        quarter = PI / 2 * 2**fraction_bits
        # Convergents p/q of a quarter turn in ulps: |q quarter - p| is least at the last with p up to 2^32.
        x, (p, q), (p1, q1) = quarter, (1, 0), (0, 1)
        while True:
            whole = math.floor(x)
            (p, q), (p1, q1) = (whole * p + p1, whole * q + q1), (p, q)
            if p > 2**32:
                break
            least = min(least, abs(q * quarter - p) / 2**fraction_bits)
            x = 1 / (x - whole)
    return least


def tangent(source):
    """t = a/b for a and b that are off by up to e of tangent_of_phase(), of which one is at least 0.96; units are
    e' = e 2^-62. |t - A/B| <= e' (1 + A/B) / b. As a or b is at least 0.96, 1/b is at most (1 + t) / 0.96, and 1 + A/B
    is at most (1 + t) (1 + 2e' / (b - e')). Exact, without Gappa."""
    source.read(PHASE, r"d > 0\.(96)\.", "The tangent of a phase")
    units, _ = source.read(PHASE, r"below (\d+) units even if the phase is (\d+) units off", "The tangent of a phase")
    more, factor, bits = source.read(
        PHASE, r"tangent >> 62\) \+ (\d); .*?int128\{(\d+) \* bound\} \* int128\{bound\}, (\d+) -", "careful_tangent")
    least = source.read(PHASE, r"b >> (\d+) != 0", "careful_tangent")
    if more != 2 or bits != 62:
        raise NotProven("careful_tangent() has other units")
    # tan(c) tan(z) is at most the tangent of 31/64 of a quarter turn times 1/40.
    if 1 - Fraction(source.table("tangents")[-2], 2**62) / 40 < Fraction(96, 100):
        raise NotProven("d may be smaller")

    def grown(least):
        e = Fraction(units, 2**62)
        return units / Fraction(96, 100) * (1 + 2 * e / (Fraction(2**least, 2**62) - e))

    # The quotient is rounded by less than a unit, and `bound` is at least 2 and 1 + t.
    if 4 * grown(least) + 1 > 4 * factor:
        raise NotProven("tangent: the factor is too small")
    # A quick one divides by b' > b - 2^31 units, so it is up to t 2^31 / b' higher.
    low, shift, quick_more, quick_factor, quick_bits = source.read(
        PHASE, r"b >> (\d+) != 0.*?\(b >> (\d+)\)\); .*?quick >> 32\) \+ (\d); .*?nearest_within\(quick, (\d+) \* bound \* bound, (\d+) -", "constexpr std::int64_t nearest_tangent")
    if (shift, quick_more, quick_bits) != (31, 2, 32):
        raise NotProven("nearest_tangent() has other units")
    lost = 2 / Fraction(96, 100) / (1 - Fraction(2**shift, 2**low))
    if 4 * (lost + grown(low) / 2**30) + 1 > 4 * quick_factor:
        raise NotProven("tangent: the quick factor is too small")
    # A phase is on the right side of every pole.
    if distance_from_pole() / (2 * PI) <= Fraction(units, 2**62):
        raise NotProven("tangent: the sign may be wrong")
    return []


def turned(source, bits=58):
    """What the octants add: pi - (pi/2 - angle), with pi in units of 2^-bits."""
    pi = source.word("pi_58") >> (58 - bits)
    half = pi >> 1
    return max(abs(n - exact * 2**bits) for n, exact in ((half, PI / 2), (pi, PI), (pi - half, PI / 2)))


def angle(source):
    units, bits = source.read(ARCTANGENT, r" error = (\d+); const nearest_ends ends = nearest_within\(angle, error, (\d+) -")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    given = [f"a - A in [-{off}b-58,{off}b-58]", near("q", Fraction(0), turned(source) / 2**58)]
    return [Proof([], given, "(a + q) - A", -units, units, bits, ["(a + q) - A -> (a - A) + q;"])]


def quick_angle(source):
    units, bits = source.read(ARCTANGENT, r"quick_error = (\d+); .*?nearest_within\(quick, quick_error \+ more, (\d+) -")
    shift = source.read(ARCTANGENT, r"pi_58 >> (\d+)\)")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-32")
    if bits != 58 - shift:
        raise NotProven("pi has other units")
    given = [f"a - A in [-{off}b-{bits},{off}b-{bits}]", near("q", Fraction(0), turned(source, bits) / 2**bits)]
    return [Proof([], given, "(a + q) - A", -units, units, bits, ["(a + q) - A -> (a - A) + q;"])]


def triangle(source):
    """The vector (c, o) for the exact (c, O) of length 1: the angle moves by (o - O) k, |k| <= 1 / (c^2 + o^2)."""
    units, bits = source.read(ARCSINE, r"error = (\d+); const nearest_ends ends = nearest_within\(angle, error, (\d+) -")
    side = source.read(ARCSINE, r"constexpr int bits = (\d+);")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    root = source.read(ARCSINE, r"The error is below (\d+) units")
    # The root's units are at most 2^-63 of the longest side: 31 bits, and 32 of the longest side at least.
    lines = [f"o = fixed<-{side},dn>(r);"]
    given = ["k in [-1.0001,1.0001]", f"r - O in [-{root}b-63,{root}b-63]", f"a - A in [-{off}b-58,{off}b-58]",
             near("q", Fraction(0), turned(source) / 2**58)]
    error = "(a + q) - (A - (o - O) * k)"
    return [Proof(lines, given, error, -units, units, bits,
                  [f"{error} -> (a - A) + q + ((o - r) + (r - O)) * k;"])]


def quick_triangle(source):
    """As triangle(), with the sides in units of 2^-32: what moves the vector is below `more`."""
    more = source.read(ARCSINE, r"quick_angle_within\(part, fraction_bits, (\d+)\)")
    hundredths = source.read(ARCSINE, r"off by less than 1\.0(\d) units", "in units of 2^-shift")
    off = 1 + Fraction(hundredths, 100)
    given = ["k in [-1.0001,1.0001]", f"o - O in {between(-off / 2**32, off / 2**32)}"]
    return [Proof([], given, "(o - O) * k", -more, more, 32)]


def power(source):
    """The exponent: y times the logarithm. The bound is a multiple of |y|; y and -y differ in the rounding only. A
    quick logarithm loses bits first."""
    added = source.read(POWER, r"is_quick \? (\d+) : 0\);")
    more = source.read(POWER, r"log_error >> fraction_bits\) \+ (\d+);")
    quick_bits = source.read(POWER, r"bits = is_quick \? (\d+) : 64;")
    exact, _, quick = logarithm_terms(source)
    proofs = []
    for log, off, bits in ((exact[1], exact[1], 64), (quick[1], quick[1] + added, quick_bits)):
        for sign in "+-":
            rounding = "dn" if sign == "+" else "up"
            lines = [f"l = fixed<-{bits},dn>(m);", f"e = fixed<-64,{rounding}>(l * y);", f"q = fixed<0,dn>({off} * y);"]
            lost = 1 if bits == 64 else 2 ** (64 - bits)
            given = ["y in [0,1b31]", "m in [-32,33]", f"m - M in [-{log}b-64,{log}b-64]"]
            if bits == 64:
                lines[0] = "l = m;"
            for side, low, high in (("-", -2**80, 0), ("+", 0, 2**80)):
                error = f"(e - M * y) {side} (q + {more}) * 1b-64"
                hint = (f"{error} -> (e - l * y) + y * (((l - m) + (m - M)) {side} {off}b-64) {side} (q - {off} * y) * 1b-64 "
                        f"{side} {more}b-64;")
                proofs.append(Proof(lines, given, error, low, high, 64, [hint]))
            if lost > added and bits != 64:
                raise NotProven("a quick logarithm loses more")
    return proofs
