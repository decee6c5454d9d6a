"""Writes proofs in Gappa's language, runs them, and reads the code's constants."""
import math
import re
import subprocess
from fractions import Fraction


def version():
    return subprocess.run(["gappa", "--version"], text=True, capture_output=True, check=True).stdout.strip()


class NotProven(Exception):
    pass


class Source:
    """The headers of a folder. Every constant of a proof comes from here."""

    def __init__(self, folder):
        self.folder = folder
        self.texts = {}

    def text(self, header):
        if header not in self.texts:
            with open(f"{self.folder}/{header}", encoding="ascii") as file:
                # Comments may break anywhere.
                self.texts[header] = re.sub(r"\n\s*(/// ?)?", " ", file.read())
        return self.texts[header]

    def read(self, header, pattern, after=""):
        """The integers of the first match of `pattern` behind the text `after`; a single one as such."""
        text = self.text(header)
        start = text.find(after)
        found = re.search(pattern, text[start:]) if start >= 0 else None
        if found is None:
            raise NotProven(f"{header} has changed: no '{pattern}' after '{after}'")
        numbers = [int(n, 0) for n in found.groups()]
        return numbers[0] if len(numbers) == 1 else numbers

    def read_list(self, header, pattern, item):
        """The texts that match `item` in the first group of `pattern`."""
        found = re.search(pattern, self.text(header))
        if found is None:
            raise NotProven(f"{header} has changed: no '{pattern}'")
        return re.findall(item, found[1])

    def table(self, name):
        found = re.search(r"\b%s\{(.*?)\}" % name, self.text("function_tables.hpp"), re.S)
        return [int(word, 16) for word in re.findall(r"0x[0-9a-f]+", found[1])]

    def real(self, name):
        return sum(word << 64 * i for i, word in enumerate(self.table(name)))

    def word(self, name):
        return self.read("function_tables.hpp", r"\b%s = (0x[0-9a-f]+)" % name)


def dyadic(value, is_up, bits=240):
    """A number of Gappa next to `value`, on the side that is asked for."""
    units = value * 2**bits
    return f"{math.ceil(units) if is_up else math.floor(units)}b-{bits}"


def between(low, high, bits=240):
    return f"[{dyadic(Fraction(low), False, bits)},{dyadic(Fraction(high), True, bits)}]"


def near(name, value, off=0):
    """A hypothesis: `name` is within `off` of `value`."""
    return f"{name} in {between(value - off, value + off)}"


def within(name, word, bits, exact):
    """A hypothesis: `word` units of 2^-bits are that near to the exact coefficient `name`."""
    off = Fraction(word) - exact * 2**bits
    low = math.floor(off * 2**20)
    return f"{word}b-{bits} - {name} in [{low - 1}b-{bits + 20},{low + 1}b-{bits + 20}]"


def horner(words, bits, sign, argument):
    """The sum of the code (s1) and the exact one (S1): word + sign * argument * (the rest)."""
    lines, last = [], len(words)
    for n in range(last - 1, 0, -1):
        rest = f"{words[-1]}b-{bits}" if n == last - 1 else f"s{n + 1}"
        exact = f"C{last}" if n == last - 1 else f"S{n + 1}"
        lines.append(f"s{n} = {words[n - 1]}b-{bits} {sign} fixed<-{bits},dn>({argument} * {rest});")
        lines.append(f"S{n} = C{n} {sign} {argument.upper()} * {exact};")
    return lines


def hypotheses(words, bits, exact):
    return [within(f"C{n}", word, bits, exact(n)) for n, word in enumerate(words, 1)]


def coefficients(words, bits, exact):
    """How far the coefficients are from the exact ones."""
    off = [word - exact(n) * 2**bits for n, word in enumerate(words, 1)]
    return Exact(f"each of {len(words)} coefficients", min(off), max(off), bits)


def of_constant(name, word, bits, exact):
    """How far a constant is from the exact one."""
    off = word - exact * 2**bits
    return Exact(name, off, off, bits)


def entries(name, words, bits, exact, allowed):
    """How far the entries of a table are from the exact ones."""
    off = [word - exact(i) * 2**bits for i, word in enumerate(words)]
    return Exact(name, min(off), max(off), bits, allowed)


def truncated(name, product, bits):
    """A part of a proof: what one product loses by rounding down."""
    return name, f"fixed<-{bits},dn>({product}) - {product}", bits


class Error:
    """What a page says of an error: it is in [low, high] units of 2^-bits, and the code allows what `allowed` says.
    None is no limit on that side. A bound that grows with an operand has the text of its growing part in `more`."""

    def __init__(self, name, low, high, bits, allowed="", more=""):
        self.name, self.low, self.high, self.bits, self.allowed, self.more = name, low, high, bits, allowed, more


class Exact:
    """A statement that fractions decide: an error is in [low, high] units of 2^-bits; `allowed` has two limits. None
    is no limit on that side."""

    def __init__(self, name, low, high, bits, allowed=None):
        self.name, self.low, self.high, self.bits, self.allowed = name, low, high, bits, allowed

    def check(self):
        low, high = self.allowed or (None, None)
        if low is not None and self.low < low or high is not None and self.high > high:
            raise NotProven(f"{self.name}: {interval(self.low, self.high)} units of 2^-{self.bits}")

    def found(self):
        return f"{self.name}: {interval(self.low, self.high)} units of 2^-{self.bits}"

    def text(self):
        return f"# {self.name}: by fractions"

    def question(self):
        """All that decides the rows of a page."""
        return f"{self.name} {self.low} {self.high} {self.bits} {self.allowed}"

    def errors(self):
        self.check()
        yield Error(self.name, self.low, self.high, self.bits, interval(*self.allowed) if self.allowed else "")


class Proof:
    """A statement about the code: `error` is in [low, high] units of 2^-bits. `parts` are the errors that it consists
    of: a name, Gappa's expression, and bits. `grows` describes a bound that grows with an operand: the text of the part
    that grows, the constant part, and the sign of the side."""

    def __init__(self, lines, given, error, low, high, bits, hints=(), name="sum", parts=(), grows=None):
        self.lines, self.given, self.error, self.hints = lines, given, error, hints
        self.low, self.high, self.bits = Fraction(low), Fraction(high), bits
        self.name, self.parts, self.grows = name, parts, grows

    def text(self, asked=None, error=None):
        goal = asked or f"in [{dyadic(self.low / 2**self.bits, True)},{dyadic(self.high / 2**self.bits, False)}]"
        given = "\n  /\\ ".join(self.given)
        return "\n".join([*self.lines, f"{{ {given}\n  -> {error or self.error} {goal} }}", *self.hints, ""])

    def question(self):
        """All that decides the rows of a page: what Gappa is asked, and how the page writes its answer."""
        asked = [self.text(), *(f"{name} {error} {bits}" for name, error, bits in self.parts)]
        return "\n".join([*asked, f"{self.name} {self.low} {self.high} {self.bits} {self.grows}"])

    @staticmethod
    def run(text):
        # Relative precision, for numbers of 64 or of 184 bits beside an error of the last.
        ran = subprocess.run(["gappa", "-Eprecision=400"], input=text, text=True, capture_output=True, check=False)
        # Gappa warns of its iterations a thousand times before it says what it could not prove.
        return ran.returncode, [line for line in (ran.stdout + ran.stderr).splitlines() if "iterations" not in line]

    def check(self):
        status, told = self.run(self.text())
        if status != 0 or self.has_false_hint(told):
            raise NotProven("\n".join(told))

    @staticmethod
    def has_false_hint(told):
        """Whether a hint is not an identity, for which Gappa prints only a warning."""
        return any("trivially equal" in line for line in told)

    def least(self, error=None, bits=None):
        """What Gappa finds for an error, in units."""
        _, told = self.run(self.text("in ?", error))
        for line in [] if self.has_false_hint(told) else told:
            found = re.search(r" in \[(.*?)( \{.*?\})?, (.*?)( \{.*?\})?\]$", line)
            if found:
                def value(text):
                    mantissa, _, exponent = text.partition("b")
                    return int(mantissa) * Fraction(2) ** (int(exponent or 0) + (self.bits if bits is None else bits))
                return value(found[1]), value(found[3])
        raise NotProven(f"Gappa finds no bound of {error or self.error}\n" + "\n".join(told))

    def found(self):
        low, high = map(float, self.least())
        return (f"{low:.2f} to {high:.2f} units of 2^-{self.bits}; "
                f"allowed {float(self.low):g} to {float(self.high):g}")

    def errors(self):
        for name, error, bits in self.parts:
            yield Error(name, *self.least(error, bits), bits)
        low, high = self.least()
        if not self.low <= low <= high <= self.high:
            raise NotProven(f"{self.name}: {self.found()}")
        if self.grows is None:
            yield Error(self.name, low, high, self.bits, interval(self.low, self.high))
            return
        # The statement is that the error and its allowed bound, together, have the sign of the side.
        more, constant, side = self.grows
        bound = (low - constant, None) if side < 0 else (None, high + constant)
        yield Error(self.name, *bound, self.bits, f"±({more} + {constant})", more)


def decimal(value, is_up):
    """Two digits after the point, rounded up or down; large powers of two as such."""
    value = Fraction(value)
    if value.denominator == 1 and abs(value) >= 1024 and abs(value.numerator).bit_count() == 1:
        return f"{'-' if value < 0 else ''}2^{abs(value.numerator).bit_length() - 1}"
    hundredths = math.ceil(value * 100) if is_up else math.floor(value * 100)
    return f"{hundredths / 100:.2f}".rstrip("0").rstrip(".")


def interval(low, high, more=""):
    """A bound as the pages write it."""
    if low is not None:
        low = decimal(low, False)
        if more:
            low = f"-({more} + {low.lstrip('-')})"
    if high is not None:
        high = decimal(high, True)
        if more:
            high = f"{more} + {high}"
    if low is None or high is None:
        return f"at least {low}" if high is None else f"at most {high}"
    return f"±{high}" if low == f"-{high}" else f"±({high})" if low == f"-({high})" else f"{low} to {high}"


# Constants as fractions, off by less than 2^-390.
LOG_2 = sum(Fraction(2, (2 * n + 1) * 3 ** (2 * n + 1)) for n in range(130))


def arctangent_of_reciprocal(n):
    return sum(Fraction((-1) ** k, (2 * k + 1) * n ** (2 * k + 1)) for k in range(90))


def short(value):
    return Fraction(round(value * 2**400), 2**400)


def logarithm(x):
    """The natural logarithm of a fraction from 1 to 2: 2 atanh(z) for a z of up to 1/3. Off by less than 2^-390."""
    z = short((x - 1) / (x + 1))
    square, power, total = z * z, z, Fraction(0)
    for n in range(1, 260, 2):
        total += short(power / n)
        power = short(power * square)
    return short(2 * total)


def arctangent_of(x):
    """The arctangent of a fraction from 0 to 1, from terms that fall as 1/4. Off by less than 2^-390."""
    if x > Fraction(1, 2):
        return PI / 4 - arctangent_of((1 - x) / (1 + x))
    square, power, total = short(x * x), x, Fraction(0)
    for n in range(1, 400, 2):
        total += short(power / n) * (1 if n % 4 == 1 else -1)
        power = short(power * square)
    return total


LOG_2 = short(LOG_2)
LOG2_E = short(1 / LOG_2)
PI = short(16 * arctangent_of_reciprocal(5) - 4 * arctangent_of_reciprocal(239))
LOG_10 = short(3 * LOG_2 + sum(Fraction(2, (2 * n + 1) * 9 ** (2 * n + 1)) for n in range(70)))
