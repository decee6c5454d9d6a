"""The error bounds of the numbers with 184 bits after the point. Every step rounds down to 2^-184."""
import math
from fractions import Fraction

from bounds.gappa import LOG2_E, LOG_2, PI, NotProven, Proof, between, within

HEADER = "precise_exponential.hpp"
UNIT = "fixed<-184,dn>"


def constant(source, name, exact):
    word = source.real("real_" + name)
    return f"{name} = {word}b-184;", within(name.upper(), word, 184, exact)


def precise_power(source):
    """The Taylor series of e^(x log 2), for an exact x."""
    n = source.read(HEADER, r"std::uint32_t n = (\d+); n > 0; --n")
    bits = source.read(HEADER, r"with an error below 2\^-(\d+)")
    word, off = constant(source, "log_2", LOG_2)
    lines = [word, f"t = {UNIT}(x * log_2);", "T = x * LOG_2;", f"s{n + 1} = 1;", f"S{n + 1} = 1;"]
    for k in range(n, 0, -1):
        lines += [f"s{k} = 1 + {UNIT}({UNIT}(t * s{k + 1}) / {k});", f"S{k} = 1 + T * S{k + 1} / {k};"]
    rest = LOG_2 ** (n + 1) / math.factorial(n + 1) / (1 - LOG_2 / (n + 2))
    parts = [("t = x log(2)", "t - T", 184), ("the series, with that of t", "s1 - S1", 184),
             (f"its remainder after t^{n}", "-R", 200)]
    return [Proof([*lines, "Y = S1 + R;"], ["x in [0,1]", off, f"R in {between(0, rest)}"], "s1 - Y",
                  -(2 ** (184 - bits)), 2 ** (184 - bits), 184, ["s1 - Y -> (s1 - S1) - R;"], parts=parts)]


def precise_logarithm(source):
    """log2(m) from 2 atanh(Z); the code has z for Z, of which it rounds down a ratio."""
    last = source.read(HEADER, r"std::uint32_t n = (\d+); n > 1; n -= 2")
    bits = source.read(HEADER, r"with an error below 2\^-(\d+)")
    word, off = constant(source, "log2_e", LOG2_E)
    lines = [word, f"z = {UNIT}(Z);", f"q = {UNIT}(z * z);", "Q = Z * Z;", f"s{last + 2} = 0;", f"S{last + 2} = 0;"]
    for n in range(last, 1, -2):
        lines += [f"s{n} = {UNIT}(q * ({UNIT}(1 / {n}) + s{n + 2}));", f"S{n} = Q * (1 / {n} + S{n + 2});"]
    lines += [f"l = {UNIT}(2 * z * (1 + s3));", "L = 2 * Z * (1 + S3);", f"y = {UNIT}(l * log2_e);",
              "Y = (L + R) * LOG2_E;"]
    z = Fraction(1, 3)
    rest = 2 * z ** (last + 2) / (last + 2) / (1 - z * z)
    return [Proof(lines, [f"Z in {between(0, z)}", off, f"R in {between(0, rest)}"], "y - Y",
                  -(2 ** (184 - bits)), 2 ** (184 - bits), 184,
                  ["y - Y -> (y - l * log2_e) + (l * log2_e - L * LOG2_E) - R * LOG2_E;"],
                  parts=[("z = (m - 1) / (m + 1)", "z - Z", 184),
                         ("the natural logarithm, with that of z", "l - L", 184),
                         (f"its remainder after z^{last}", "-R", 184),
                         ("the product with log2(e)", "y - l * log2_e", 184)])]


def precise_arctangent(source):
    """The arctangent of A, of which the code has a, at most one unit too low. Euler's series has the ratio P of
    its terms and the factor G, of which the code has p and g."""
    header = "arctangent.hpp"
    n = source.read(header, r"std::uint32_t k = (\d+); k > 0; --k")
    bits = source.read(header, r"with an error below 2\^-(\d+)")
    if source.read(header, r"real_one << (\d)\) < x \* real\{5\}") != 1:
        raise NotProven("precise_arctangent() has another threshold")
    # Up to 2/5, or for (1 - x) / (1 + x) up to 3/7. An error of x by a unit, rounded down, counts twice there;
    # pi/4 is off by a unit.
    highest = Fraction(3, 7)
    ratio = highest**2 / (1 + highest**2)
    argument = [f"a = {UNIT}(A);", f"b = 1 + {UNIT}(a * a);", "B = 1 + A * A;"]
    bound = [f"A in {between(0, highest)}"]
    off = "b - B -> (b - (1 + a * a)) + (a - A) * (a + A);"
    terms = Proof([*argument, f"p = 1 - {UNIT}(1 / b);", "P = 1 - 1 / B;"], bound, "p - P", -3, 3, 184,
                  ["p - P -> -(fixed<-184,dn>(1 / b) - 1 / b) + (b - B) / (b * B);", off],
                  name="the ratio of the terms, a^2 / (1 + a^2)", parts=[("the argument a", "a - A", 184)])
    factor = Proof([*argument, f"g = {UNIT}(a / b);", "G = A / B;"], bound, "g - G", -4, 4, 184,
                   ["g - G -> (g - a / b) + (a - A) / b - (A / B) * ((b - B) / b);", off],
                   name="the factor of the series, a / (1 + a^2)")
    lines = [f"s{n + 1} = 1;", f"S{n + 1} = 1;"]
    for k in range(n, 0, -1):
        lines += [f"s{k} = 1 + {UNIT}({UNIT}(p * s{k + 1}) * {2 * k} / {2 * k + 1});",
                  f"S{k} = 1 + P * S{k + 1} * {2 * k} / {2 * k + 1};"]
    lines += [f"y = {UNIT}(g * s1);", "Y = G * S1 + R;"]
    given = [f"p in {between(0, ratio)}", f"P in {between(0, ratio)}", "p - P in [-3b-184,3b-184]",
             f"g in {between(0, highest)}", f"G in {between(0, highest)}", "g - G in [-4b-184,4b-184]",
             f"R in {between(0, ratio ** (n + 1) / (1 - ratio))}"]
    units = 2 ** (184 - bits) - 4
    return [terms, factor, Proof(lines, given, "y - Y", -units, units, 184,
                                 ["y - Y -> (y - g * s1) + (g * s1 - G * S1) - R;"],
                                 name="sum, for the argument a",
                                 parts=[("the series, with that of the ratio", "s1 - S1", 184),
                                        (f"its remainder after {n} steps", "-R", 184)])]


def precise_sine(source):
    header = "phase.hpp"
    n = source.read(header, r"std::uint32_t n = (\d+); n > 0; n -= 2")
    bits = source.read(HEADER, r"with an error below 2\^-(\d+)")
    proofs = []
    for name, more in (("c", -1), ("s", 1)):
        lines = [f"q = {UNIT}(a * a);", "Q = a * a;", f"{name}{n + 2} = 1;", f"{name.upper()}{n + 2} = 1;"]
        for k in range(n, 0, -2):
            lines += [f"{name}{k} = 1 - {UNIT}({UNIT}(q * {name}{k + 2}) / {k * (k + more)});",
                      f"{name.upper()}{k} = 1 - Q * {name.upper()}{k + 2} / {k * (k + more)};"]
        lines += ["y = c2;", "Y = C2 + R;"] if name == "c" else [f"y = {UNIT}(a * s2);", "Y = a * S2 + R;"]
        rest = (PI / 2) ** (n + 2) / math.factorial(n + 2)
        proofs.append(Proof(lines, [f"a in {between(0, PI / 2)}", f"R in {between(-rest, rest)}"], "y - Y",
                            -(2 ** (184 - bits)), 2 ** (184 - bits), 184,
                            [f"y - Y -> ({'c2 - C2' if name == 'c' else 'y - a * S2'}) - R;"],
                            parts=[("the square of the angle", "q - Q", 184),
                                   (f"the remainder of the series after x^{n + 1}", "R", 200)]))
    return proofs


def precise_phase(source):
    """The rest of an angle of up to 2^32 radians in quarter turns; degrees and turns are nearer."""
    bits = source.read("phase.hpp", r"The error of the rest is below 2\^-(\d+)")
    word, off = constant(source, "2_over_pi", 2 / PI)
    word, off = word.replace("2_over_pi", "f"), off.replace("2_OVER_PI", "F")
    pi_word, pi_off = constant(source, "pi", PI)
    # q - w is the part in a quarter turn, for the whole number w.
    lines = [word, pi_word, f"q = {UNIT}(x * f);", f"h = {UNIT}(0.5 * pi);", f"y = {UNIT}((q - w) * h);",
             "Y = (x * F - w) * (0.5 * PI);"]
    hint = "y - Y -> (y - (q - w) * h) + (q - w) * (h - 0.5 * PI) + ((q - x * f) + x * (f - F)) * (0.5 * PI);"
    parts = [("2/pi, times the angle", "x * (f - F)", 153), ("the product, rounded down", "q - x * f", 184),
             ("pi/2", "h - 0.5 * PI", 184), ("the product with pi/2, rounded down", "y - (q - w) * h", 184)]
    return [Proof(lines, ["x in [-1b32,1b32]", "q - w in [0,1]", off, pi_off], "y - Y",
                  -(2 ** (153 - bits)), 2 ** (153 - bits), 153, [hint], parts=parts)]
