"""Arithmetic to be judged: right, and with planted defects. Operands and results are words of
q16_16."""
MASK = 0xFFFFFFFF


def wrap(value):
    """The word that equals the value modulo 2**32, written apart from the package's."""
    value &= MASK
    return value - (1 << 32) if value & 0x80000000 else value


def half_up(a, b):
    return wrap((a * b + 0x8000) >> 16)


def floor(a, b):
    return wrap((a * b) >> 16)


def lost_carry(a, b):
    """As `add eax, 8000h` without `adc edx, 0`: the carry of the low half is lost."""
    product = a * b
    low = ((product & MASK) + 0x8000) & MASK
    return wrap(((product & ~MASK) | low) >> 16)


def ties_wrong_below_zero(a, b):
    """Half up, but a tie below zero goes down."""
    tie = (a * b) & 0xFFFF == 0x8000
    return floor(a, b) if tie and a * b < 0 else half_up(a, b)


def quotient(a, b):
    """Toward zero; Python raises ZeroDivisionError."""
    magnitude = (abs(a) << 16) // abs(b)
    return wrap(magnitude if (a < 0) == (b < 0) else -magnitude)
