"""Writes proofs in Gappa's language, runs them, and reads the code's constants."""
import math
import re
import subprocess
from fractions import Fraction


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


class Proof:
    """A statement about the code: `error` is in [low, high] units of 2^-bits."""

    def __init__(self, lines, given, error, low, high, bits, hints=()):
        self.lines, self.given, self.error, self.hints = lines, given, error, hints
        self.low, self.high, self.bits = Fraction(low), Fraction(high), bits

    def text(self, asked=None):
        goal = asked or f"in [{dyadic(self.low / 2**self.bits, True)},{dyadic(self.high / 2**self.bits, False)}]"
        given = "\n  /\\ ".join(self.given)
        return "\n".join([*self.lines, f"{{ {given}\n  -> {self.error} {goal} }}", *self.hints, ""])

    @staticmethod
    def run(text):
        # Relative precision, for numbers of 64 or of 184 bits beside an error of the last.
        ran = subprocess.run(["gappa", "-Eprecision=400"], input=text, text=True, capture_output=True, check=False)
        # Gappa warns of its iterations a thousand times before it says what it could not prove.
        return ran.returncode, [line for line in (ran.stdout + ran.stderr).splitlines() if "iterations" not in line]

    def check(self):
        status, told = self.run(self.text())
        # A hint that is no identity is only a warning.
        if status != 0 or any("trivially equal" in line for line in told):
            raise NotProven("\n".join(told))

    def least(self):
        """What Gappa finds for the error, in units."""
        _, told = self.run(self.text("in ?"))
        for line in told:
            found = re.search(r" in \[(.*?)( \{.*?\})?, (.*?)( \{.*?\})?\]$", line)
            if found:
                def value(text):
                    mantissa, _, exponent = text.partition("b")
                    power = Fraction(2) ** int(exponent or 0)
                    return float(int(mantissa) * power * 2**self.bits)
                return value(found[1]), value(found[3])
        return None


# Constants as fractions, off by less than 2^-390.
LOG_2 = sum(Fraction(2, (2 * n + 1) * 3 ** (2 * n + 1)) for n in range(130))


def arctangent_of_reciprocal(n):
    return sum(Fraction((-1) ** k, (2 * k + 1) * n ** (2 * k + 1)) for k in range(90))


def short(value):
    return Fraction(round(value * 2**400), 2**400)


LOG_2 = short(LOG_2)
LOG2_E = short(1 / LOG_2)
PI = short(16 * arctangent_of_reciprocal(5) - 4 * arctangent_of_reciprocal(239))
LOG_10 = short(3 * LOG_2 + sum(Fraction(2, (2 * n + 1) * 9 ** (2 * n + 1)) for n in range(70)))
