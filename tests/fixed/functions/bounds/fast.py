"""The error bounds of the sines of 8.8 and 16.16, which have a polynomial of their own."""
import math
from fractions import Fraction

from bounds.gappa import PI, Exact, NotProven, Proof, of_constant
from bounds.parts import COSINE

HEADER = "radian.hpp"
ANGLES = 2**31  # the largest angle in units of 2^-16 radians


def coefficients_of_polynomial(source):
    """c0 has 62 bits after the point, c1 31, the others 32."""
    words = [int(word, 16) for word in source.read_list(HEADER, r"fast_coefficients\{(.*?)\}", r"0x[0-9a-f]+")]
    return [(word, bits) for word, bits in zip(words, [62, 31] + [32] * (len(words) - 2))]


def range_on_unit_interval(polynomial, pieces=64):
    """Limits of a polynomial's values from 0 to 1: those of its Bernstein coefficients on parts of the interval."""
    degree, low, high = len(polynomial) - 1, None, None
    for piece in range(pieces):
        start, width = Fraction(piece, pieces), Fraction(1, pieces)
        shifted = [sum(c * math.comb(n, k) * start ** (n - k) for n, c in enumerate(polynomial) if n >= k) * width**k
                   for k in range(degree + 1)]
        for i in range(degree + 1):
            value = sum(Fraction(math.comb(i, k), math.comb(degree, k)) * shifted[k] for k in range(i + 1))
            low = value if low is None else min(low, value)
            high = value if high is None else max(high, value)
    return low, high


def polynomial_off(source, terms=13):
    """The polynomial less the cosine of d quarter turns, a series in d^2."""
    signed = [(-1) ** n * Fraction(word, 2**bits)
              for n, (word, bits) in enumerate(coefficients_of_polynomial(source))]
    signed += [Fraction(0)] * (terms - len(signed))
    series = [(-1) ** n * (PI / 2) ** (2 * n) / math.factorial(2 * n) for n in range(terms)]
    rest = (PI / 2) ** (2 * terms) / math.factorial(2 * terms)
    low, high = range_on_unit_interval([a - b for a, b in zip(signed, series)])
    return low - rest, high + rest


def fast_angle(source):
    """An angle of up to 2^31 units of 2^-16 radians as d: 2^-31 quarter turns are 2^31 units of 2^-64 turns."""
    units = source.read(HEADER, r"turns_per_unit = (0x[0-9a-f]+)")
    exact = 2**48 / (2 * PI)
    off = abs(units - exact) * ANGLES / 2**31
    return [of_constant("2^-16 radians in turns", units, 64, exact / 2**64),
            Exact("its product with an angle", -off, off, 33),
            Exact("the rounding to d", Fraction(-1, 2), Fraction(1, 2), 33),
            Exact("sum", -off - Fraction(1, 2), off + Fraction(1, 2), 33, angle_allowed(source))]


def angle_allowed(source):
    hundredths = source.read(HEADER, r"even if d is 0\.(\d\d) units off")
    return Fraction(-hundredths, 100), Fraction(hundredths, 100)


def fast_cosine(source):
    """The polynomial in z = d^2, where the code rounds down z and each product. C is the exact polynomial of D^2."""
    words = coefficients_of_polynomial(source)
    last = len(words) - 1
    given, z = ["d in [-1,1]"], "fixed<-31,dn>(d * d)"
    lines = ["z = fixed<-31,dn>(d * d);", "Z = d * d;"]
    for n in range(last - 1, 0, -1):
        word, bits = words[n]
        rest, exact = (f"{words[last][0]}b-{words[last][1]}",) * 2 if n == last - 1 else (f"f{n + 1}", f"F{n + 1}")
        lines += [f"f{n} = {word}b-{bits} - fixed<-{bits},dn>(z * {rest});", f"F{n} = {word}b-{bits} - Z * {exact};"]
    lines += [f"y = {words[0][0]}b-62 - z * f1;", f"Y = {words[0][0]}b-62 - Z * F1;"]
    allowed = source.read(HEADER, r"fast_cosine_error = std::uint64_t\{1\} << (\d+)")
    limit = Fraction(2) ** (allowed - 31)
    rounding = Proof(lines, given, "y - Y", -limit, limit, 31, name="all rounding of the polynomial",
                     parts=[("z = d^2", f"{z} - Z", 31),
                            ("each of the first three products", "fixed<-32,dn>(z * f3) - z * f3", 32),
                            ("the fourth product", "fixed<-31,dn>(z * f2) - z * f2", 31)])
    (low, high), found = (tuple(end * 2**31 for end in polynomial_off(source)), rounding.least())
    angle = angle_allowed(source)[1] * PI / 2
    return [rounding,
            Exact(f"the polynomial of {last + 1} coefficients", low, high, 31),
            Exact("the angle d", -angle, angle, 31),
            Exact("sum", low + found[0] - angle, high + found[1] + angle, 31, (-limit, limit))]


def slow_angle(source):
    """The same angle with 32 bits more, for the cosine with an error below 2^-56."""
    units, rest = (source.read(HEADER, r"turns_per_unit = (0x[0-9a-f]+)"),
                   source.read(HEADER, r"turns_per_unit_rest = (\d+)"))
    exact = 2**80 / (2 * PI)
    off = abs((units << 32) + rest - exact) * ANGLES / 2**32
    tenths = source.read(HEADER, r"`from_peak` is below 0\.(\d) of")
    half_pi = source.read(COSINE, r"half_pi = (0x[0-9a-f]+)")
    allowed = source.read(COSINE, r"even if the angle is (\d+) units off")
    turn = off + Fraction(1, 2)
    constant = abs(half_pi - PI / 2 * 2**62)
    angle = turn * PI / 2 + constant + 1
    if turn > Fraction(tenths, 10):
        raise NotProven("precise_sine(): the phase is off by more")
    return [Exact("2^-16 radians with 32 bits more, times an angle", -off, off, 64),
            Exact("the phase, with its rounding", -turn, turn, 64, (-Fraction(tenths, 10), Fraction(tenths, 10))),
            Exact("the angle in the quarter", -angle, angle, 62, (-allowed, allowed))]
