"""Judges fixed-point arithmetic that is written or wrapped in Python, by the command `fixproof`.

>>> import fixproof
>>> def multiply(a, b):
...     return fixproof.Format("q16_16").wrap((a * b + 0x8000) >> 16)
>>> verdict = fixproof.judge(multiply, "mul", cases=20_000)
>>> verdict.right, verdict.rounding
(True, 'half-up')

Words are plain integers: the two's complement value, in units of the format, so 1.5 in q16_16 is
98304. `judge` calls a function on the cases of `fixproof gen`, `check` judges results that you
have, `assert_right` is for tests, `cases` yields the cases, and `fixproof.strategies` has
strategies for Hypothesis.
"""
from ._command import Error, command
from ._format import Format
from ._judge import DE, assert_right, cases, check, judge
from ._verdict import Example, Verdict
from ._version import __version__

__all__ = ["DE", "Error", "Example", "Format", "Verdict", "__version__", "assert_right", "cases",
           "check", "command", "judge"]
