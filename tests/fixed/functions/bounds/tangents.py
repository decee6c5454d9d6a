"""The error bounds of tangents: a ratio n / d, and what the code passes to nearest_within()."""
import math
from fractions import Fraction

from bounds.gappa import (PI, Exact, NotProven, Proof, between, coefficients, entries, horner, hypotheses, truncated,
                          within)
from bounds.parts import COSINE, HALF, PHASE, phase_error

# The series of tan(z) / z after 1.
SERIES = (Fraction(1, 3), Fraction(2, 15), Fraction(17, 315), Fraction(62, 2835))


def promised(source):
    """The error of n and d in units of 2^-62, and that of the phase."""
    return source.read(PHASE, r"below (\d+) units even if the phase is (\d+) units off", "The tangent of a phase")


def sine_and_cosine(x):
    """Of a fraction from 0 to 1, by their series; off by less than 2^-390."""
    x, term, sums = Fraction(round(x * 2**400), 2**400), Fraction(1), [Fraction(0), Fraction(0)]
    for n in range(90):
        sums[n % 2] += term if n % 4 < 2 else -term
        term = Fraction(round(term * x / (n + 1) * 2**400), 2**400)
    return sums[1], sums[0]


def tangent_of(x):
    sine, cosine = sine_and_cosine(x)
    return sine / cosine


def tangent_of_phase(source):
    """n = tan(c) + tan(z) and d = 1 - tan(c) tan(z). z, t and T are 32 times the angle and its tangent, q is 64 times
    the rest in quarter turns, and R is the rest of the series."""
    words, tangents = source.table("tangent_coefficients"), source.table("tangents")
    steps = len(tangents) - 1
    if steps != 32 or tangents[-1] != 2**62:
        raise NotProven("the tangents end elsewhere")
    units, off = promised(source)
    if phase_error(source) > off:
        raise NotProven("a phase is off by more")
    # All coefficients are below 1/2^n, and z is at most 1/40.
    n = len(words) + 1
    rest = 32 * Fraction(1, 40) ** (2 * n + 1) * Fraction(1, 2**n) * 2
    half_pi = source.read(COSINE, r"half_pi = (0x[0-9a-f]+)")
    q_off = Fraction(off * 4 * 64, 2**64)
    lines = [f"h = {2 * half_pi}b-64;", "q = fixed<-64,dn>(Q0);", "z = fixed<-64,dn>(q * h);", "Z = Q * H;",
             "w = fixed<-64,dn>(z * z);", "W = Z * Z;", *horner(words, 64, "+", "w"),
             "v = fixed<-64,dn>(w * s1);", "V = W * S1;", "t = z + fixed<-64,dn>(z * v);", "T = (Z + Z * V) + R;",
             "n = a + fixed<-62,dn>(0.03125 * t);", "N = A + 0.03125 * T;",
             "d = 1 - fixed<-62,dn>(0.03125 * (a * t));", "D = 1 - 0.03125 * (A * T);"]
    given = ["q in [0,1]", "Q in [-0.1,1.1]", f"q - Q in {between(-q_off, q_off)}",
             within("H", 2 * half_pi, 64, PI / 4), f"a in {between(0, 1)}", f"A in {between(0, 1)}",
             "a - A in [-1b-63,1b-63]", f"R in {between(0, rest)}",
             *hypotheses(words, 64, lambda n: SERIES[n - 1] / 1024**n)]
    hints = ["z - Z -> (z - q * h) + q * (h - H) + (q - Q) * H;", "w - W -> (w - z * z) + (z - Z) * (z + Z);",
             "t - T -> (z - Z) + (t - z - z * v) + z * (v - V) + (z - Z) * V - R;",
             "t - z - z * v -> fixed<-64,dn>(z * v) - z * v;"]
    parts = [("the phase, as 64 times a part of a quarter turn", "q - Q", 64), ("32 z", "z - Z", 64),
             ("1024 z^2", "w - W", 64), truncated(f"each of {len(words)} products of the series", "(w * s1)", 64),
             ("the series: coefficients and products", "v - V", 64),
             (f"its remainder after {len(words)} terms", "-R", 64), ("32 tan(z)", "t - T", 64)]
    shifted = "fixed<-62,dn>(0.03125 * t) - 0.03125 * t"
    product = "fixed<-62,dn>(0.03125 * (a * t)) - 0.03125 * (a * t)"
    return [coefficients(words, 64, lambda n: SERIES[n - 1] / 1024**n),
            entries(f"each of {len(tangents)} entries of the table", tangents, 62,
                    lambda i: tangent_of(PI * i / 128), HALF),
            Proof(lines, given, "n - N", -units, units, 62,
                  [*hints, f"n - N -> (a - A) + ({shifted}) + 0.03125 * (t - T);"], name="n: sum", parts=parts),
            Proof(lines, given, "d - D", -units, units, 62,
                  [*hints, f"d - D -> -({product}) - 0.03125 * (a * (t - T) + (a - A) * T);"], name="d: sum")]


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


def least_divisor(source):
    """d is at least this: tan(c) tan(z) is at most the tangent of 31/64 of a quarter turn times 1/40."""
    allowed = Fraction(source.read(PHASE, r"d > 0\.(96)\.", "The tangent of a phase"), 100)
    return allowed, 1 - Fraction(source.table("tangents")[-2], 2**62) / 40


def effect(source, least):
    """Of the errors of a and b on t = a/b, divided by (1 + t)^2, in units of 2^-62 for b >= 2^least units.
    |t - A/B| <= e' (1 + A/B) / b for the error e of both, e' = e 2^-62. As a or b is at least 0.96, 1/b is at most
    (1 + t) / 0.96, and 1 + A/B is at most (1 + t) (1 + 2e' / (b - e'))."""
    units, _ = promised(source)
    e = Fraction(units, 2**62)
    return units / least_divisor(source)[0] * (1 + 2 * e / (Fraction(2**least, 2**62) - e))


def tangent(source):
    """The code's `bound` b is at least 2 and 1 + t, so that a quotient rounded by a unit is off by b^2 / 4."""
    units, _ = promised(source)
    more, factor, bits = source.read(
        PHASE, r"tangent >> 62\) \+ (\d); .*?int128\{(\d+) \* bound\} \* int128\{bound\}, (\d+) -", "careful_tangent")
    least = source.read(PHASE, r"b >> (\d+) != 0", "careful_tangent")
    if more != 2 or bits != 62:
        raise NotProven("careful_tangent() has other units")
    allowed, divisor = least_divisor(source)
    off = effect(source, least)
    whole = off + Fraction(1, 4)
    # In units of 2^-62 of a turn. A phase is on the right side of every pole.
    pole = distance_from_pole() / (2 * PI) * 2**62
    return [Exact("d", divisor, None, 0, (allowed, None)),
            Exact("the effect of n and d, divided by (1 + tan)^2", -off, off, 62),
            Exact("the quotient, rounded down", -1, 0, 62),
            Exact("the sum, divided by B^2", -whole, whole, 62, (-factor, factor)),
            Exact("the distance of an angle from a pole, in turns", pole, None, 62, (units, None))]


def quick_tangent(source):
    """As tangent(), in units of 2^-32. It divides by b' > b - 2^31 units, so it is up to t 2^31 / b' higher."""
    least, shift, more, factor, bits = source.read(
        PHASE, r"b >> (\d+) != 0.*?\(b >> (\d+)\)\); .*?quick >> 32\) \+ (\d); "
               r".*?nearest_within\(quick, (\d+) \* bound \* bound, (\d+) -", "constexpr std::int64_t nearest_tangent")
    if (shift, more, bits) != (31, 2, 32):
        raise NotProven("nearest_tangent() has other units")
    # 2^31 units of 2^-62 are 2 units of 2^-32.
    lost = Fraction(2**shift, 2**30) / least_divisor(source)[0] / (1 - Fraction(2**shift, 2**least))
    off = effect(source, least) / 2**30
    low, high = -off - Fraction(1, 4), lost + off
    return [Exact("the bits that the divisor loses, divided by (1 + tan)^2", 0, lost, 32),
            Exact("the effect of n and d, divided by (1 + tan)^2", -off, off, 32),
            Exact("the quotient, rounded down", -1, 0, 32),
            Exact("the sum, divided by B^2", low, high, 32, (-factor, factor))]
