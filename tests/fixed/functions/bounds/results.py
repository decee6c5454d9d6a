"""The bounds that the code passes to nearest_within(), for each function, from those of the parts."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_10, LOG_2, PI, Exact, NotProven, Proof, between, near, of_constant, within
from bounds.parts import ARCSINE, ARCTANGENT, COSINE, EXPONENTIAL, PHASE, cosine

HYPERBOLIC, POWER = "hyperbolic.hpp", "power.hpp"

# (2^d - 1) / d for 0 < d < 2^-28 is between log(2) and this.
GROWTH = LOG_2 * (1 + Fraction(1, 2**28))


def power_given(source):
    """The code's y for the power Y of the exponent that the code has."""
    low = source.read(EXPONENTIAL, r"at most (\d+) units too low and never too high")
    return ["y in [1,2]", "Y in [1,2]", f"y - Y in [-{low}b-63,0]"]


def logarithm_off(source):
    return source.read(EXPONENTIAL, r"The error is below (\d+) units", "log2(m / 2^32) in units of 2^-64")


def exponent_range(source):
    """Above or below, nearest_power() says that the result is out of range or 0."""
    highest = source.read(EXPONENTIAL, r"highest = (\d+);")
    lowest = source.read(EXPONENTIAL, r"exponent.whole < -(\d+) - fraction_bits\) return 0")
    if lowest < 2:
        raise NotProven("a result that rounds up is called 0")
    return max(highest, 32 + lowest)


def nearest_power(source):
    """2^e for an exponent that is off by up to `error` units of 2^-64, any number of them up to 2^36."""
    shift, quarter, more, bits = source.read(
        EXPONENTIAL, r"power_of_two\(exponent.fraction\) >> (\d+)\)"
                     r".*?nearest_within\(power, error / (\d+) \+ (\d+), (\d+) - place")
    if (shift, quarter, bits) != (2, 4, 61):
        raise NotProven("nearest_power() has other units")
    proofs = []
    # The exact power is Y (1 + k e).
    for sign, k in (("-", f"k in {between(0, GROWTH)}"), ("+", f"k in {between(-GROWTH, 0)}")):
        lines = ["v = fixed<-61,dn>(y);", "q = fixed<0,dn>(0.25 * e);", "W = Y + Y * (k * (e * 1b-64));"]
        error = f"(v - W) {'+' if sign == '-' else '-'} (q + {more}) * 1b-61"
        inverse = "+" if sign == "-" else "-"
        hint = (f"{error} -> (v - y) + (y - Y) + e * (({inverse}0.25 * 1b-61) - Y * k * 1b-64) "
                f"{inverse} (q - 0.25 * e) * 1b-61 {inverse} {more}b-61;")
        low, high = (0, 2**80) if sign == "-" else (-2**80, 0)
        parts = [("the power of the code's exponent", "y - Y", 61), ("its shift", "v - y", 61),
                 ("e/4, rounded down", "q * 1b-61 - 0.25 * e * 1b-61", 61)]
        proofs.append(Proof(lines, [*power_given(source), "e in [0,1b36]", k], error, low, high, 61, [hint],
                            parts=parts, grows=("e/4", more, -1 if sign == "-" else 1)))
    return proofs


def exponential(source):
    """x log2(e) for |x| up to where results are out of range."""
    units = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    highest = (exponent_range(source) + Fraction(1, 2**20)) * LOG_2
    return [of_constant("log2(e)", source.word("log2_e"), 63, LOG2_E), exponent(source, highest, units)]


def exponent(source, highest, units):
    lines = ["e = fixed<-64,dn>(x * l);"]
    word = source.word("log2_e")
    given = [f"x in {between(0, highest)}", within("L", word, 63, LOG2_E), f"l = {word}b-63"]
    parts = [("log2(e), times x", "x * (l - L)", 64), ("the product, rounded down", "e - x * l", 64)]
    return Proof(lines, given, "e - x * L", -units, 0, 64, ["e - x * L -> (e - x * l) + x * (l - L);"], parts=parts)


def logarithm(source):
    off = logarithm_off(source)
    units, bits = source.read(
        EXPONENTIAL, r"error = (\d+); const nearest_ends ends = nearest_within\(value, error, (\d+) -",
        "constexpr std::int64_t nearest_logarithm")
    proofs = []
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
                 (f"base {base}: the logarithm of m, times the scale", "(f - F) * S", bits),
                 (f"base {base}: the product, rounded down and shifted", "t - f * s", bits)]
        proofs.append(Proof(lines, given, "(n * w + t) - (n + F) * S", -units, units, bits, [hint],
                            name=f"base {base}: sum", parts=parts))
    proofs.append(Proof([f"t = fixed<-{bits},dn>(f);"], ["f in [0,1]", f"f - F in [-{off}b-64,{off}b-64]"],
                        "(n + t) - (n + F)", -units, units, bits, ["(n + t) - (n + F) -> (t - f) + (f - F);"],
                        name="base 2: sum", parts=[("base 2: the logarithm of m", "f - F", bits),
                                                   ("base 2: its shift", "t - f", bits)]))
    return proofs


def falling_exponential(source):
    """e^-x for x > 0 is T. The code has T + M, because its exponent is too high by up to 2x + 1 units of 2^-64.
    (2x + 1) e^-x is at most 2 e^(-1/2) < 1.2131, because e^(x - 1/2) >= x + 1/2."""
    units = source.read(HYPERBOLIC, r"The error is below (\d+) units", "e^-y for y")
    exponents = exponent(source, 27, 2 * 27 + 1)
    # The bound of the exponent for any x: its error is at least -(2x + 1) units.
    exponents.error = "(e - x * L) + (2 * x + 1) * 1b-64"
    exponents.low, exponents.high = Fraction(0), Fraction(2**70)
    exponents.hints = [f"{exponents.error} -> (e - x * l) + 1b-64 + x * ((l - L) + 1b-63);"]
    exponents.name, exponents.grows, exponents.parts = "the exponent of e^-y", ("2y", 1, -1), ()
    lines = ["t = fixed<-62,dn>(y * h);", "T = Y * h - M;"]
    given = [*power_given(source), "h in [0,0.5]", f"M in {between(0, Fraction('1.2131') * GROWTH / 2**64)}"]
    parts = [("that error's effect on e^-y", "M", 62), ("the power of the code's exponent", "(y - Y) * h", 62),
             ("its shift", "t - y * h", 62)]
    return [exponents, Proof(lines, given, "t - T", -units, units, 62,
                             ["t - T -> (t - y * h) + (y - Y) * h + M;"], parts=parts)]


def sinh_and_cosh(source):
    units, bits = source.read(
        HYPERBOLIC, r"error = (\d+); const nearest_ends ends = nearest_within\(value, error, (\d+) - whole",
        "nearest_hyperbolic")
    falling = source.read(HYPERBOLIC, r"The error is below (\d+) units", "e^-y for y")
    off = source.read(EXPONENTIAL, r"exponential_base::two \? 0 : (\d+);", "nearest_exponential")
    proofs = []
    for name, sign in (("sinh", "-"), ("cosh", "+")):
        lines = [f"r = fixed<-{bits},dn>(0.5 * y);", "U = 0.5 * Y + 0.5 * Y * k;", f"d = fixed<-{bits},dn>(t * h);"]
        given = [*power_given(source), f"k in {between(0, off * GROWTH / 2**64)}", "h in [0,0.5]",
                 f"t - T in [-{falling}b-62,{falling}b-62]"]
        error = f"(r {sign} d) - (U {sign} T * h)"
        parts = [("the power of the code's exponent, for e^x / 2", "0.5 * (y - Y)", bits),
                 ("its shift", "r - 0.5 * y", bits),
                 ("the exponent of e^x", "-0.5 * Y * k", bits), ("e^-x / 2", "(t - T) * h", bits),
                 ("its shift to the unit of e^x", "d - t * h", bits)]
        hint = (f"{error} -> (r - 0.5 * y) + 0.5 * (y - Y) - 0.5 * Y * k "
                f"{sign} ((d - t * h) + (t - T) * h);")
        proofs.append(Proof(lines, given, error, -units, units, bits, [hint], name=f"{name}: sum", parts=parts))
    return proofs


def tanh(source):
    units, bits = source.read(
        HYPERBOLIC, r"error = (\d+); const nearest_ends ends = nearest_within\(value, error, (\d+) - fraction_bits",
        "nearest_hyperbolic_tangent")
    falling = source.read(HYPERBOLIC, r"The error is below (\d+) units", "e^-y for y")
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
    return [proof_of_cosine(source, units)]


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
    """t = s/c for a sine s and a cosine c that are off by up to e < 1; all in units, e' = e 2^-62, c >= c0.
    |t - S/C| <= e (1 + S/C) / c. As S + C >= 1, 1/c <= (1 + t) / (1 - 2e'), and 1 + S/C = (S + C) / C is at most
    (1 + t) (1 + 2e' / (1 - 2e')) / (1 - e' / c0). The quotient is rounded by less than a unit. The code's `bound` is
    at least 1 and 1 + t. Exact, without Gappa."""
    units, factor, bits = source.read(
        PHASE, r"tangent >> 62\) \+ (\d); .*?int128\{(\d+) \* bound\} \* int128\{bound\}, (\d+) -", "nearest_tangent")
    least = source.read(PHASE, r"cosine >> (\d+) != 0")
    if units != 2 or bits != 62:
        raise NotProven("nearest_tangent() has other units")
    off = factor - 2
    e, c = Fraction(off, 2**62), Fraction(2**least, 2**62)
    sum_of_factors = off * (1 + 2 * e / (1 - 2 * e)) / (1 - e / c) / (1 - 2 * e) + 1
    # A cosine is at least 2/pi of the distance from the pole, so it is never negative but for its sign.
    pole = distance_from_pole() * 2 / PI
    proof = proof_of_cosine(source, off + 1)
    proof.name = "the sine and the cosine"
    return [proof, Exact("the quotient, rounded down", -1, 0, 62),
            Exact("the sum, divided by (1 + tan)^2", -sum_of_factors, sum_of_factors, 62, (-factor, factor)),
            Exact("the least cosine, so that none changes its sign", pole * 2**62, None, 62, (off, None))]


def turned(source, bits=58):
    """What the octants add: pi - (pi/2 - angle), with pi in units of 2^-bits."""
    pi = source.word("pi_58") >> (58 - bits)
    half = pi >> 1
    return max(abs(n - exact * 2**bits) for n, exact in ((half, PI / 2), (pi, PI), (pi - half, PI / 2)))


def angle(source):
    units, bits = source.read(
        ARCTANGENT, r"error = (\d+); const nearest_ends ends = nearest_within\(angle, error, (\d+) -")
    off = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    given = [f"a - A in [-{off}b-58,{off}b-58]", near("q", Fraction(0), turned(source) / 2**58)]
    return [Proof([], given, "(a + q) - A", -units, units, bits, ["(a + q) - A -> (a - A) + q;"],
                  parts=[("the arctangent", "a - A", 58), ("pi, pi/2 or their difference", "q", 58)])]


def quick_angle(source):
    units, bits = source.read(ARCTANGENT, r"quick_error = (\d+); .*?nearest_within\(quick, quick_error, (\d+) -")
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
    # The root's units are at most 2^-63 of the longest side: 31 bits, and 32 of the longest side at least.
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


def cube_root(source):
    """The exponent: log / 3 as a product with (2^64 + 2) / 3. The logarithm is n + f, of up to 33."""
    units = source.read(POWER, r"error = (\d+);", "nearest_cube_root")
    third = source.read(POWER, r"third = (0x[0-9a-f]+)")
    off = logarithm_off(source)
    lines = [f"h = {third}b-64;", "e = n * h + fixed<-64,dn>(f * h);"]
    given = ["n in [0,32]", "f in [0,1]", f"(n + f) - M in [-{off}b-64,{off}b-64]",
             within("H", third, 64, Fraction(1, 3))]
    parts = [("the logarithm, a third of it", "((n + f) - M) * H", 64),
             ("1/3, times the logarithm", "(n + f) * (h - H)", 64),
             ("the product, rounded down", "e - (n * h + f * h)", 64)]
    return [of_constant("1/3", third, 64, Fraction(1, 3)),
            Proof(lines, given, "e - M * H", -units, units, 64,
                  ["e - M * H -> (e - (n * h + f * h)) + (n + f) * (h - H) + ((n + f) - M) * H;",
                   "e - (n * h + f * h) -> fixed<-64,dn>(f * h) - f * h;"], parts=parts)]


def reciprocal_root(source):
    units = source.read(POWER, r"error = (\d+);", "nearest_reciprocal_root")
    off = logarithm_off(source)
    return [Proof(["e = fixed<-64,dn>(-0.5 * m);"], ["m in [-32,33]", f"m - M in [-{off}b-64,{off}b-64]"],
                  "e + 0.5 * M", -units, units, 64, ["e + 0.5 * M -> (e - (-0.5 * m)) - 0.5 * (m - M);"],
                  parts=[("the logarithm, minus half of it", "-0.5 * (m - M)", 64),
                         ("the half, rounded down", "e - (-0.5 * m)", 64)])]


def power(source):
    """The exponent: y times the logarithm. The bound is a multiple of |y|; y and -y differ in the rounding only."""
    off, more = source.read(POWER, r"exponent\) \* (\d+) >> fraction_bits\) \+ (\d+);", "nearest_real_power")
    log = logarithm_off(source)
    proofs = []
    for sign in "+-":
        lines = ["e = fixed<-64,dn>(m * y);", f"q = fixed<0,dn>({off} * y);"]
        if sign == "-":
            lines[0] = "e = fixed<-64,up>(m * y);"
        for side, low, high in (("-", -2**80, 0), ("+", 0, 2**80)):
            error = f"(e - M * y) {side} (q + {more}) * 1b-64"
            hint = (f"{error} -> (e - m * y) + y * ((m - M) {side} {off}b-64) {side} (q - {off} * y) * 1b-64 "
                    f"{side} {more}b-64;")
            parts = [("the logarithm", "m - M", 64), ("the product, rounded", "e - m * y", 64),
                     (f"{off} abs(y), rounded down", f"q * 1b-64 - {off} * y * 1b-64", 64)]
            proofs.append(Proof(lines, ["y in [0,1b32]", "m in [-32,33]", f"m - M in [-{log}b-64,{log}b-64]"],
                                error, low, high, 64, [hint], parts=parts,
                                grows=(f"{off} abs(y)", more, -1 if side == "+" else 1)))
    return proofs
