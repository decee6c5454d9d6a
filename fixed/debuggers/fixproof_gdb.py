"""Shows numbers of namespace fixproof in gdb by value: q16_16 -0.75 (0xffff4000).

(gdb) source fixproof_gdb.py
"""

import decimal
import re

import gdb
import gdb.printing

# The presets by their rules, in the order of struct policy: multiply, divide, range, divisor, fault. In all of them,
# products and quotients are 3: as_range.
SUFFIXES = {
    (0, 0, 0, 0, 0): "",
    (0, 0, 1, 0, 0): "_saturating",
    (0, 0, 2, 0, 0): "_trapping",
    (0, 1, 0, 0, 2): "_i386",
    (0, 3, 0, 0, 3): "_i386_mul_rounded",
    (2, 1, 0, 0, 2): "_i386_div_rounded",
    (2, 3, 0, 0, 3): "_i386_unrounded",
    (1, 1, 0, 1, 1): "_i8088",
    (1, 3, 0, 1, 1): "_i8088_mul_rounded",
    (3, 1, 0, 1, 1): "_i8088_div_rounded",
    (3, 3, 0, 1, 1): "_i8088_unrounded",
}


def type_name(value_type, letter, whole_bits, fraction_bits):
    """The alias the value was declared with; else the preset, as far as the name of the type tells."""
    alias = re.fullmatch(r"(?:const |volatile )*(?:fixproof::)?([qu]\d+_\d+\w*)", str(value_type))
    if alias:
        return alias[1]
    # "fixproof::number<int, 16, fixproof::policy{(fixproof::rounding)1, ...}>" of g++, "{1, ...}" of clang.
    policy = str(value_type.strip_typedefs()).partition("{")[2]
    rules = tuple(map(int, re.findall(r"(?:^|, )(?:\(fixproof::\w+\))?(\d)", policy)))
    suffix = SUFFIXES.get(rules[:5], "") if rules[5:7] == (3, 3) else ""
    return f"{letter}{whole_bits}_{fraction_bits}{suffix}"


class NumberPrinter:
    """One fixproof::number."""

    def __init__(self, value):
        self.value = value
        tag = value.type.strip_typedefs().unqualified().name
        self.fraction_bits = int(re.match(r"fixproof::number<[\w ]+, (\d+)", tag)[1])

    def to_string(self):
        raw = int(self.value["raw_"])
        raw_type = self.value["raw_"].type.strip_typedefs()
        bits = 8 * raw_type.sizeof
        # Exact: at most 20 digits before the point and 64 after it.
        with decimal.localcontext() as context:
            context.prec = 100
            text = f"{decimal.Decimal(raw) / (1 << self.fraction_bits):f}"
        word = raw & ((1 << bits) - 1)
        letter = "u" if "unsigned" in raw_type.name else "q"
        name = type_name(self.value.type, letter, bits - self.fraction_bits, self.fraction_bits)
        return f"{name} {text} (0x{word:0{bits // 4}x})"


def printers():
    collection = gdb.printing.RegexpCollectionPrettyPrinter("fixproof")
    collection.add_printer("number", r"^fixproof::number<[\w ]+, \d+,.*>$", NumberPrinter)
    return collection


gdb.printing.register_pretty_printer(None, printers(), replace=True)
