"""The error bounds of the parts that functions share: what the comments beside the code promise."""
import math
from fractions import Fraction

from bounds.gappa import (LOG2_E, LOG_2, PI, Exact, NotProven, Proof, arctangent_of, between, coefficients, entries,
                          horner, hypotheses, logarithm, of_constant, truncated, within)

# The error of an entry of a table that is rounded to nearest.
HALF = (Fraction(-1, 2), Fraction(1, 2))

EXPONENTIAL, ARCTANGENT, COSINE, PHASE, ARCSINE = (
    f"{name}.hpp" for name in ("exponential", "arctangent", "cosine", "phase", "arcsine"))


def power_terms(source):
    """The terms of 2^x that exact results take and quick ones, each with the bound: units of 2^-63 too low."""
    return ((len(source.table("power_coefficients")),
             source.read(EXPONENTIAL, r"at most (\d+) units too low and never too high")),
            (source.read(EXPONENTIAL, r"quick_power_terms = (\d+);"),
             source.read(EXPONENTIAL, r"result at most (\d+) units too low")))


def power_of_two(source):
    """2^x is P 2^(r/32) for a table entry P. R is the rest of the series."""
    powers = source.table("powers_of_two")
    for i, power in enumerate(powers):
        if not power**32 <= 2 ** (i + 63 * 32) < (power + 1) ** 32:
            raise NotProven(f"power {i} is not rounded down")
    proofs = [coefficients(source.table("power_coefficients"), 64, lambda n: (LOG_2 / 32) ** n / math.factorial(n))]
    for terms, low in power_terms(source):
        words = source.table("power_coefficients")[:terms]
        z, n = LOG_2 / 32, terms + 1
        rest = z**n / math.factorial(n) / (1 - z / (n + 1))
        lines = ["r = fixed<-64,dn>(R0);", *(line.replace("R * ", "r * ") for line in horner(words, 64, "+", "r")),
                 "q = fixed<-64,dn>(r * s1);", "T = r * S1;", "Q = T + R;",
                 "y = p + fixed<-63,dn>(p * q);", "Y = P + P * Q;"]
        highest = Fraction(powers[-1] + 1, 2**63)
        given = ["r in [0,1]", f"R in {between(0, rest)}", "T in [0,1b-5]", "@FIX(p,-63)", "p - P in [-1b-63,0]",
                 f"p in {between(1, highest)}", f"P in {between(1, highest)}",
                 *hypotheses(words, 64, lambda n, z=z: z**n / math.factorial(n))]
        few = few_terms(terms, "power_coefficients", source)
        units, bits = in_large_units(low, 63)
        parts = [(f"each of {len(powers)} entries of the table", "p - P", 63),
                 truncated(f"each of {terms} products of the series", "(r * s1)", 64),
                 (few + "the series: coefficients and products", "q - T", 64),
                 (f"its remainder after {terms} terms", "-R", 43 if few else 68),
                 truncated("the product of the entry and the series", "(p * q)", 63)]
        proofs.append(Proof(lines, given, "y - Y", -units, 0, bits, ["q - Q -> (q - T) - R;"], name=few + "sum",
                            parts=parts))
    return proofs


def few_terms(terms, table, source):
    """What the names of errors begin with if quick results have fewer terms than the table."""
    return "" if terms == len(source.table(table)) else f"{terms} terms: "


def in_large_units(units, bits):
    """A large power of two of units of 2^-bits as one larger unit."""
    if units < 1024 or units.bit_count() != 1:
        return units, bits
    return 1, bits + 1 - units.bit_length()


def logarithm_terms(source):
    """The terms of a logarithm that exact results take, quick ones, and quick powers, each with its error in units of
    2^-64."""
    exact, bits, each = source.read(
        EXPONENTIAL, r"logarithm_terms \? (\d+) : std::int64_t\{1\} << \((\d+) - (\d+) \* Terms\)")
    quick = (source.read(EXPONENTIAL, r"quick_logarithm_terms = (\d+);"),
             source.read("power.hpp", r"quick_real_power_terms = (\d+);"))
    return ((len(source.table("logarithm_coefficients")), exact),
            *((terms, 1 << bits - each * terms) for terms in quick))


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
    reciprocals, table = source.table("reciprocals"), source.table("logarithms")
    most = highest_rest(source)
    exact = source.read(EXPONENTIAL, r"The error is below (\d+) units", "log2(m / 2^32) in units of 2^-64")
    proofs = [Exact(f"the product of m and one of {len(reciprocals)} reciprocals", 0, 0, 64),
              coefficients(source.table("logarithm_coefficients"), 64, lambda n: LOG2_E / (n * 32**n)),
              entries(f"each of {len(table)} logarithms of the table", table, 64,
                      lambda i: -logarithm(Fraction(reciprocals[i], 2**31)) / LOG_2 + 1 if i else 0, HALF)]
    for terms, units in logarithm_terms(source):
        few = few_terms(terms, "logarithm_coefficients", source)
        if not few and units != exact:
            raise NotProven("the error of a logarithm is told differently")
        words = source.table("logarithm_coefficients")[:terms]
        n = terms + 1
        rest = LOG2_E * (most / 32) ** n / n
        lines = ["u = fixed<-64,dn>(U0);", *(line.replace("U * ", "u * ") for line in horner(words, 64, "-", "u")),
                 "t = fixed<-64,dn>(u * s1);", "T = u * S1;", "y = l + t;", "Y = (L + T) + R;"]
        given = [f"u in {between(0, most)}", "l - L in [-1b-65,1b-65]", f"R in {between(-rest, rest)}",
                 *hypotheses(words, 64, lambda n: LOG2_E / (n * 32**n))]
        units, bits = in_large_units(units, 64)
        parts = [truncated(f"each of {terms} products of the series", "(u * s1)", 64),
                 (few + "the series: coefficients and products", "t - T", 64),
                 (f"its remainder after {terms} terms", "R", bits if few else 68)]
        proofs.append(Proof(lines, given, "y - Y", -units, units, bits, ["y - Y -> (l - L) + (t - T) - R;"],
                            name=few + "sum", parts=parts))
    return proofs


def cube_root(source):
    """The root (1 + T + R) C K of (1 + r) / c 2^k for u = 32 r; C and K are those of 1 / c and of 2^k."""
    words, roots = source.table("cube_root_coefficients"), source.table("cube_roots")
    ends = source.table("roots_of_powers")
    cubes = (*((root, 63, Fraction(2**32, c)) for root, c in zip(roots, source.table("reciprocals"))),
             *((root, 62, Fraction(2**k)) for k, root in enumerate(ends)))
    for word, bits, cube in cubes:
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
    given = [f"u in {between(0, most)}", f"c in {between(1, highest)}", f"C in {between(1, highest)}",
             "c - C in [-1b-64,1b-64]", "k in [1,1.6]", "K in [1,1.6]", "k - K in [-1b-63,1b-63]",
             f"R in {between(0, rest)}", "T in [0,0.01]", *hypotheses(words, 64, coefficient)]
    units = source.read("power.hpp", r"less than (\d+) units of 2\^-61", "below 1/4")
    # Below 1/4 of an ulp, which is at least 2^-31 of the root's unit.
    if units > 2 ** (61 - 31 - 2):
        raise NotProven("a cube root is off by more")
    units, bits = in_large_units(units, 61)
    parts = [(f"each of {len(roots)} roots of the table", "c - C", 63),
             (f"each of {len(ends)} roots of 1, 2 and 4", "k - K", 62),
             ("their product, with their errors", "m - C * K", 61),
             truncated(f"each of {len(words)} products of the series", "(u * s1)", 64),
             ("the series: coefficients and products", "t - T", 64),
             (f"its remainder after {len(words)} terms", "-R", 35),
             truncated("the product of the roots and the series", "(m * t)", 61)]
    return [coefficients(words, 64, coefficient),
            Proof(lines, given, "y - Y", -units, units, bits,
                  ["y - Y -> (y - (m + m * t)) + (m - C * K) * (1 + t) + C * K * ((t - T) - R);",
                   "m - C * K -> (m - c * k) + c * (k - K) + (c - C) * K;"], parts=parts)]


def arctangent(source):
    """atan(Z) for the ratio Z, of which the code has z. R is the rest of the series."""
    words = source.table("arctangent_coefficients")
    table = source.table("arctangents")
    steps = len(table) - 1
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
    parts = [("the ratio z", "z - Z", 58),
             ("1024 z^2", "w - W", 64),
             ("the series: coefficients and products", "v - V", 64),
             ("the product of z and the series", "t - z * v", 58),
             (f"its remainder after {len(words)} terms", "R", 63)]
    return [coefficients(words, 64, lambda n: Fraction(1, (2 * n + 1) * 1024**n)),
            entries(f"each of {len(table)} entries of the table", table, 58,
                    lambda i: arctangent_of(Fraction(i, steps)), HALF),
            Proof(lines, given, "y - Y", -units, units, 58,
                  ["y - Y -> (a - A) - (t - T) - R + ((z - Z) * K);"], parts=parts)]


def quick_arctangent(source):
    """As arctangent(), in units of 2^-32, with one term of the series."""
    steps = len(source.table("arctangents")) - 1
    rest = Fraction(1, steps**5 * 5)
    units = source.read(ARCTANGENT, r"The error is below (\d+) units", "The arctangent of n / d in units of 2^-32")
    lines = ["z = fixed<-32,dn>(Z);", "w = fixed<-32,dn>(z * z);", "t = fixed<-32,dn>(w * z / 3);",
             "T = z * z * z / 3;", "y = a + (z - t);", "Y = A + ((z - T) + R + (Z - z) * K);"]
    given = [f"Z in {between(0, Fraction(1, steps))}", "K in [0,1]",
             f"a - A in {between(-Fraction(101, 100) / 2**32, Fraction(1, 2**59))}", f"R in {between(0, rest)}"]
    parts = [("the entry of the table, shifted", "a - A", 32), ("the ratio z", "z - Z", 32),
             ("z^3 / 3", "t - T", 32), ("the remainder of the series after z^3", "-R", 32)]
    return [Proof(lines, given, "y - Y", -units, units, 32,
                  ["y - Y -> (a - A) + ((T - t) - R - (Z - z) * K);",
                   "T - t -> (w * z / 3 - t) - (w - z * z) * z / 3;"], parts=parts)]


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
    parts = [("the angle a", "a - A", 62), ("u = a^2 / 4, without that of a", "u - 0.25 * (a * a)", 64),
             truncated(f"each of {count} products of the series", "(u * s1)", 62),
             ("the series, with all of these", "v - V", 62),
             (f"its remainder after {count} terms", "R", 70)]
    return [coefficients(words, 62, lambda n: Fraction(4**n, math.factorial(2 * n))),
            Proof(lines, given, "y - Y", -units, units, 62,
                  ["y - Y -> (V - v) - R;", "u - U -> (u - 0.25 * (a * a)) + 0.25 * ((a - A) * (a + A));"],
                  parts=parts)]


def angle_of_a_phase(source):
    """q quarter turns, off by `error` units of 2^-62, as an angle: what cosine() is given."""
    error = phase_error(source)
    allowed = source.read(COSINE, r"even if the angle is (\d+) units off")
    half_pi = source.read(COSINE, r"half_pi = (0x[0-9a-f]+)")
    lines = ["q = fixed<-62,dn>(Q0);", f"h = {half_pi}b-62;", "a = fixed<-62,dn>(q * h);"]
    given = ["q in [0,1]", "Q in [-0.1,1.1]", f"q - Q in {between(-error / 2**62, error / 2**62)}",
             within("H", half_pi, 62, PI / 2)]
    parts = [("the phase, in quarter turns", "q - Q", 62), ("the product with pi/2", "a - q * h", 62)]
    return [of_constant("pi/2", half_pi, 62, PI / 2),
            Proof(lines, given, "a - Q * H", -allowed, allowed, 62,
                  ["a - Q * H -> (a - q * h) + q * (h - H) + (q - Q) * H;"], parts=parts)]


def phase_error(source):
    """In units of 2^-64 of a turn. Turns are exact, degrees are rounded down. For radians the floor of a product
    and a constant of 128 bits, too low by less than a unit of 2^-128, count for operands of up to 2^32."""
    text = r"The error is at most 1 \+ 2\^-(\d+) units"
    error = 1 + Fraction(1, 2 ** source.read(PHASE, text))
    constant = inverse_turn(source)
    exact = 2**128 / (2 * PI)
    if not 0 <= exact - constant < 1:
        raise NotProven("1 / (2 pi) is not rounded down")
    if 1 + (exact - constant) * 2**32 / 2**64 > error:
        raise NotProven("the error of a phase is larger")
    return error


def inverse_turn(source):
    """1 / (2 pi) in units of 2^-128."""
    return (source.word("turns_high") << 64) + source.word("turns_low")


def phase(source):
    """The parts of phase_error()."""
    off = inverse_turn(source) - 2**128 / (2 * PI)
    allowed = phase_error(source)
    return [Exact("1 / (2 pi)", off, off, 128),
            Exact("its product with an angle of up to 2^32 ulps", off, 0, 96),
            Exact("the phase, rounded down, of either sign", off / 2**32 - 1, 1 - off / 2**32, 64,
                  (-allowed, allowed))]


def root(source):
    """A scaled root: r + f for the nearest integer r and f = rest / (2 r), off by V = h^2 / (S + r + h)."""
    units = source.read(ARCSINE, r"The error is below (\d+) units")
    lines = ["h = rest / (2 * r);", "f = fixed<-31,zr>(h);", "V = h * h / (r + r + h - V0);"]
    # The root S is r + h - V, because (r + h)^2 = n + h^2. V0 is V: at most 1.
    given = ["r in [2147483648,4294967296]", "rest / r in [-1,1]", "V0 in [0,1]"]
    parts = [("the quotient rest / (2 r)", "f - h", 31), ("the next term of the root", "V", 31)]
    return [Proof(lines, given, "(f - h) + V", -units, units, 31, ["h -> 0.5 * (rest / r) { r <> 0 };"], parts=parts)]
