#!/usr/bin/env python3
"""The CORDIC of cordic.c in Python. It returns the same words."""
import math
import sys

STEPS, ONE = 29, 1 << 29
ANGLES = {False: [round(math.atan(2.0**-i) * ONE) for i in range(STEPS)],
          True: [0] + [round(math.atanh(2.0**-i) * ONE) for i in range(1, STEPS)]}
HALF_TURN, LN2 = round(math.pi * ONE), round(math.log(2) * ONE)
GAIN, HYPERBOLIC_GAIN = 326016437, 648270052


def turn(x, y, z, measure=False, hyperbolic=False):
    """Turns x, y until its angle z is 0 or, to measure its angle, until y is 0."""
    steps = range(STEPS)
    if hyperbolic:  # Without steps 4 and 13 twice it does not reach every angle.
        steps = sorted([*range(1, STEPS), 4, 13])
    for i in steps:
        sign = 1 if (y < 0 if measure else z >= 0) else -1
        dx = sign * (y >> i)
        x, y = (x + dx if hyperbolic else x - dx), y + sign * (x >> i)
        z -= sign * ANGLES[hyperbolic][i]
    return x, y, z


def rounded(value, bits):
    return (value + (1 << bits >> 1)) >> bits


def sin(a, _, part=1):
    a = int(math.fmod(a, 411775))  # 2 pi
    turns = sum(a > limit for limit in (102944, 308831)) - sum(a < -limit for limit in (102944, 308831))
    result = rounded(turn(GAIN, 0, (a << 13) - turns * HALF_TURN)[part], 13)
    return -result if turns % 2 else result


def cos(a, b):
    return sin(a, b, 0)


def atan2(y, x):
    if x == 0 and y == 0:
        return 0
    start = 0 if x >= 0 else HALF_TURN if y >= 0 else -HALF_TURN
    if x < 0:
        x, y = -x, -y
    bits = max(x, abs(y)).bit_length()
    x, y = (v << 29 - bits if bits <= 29 else int(v / 2**(bits - 29)) for v in (x, y))
    return rounded(turn(x, y, start, measure=True)[2], 13)


def exp(a, _):
    if a > 681391:
        return 0x7FFFFFFF
    if a < -772243:
        return 0
    power = a * 94548 >> 32
    x, y, _ = turn(HYPERBOLIC_GAIN, 0, (a << 13) - power * LN2, hyperbolic=True)
    return rounded(x + y, 13 - power) if power <= 13 else x + y << power - 13


def signed(word):
    return (int(word, 16) + (1 << 31)) % (1 << 32) - (1 << 31)


function = {"sin": sin, "cos": cos, "atan": atan2, "atan2": atan2, "exp": exp}[sys.argv[1]]
for line in sys.stdin:
    operands = [signed(word) for word in line.split()]
    print(f"{function(operands[0], operands[1] if len(operands) == 2 else 65536) & 0xFFFFFFFF:08x}")
