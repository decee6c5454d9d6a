"""The error bounds of the parts that functions share: what the comments beside the code promise."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_2, PI, NotProven, Proof, between, horner, hypotheses, within

EXPONENTIAL, ARCTANGENT, COSINE, PHASE, ARCSINE = (
    f"{name}.hpp" for name in ("exponential", "arctangent", "cosine", "phase", "arcsine"))


def power_terms(source):
    """The terms of 2^x that exact results take and quick ones, each with the bound: units of 2^-63 too low."""
    return ((len(source.table("power_coefficients")), source.read(EXPONENTIAL, r"at most (\d+) units too low and never too high")),
            (source.read(EXPONENTIAL, r"quick_power_terms = (\d+);"), source.read(EXPONENTIAL, r"result at most (\d+) units too low")))


def power_of_two(source):
    """2^x is P 2^(r/32) for a table entry P. R is the rest of the series."""
    powers = source.table("powers_of_two")
    for i, power in enumerate(powers):
        if not power**32 <= 2 ** (i + 63 * 32) < (power + 1) ** 32:
            raise NotProven(f"power {i} is not rounded down")
    proofs = []
    for terms, low in power_terms(source):
        words = source.table("power_coefficients")[:terms]
        z, n = LOG_2 / 32, terms + 1
        rest = z**n / math.factorial(n) / (1 - z / (n + 1))
        lines = ["r = fixed<-64,dn>(R0);", *(line.replace("R * ", "r * ") for line in horner(words, 64, "+", "r")),
                 "q = fixed<-64,dn>(r * s1);", "T = r * S1;", "Q = T + R;",
                 "y = p + fixed<-63,dn>(p * q);", "Y = P + P * Q;"]
        given = ["r in [0,1]", f"R in {between(0, rest)}", "T in [0,1b-5]", "@FIX(p,-63)", "p - P in [-1b-63,0]",
                 f"p in {between(1, Fraction(powers[-1] + 1, 2**63))}", f"P in {between(1, Fraction(powers[-1] + 1, 2**63))}",
                 *hypotheses(words, 64, lambda n, z=z: z**n / math.factorial(n))]
        proofs.append(Proof(lines, given, "y - Y", -low, 0, 63, ["q - Q -> (q - T) - R;"]))
    return proofs


def logarithm_terms(source):
    """The terms of a logarithm that exact results take, quick ones, and quick powers, each with its error in units of 2^-64."""
    exact, bits, each = source.read(EXPONENTIAL, r"logarithm_terms \? (\d+) : std::int64_t\{1\} << \((\d+) - (\d+) \* Terms\)")
    quick = (source.read(EXPONENTIAL, r"quick_logarithm_terms = (\d+);"), source.read("power.hpp", r"quick_real_power_terms = (\d+);"))
    return ((len(source.table("logarithm_coefficients")), exact), *((terms, 1 << bits - each * terms) for terms in quick))


def highest_rest(source):
    """Of 32 r, where a reciprocal makes a number 1 + r."""
    most = 0
    for i, c in enumerate(source.table("reciprocals")):
        if c * (2**32 + (i << 26)) < 2**64:
            raise NotProven(f"reciprocal {i} leaves a negative rest")
        most = max(most, c * (2**32 + ((i + 1) << 26) - 1) - 2**64)
    return Fraction(most * 32, 2**64)


def binary_logarithm(source):
    """log2(1 + r) for u = 32 r. The table's entry L is to nearest; R is the rest of the series."""
    most = highest_rest(source)
    exact = source.read(EXPONENTIAL, r"The error is below (\d+) units", "log2(m / 2^32) in units of 2^-64")
    proofs = []
    for terms, units in logarithm_terms(source):
        if units < 1000 and units != exact:
            raise NotProven("the error of a logarithm is told differently")
        words = source.table("logarithm_coefficients")[:terms]
        n = terms + 1
        rest = LOG2_E * (most / 32) ** n / n
        lines = ["u = fixed<-64,dn>(U0);", *(line.replace("U * ", "u * ") for line in horner(words, 64, "-", "u")),
                 "t = fixed<-64,dn>(u * s1);", "T = u * S1;", "y = l + t;", "Y = (L + T) + R;"]
        given = [f"u in {between(0, most)}", "l - L in [-1b-65,1b-65]", f"R in {between(-rest, rest)}",
                 *hypotheses(words, 64, lambda n: LOG2_E / (n * 32**n))]
        proofs.append(Proof(lines, given, "y - Y", -units, units, 64, ["y - Y -> (l - L) + (t - T) - R;"]))
    return proofs


def cube_root(source):
    """The root (1 + T + R) C K of (1 + r) / c 2^k for u = 32 r; C and K are those of 1 / c and of 2^k."""
    words, roots = source.table("cube_root_coefficients"), source.table("cube_roots")
    ends = source.table("roots_of_powers")
    for word, bits, cube in (*((r, 63, Fraction(2**32, c)) for r, c in zip(roots, source.table("reciprocals"))),
                             *((r, 62, Fraction(2**k)) for k, r in enumerate(ends))):
        if not Fraction(2 * word - 1, 2 ** (bits + 1)) ** 3 <= cube <= Fraction(2 * word + 1, 2 ** (bits + 1)) ** 3:
            raise NotProven("a cube root is not to nearest")

    def coefficient(n):
        value = Fraction(1)
        for i in range(n):
            value *= (Fraction(1, 3) - i) / (i + 1)
        return abs(value) / 32**n

    most, n = highest_rest(source), len(words) + 1
    rest = coefficient(n) * most**n
    lines = ["u = fixed<-64,dn>(U0);", *(line.replace("U * ", "u * ") for line in horner(words, 64, "-", "u")),
             "t = fixed<-64,dn>(u * s1);", "T = u * S1;", "m = fixed<-61,dn>(c * k);",
             "y = m + fixed<-61,dn>(m * t);", "Y = C * K * (1 + (T + R));"]
    highest = Fraction(roots[-1] + 1, 2**63)
    given = [f"u in {between(0, most)}", f"c in {between(1, highest)}", f"C in {between(1, highest)}", "c - C in [-1b-64,1b-64]",
             "k in [1,1.6]", "K in [1,1.6]", "k - K in [-1b-63,1b-63]", f"R in {between(0, rest)}", "T in [0,0.01]",
             *hypotheses(words, 64, coefficient)]
    units = source.read("power.hpp", r"less than (\d+) units of 2\^-61", "below 1/4")
    # Below 1/4 of an ulp, which is at least 2^-31 of the root's unit.
    if units > 2 ** (61 - 31 - 2):
        raise NotProven("a cube root is off by more")
    return [Proof(lines, given, "y - Y", -units, units, 61,
                  ["y - Y -> (y - (m + m * t)) + (m - C * K) * (1 + t) + C * K * ((t - T) - R);",
                   "m - C * K -> (m - c * k) + c * (k - K) + (c - C) * K;"])]


# In every rounding mode.
DOUBLE = Fraction(1, 2**52)


def reciprocal_root(source):
    """The root of a quotient in double, exact fractions without Gappa: it is at most 2^48."""
    source.read("power.hpp", r"off by less than (1)/4", "The integer next to 1 / sqrt")
    if 2**48 * ((1 + DOUBLE) ** 2 - 1) >= Fraction(1, 4):
        raise NotProven("a reciprocal root is off by more")
    return []


def quick_root(source):
    """A root of up to 2^32 units in double, rounded down; exact fractions without Gappa."""
    if 2**32 * DOUBLE + 1 > Fraction(source.read(ARCSINE, r"off by less than 1\.0(\d) units", "in units of 2^-shift"), 100) + 1:
        raise NotProven("a quick root is off by more")
    return []


def arctangent(source):
    """atan(Z) for the ratio Z, of which the code has z. R is the rest of the series."""
    words = source.table("arctangent_coefficients")
    steps = len(source.table("arctangents")) - 1
    n = len(words) + 1
    rest = Fraction(1, steps ** (2 * n + 1) * (2 * n + 1))
    lines = ["z = fixed<-58,dn>(Z);", "w = fixed<-64,dn>(1024 * (z * z));", "W = 1024 * (z * z);",
             *horner(words, 64, "-", "w"),
             "v = fixed<-64,dn>(w * s1);", "V = W * S1;",
             "t = fixed<-58,dn>(z * v);", "T = z * V;",
             "y = a + (z - t);", "Y = (A + (z - T)) + R + (Z - z) * K;"]
    # The derivative K of the arctangent makes the ratio's error one of the angle. The vector is up to a step of the
    # table above its entry.
    given = [f"Z in {between(0, Fraction(1, steps))}", "K in [0,1]", "a - A in [-1b-59,1b-59]",
             f"R in {between(-rest, rest)}",
             *hypotheses(words, 64, lambda n: Fraction(1, (2 * n + 1) * 1024**n))]
    units = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-58")
    return [Proof(lines, given, "y - Y", -units, units, 58,
                  ["y - Y -> (a - A) - (t - T) - R + ((z - Z) * K);"])]


def quick_arctangent(source):
    """As arctangent(), in units of 2^-32, with one term of the series."""
    steps = len(source.table("arctangents")) - 1
    rest = Fraction(1, steps**5 * 5)
    units = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-32")
    lines = ["z = fixed<-32,dn>(Z);", "w = fixed<-32,dn>(z * z);", "t = fixed<-32,dn>(w * z / 3);", "T = z * z * z / 3;",
             "y = a + (z - t);", "Y = A + ((z - T) + R + (Z - z) * K);"]
    given = [f"Z in {between(0, Fraction(1, steps))}", "K in [0,1]", f"a - A in {between(-Fraction(101, 100) / 2**32, Fraction(1, 2**59))}",
             f"R in {between(0, rest)}"]
    return [Proof(lines, given, "y - Y", -units, units, 32,
                  ["y - Y -> (a - A) + ((T - t) - R - (Z - z) * K);",
                   "T - t -> (w * z / 3 - t) - (w - z * z) * z / 3;"])]


def tangent_of_phase(source):
    """n = tan(c) + tan(z) and d = 1 - tan(c) tan(z). z, t and T are 32 times the angle and its tangent, q is 64 times
    the rest in quarter turns, and R is the rest of the series."""
    words, tangents = source.table("tangent_coefficients"), source.table("tangents")
    steps = len(tangents) - 1
    units, off = source.read(PHASE, r"below (\d+) units even if the phase is (\d+) units off", "The tangent of a phase")
    if phase_error(source) > off:
        raise NotProven("a phase is off by more")
    # All coefficients are below 1/2^n, and z is at most 1/40.
    n = len(words) + 1
    rest = 32 * Fraction(1, 40) ** (2 * n + 1) * Fraction(1, 2**n) * 2
    exact = (Fraction(1, 3), Fraction(2, 15), Fraction(17, 315), Fraction(62, 2835))
    half_pi = source.read(COSINE, r"half_pi = (0x[0-9a-f]+)")
    q_off = Fraction(off * 4 * 64, 2**64)
    lines = [f"h = {2 * half_pi}b-64;", "q = fixed<-64,dn>(Q0);", "z = fixed<-64,dn>(q * h);", "Z = Q * H;",
             "w = fixed<-64,dn>(z * z);", "W = Z * Z;", *horner(words, 64, "+", "w"),
             "v = fixed<-64,dn>(w * s1);", "V = W * S1;", "t = z + fixed<-64,dn>(z * v);", "T = (Z + Z * V) + R;",
             "n = a + fixed<-62,dn>(0.03125 * t);", "N = A + 0.03125 * T;",
             "d = 1 - fixed<-62,dn>(0.03125 * (a * t));", "D = 1 - 0.03125 * (A * T);"]
    given = ["q in [0,1]", "Q in [-0.1,1.1]", f"q - Q in {between(-q_off, q_off)}", within("H", 2 * half_pi, 64, PI / 4),
             f"a in {between(0, 1)}", f"A in {between(0, 1)}", "a - A in [-1b-63,1b-63]", f"R in {between(0, rest)}",
             *hypotheses(words, 64, lambda n: exact[n - 1] / 1024**n)]
    hints = ["z - Z -> (z - q * h) + q * (h - H) + (q - Q) * H;", "w - W -> (w - z * z) + (z - Z) * (z + Z);",
             "t - T -> (z - Z) + (t - z - z * v) + z * (v - V) + (z - Z) * V - R;", "t - z - z * v -> fixed<-64,dn>(z * v) - z * v;"]
    if steps != 32 or tangents[-1] != 2**62:
        raise NotProven("the tangents end elsewhere")
    return [Proof(lines, given, "n - N", -units, units, 62,
                  [*hints, "n - N -> (a - A) + (fixed<-62,dn>(0.03125 * t) - 0.03125 * t) + 0.03125 * (t - T);"]),
            Proof(lines, given, "d - D", -units, units, 62,
                  [*hints, "d - D -> -(fixed<-62,dn>(0.03125 * (a * t)) - 0.03125 * (a * t)) - 0.03125 * (a * (t - T) + (a - A) * T);"])]


def cosine(source):
    """cos(A) for an angle a of the code; a^2 / 4 is u. R is the rest of the series."""
    count = source.read(COSINE, r"std::uint64_t, (\d+)> cosine_coefficients")
    words, word = [], 1 << 62
    for n in range(1, count + 1):
        divisor = n * (2 * n - 1)
        word = word // divisor * 2 + word % divisor * 2 // divisor
        words.append(word)
    off = source.read(COSINE, r"even if the angle is (\d+) units off")
    bits = source.read(COSINE, r"The error is below 2\^-(\d+) even if")
    highest = PI / 2 + Fraction(8, 2**62)
    rest = highest ** (2 * count + 2) / math.factorial(2 * count + 2)
    lines = ["a = fixed<-62,dn>(A0);", "u = fixed<-64,dn>(0.25 * (a * a));", "U = 0.25 * (A * A);",
             *horner(words, 62, "-", "u"),
             "v = fixed<-62,dn>(u * s1);", "V = U * S1;", "y = 1 - v;", "Y = (1 - V) + R;"]
    given = [f"a in {between(0, highest)}", f"A in {between(0, highest)}", f"a - A in [-{off}b-62,{off}b-62]",
             f"R in {between(-rest, rest)}",
             *hypotheses(words, 62, lambda n: Fraction(4**n, math.factorial(2 * n)))]
    units = 2 ** (62 - bits)
    return [Proof(lines, given, "y - Y", -units, units, 62,
                  ["y - Y -> (V - v) - R;", "u - U -> (u - 0.25 * (a * a)) + 0.25 * ((a - A) * (a + A));"])]


def angle_of_a_phase(source):
    """q quarter turns, off by `error` units of 2^-62, as an angle: what cosine() is given."""
    error = phase_error(source)
    allowed = source.read(COSINE, r"even if the angle is (\d+) units off")
    half_pi = source.read(COSINE, r"half_pi = (0x[0-9a-f]+)")
    lines = ["q = fixed<-62,dn>(Q0);", f"h = {half_pi}b-62;", "a = fixed<-62,dn>(q * h);"]
    given = ["q in [0,1]", "Q in [-0.1,1.1]", f"q - Q in {between(-error / 2**62, error / 2**62)}",
             within("H", half_pi, 62, PI / 2)]
    return [Proof(lines, given, "a - Q * H", -allowed, allowed, 62,
                  ["a - Q * H -> (a - q * h) + q * (h - H) + (q - Q) * H;"])]


def phase_error(source):
    """In units of 2^-64 of a turn. Turns are exact, degrees are rounded down. For radians the floor of a product
    and a constant of 128 bits, too low by less than a unit of 2^-128, count for operands of up to 2^32."""
    text = r"The error is at most 1 \+ 2\^-(\d+) units"
    error = 1 + Fraction(1, 2 ** source.read(PHASE, text))
    high, low = source.word("turns_high"), source.word("turns_low")
    constant = (high << 64) + low
    exact = 2**128 / (2 * PI)
    if not 0 <= exact - constant < 1:
        raise NotProven("1 / (2 pi) is not rounded down")
    if 1 + (exact - constant) * 2**32 / 2**64 > error:
        raise NotProven("the error of a phase is larger")
    return error


def root(source):
    """A scaled root: r + f for the nearest integer r and f = rest / (2 r), off by V = h^2 / (S + r + h)."""
    units = source.read(ARCSINE, r"The error is below (\d+) units")
    lines = ["h = rest / (2 * r);", "f = fixed<-31,zr>(h);", "V = h * h / (r + r + h - V0);"]
    # The root S is r + h - V, because (r + h)^2 = n + h^2. V0 is V: at most 1.
    given = ["r in [2147483648,4294967296]", "rest / r in [-1,1]", "V0 in [0,1]"]
    return [Proof(lines, given, "(f - h) + V", -units, units, 31, ["h -> 0.5 * (rest / r) { r <> 0 };"])]
