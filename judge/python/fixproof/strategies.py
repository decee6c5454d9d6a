"""Strategies for Hypothesis: words and operands where fixed-point arithmetic breaks.

>>> from hypothesis import given
>>> from fixproof import strategies
>>> @given(strategies.operands("mul", "q16_16"))
... def test_product_commutes(pair):
...     a, b = pair
...     assert multiply(a, b) == multiply(b, a)
"""
from functools import lru_cache
from typing import Any, List, Optional, Set, Tuple

from ._command import Error
from ._format import Format
from ._judge import cases

try:
    from hypothesis import strategies as _st
except ImportError as missing:
    raise Error("fixproof.strategies needs Hypothesis; install it (Debian: python3-hypothesis, "
                "pip: hypothesis)") from missing

#: As many cases of an operation are drawn from.
_CASES = 10_000
#: Words this far from a special one are drawn too: the wrap boundaries are within.
_NEAR = 2


def words(format: str = "q16_16") -> "_st.SearchStrategy[int]":
    """Draws words of a format as integers: the ends of the range, words next to 0, to a half, to
    whole numbers and to powers of two, and any others. They shrink toward 0. Wrapping takes what is
    beyond an end to the other end. Raises Error for what is no format."""
    range_of = Format(format)
    one = max(1, int(range_of.one))
    powers = {1 << bit for bit in range(range_of.bits)}
    special = _words_among(range_of, {0, one, one // 2, one + one // 2, *powers})
    edges = [range_of.highest, range_of.lowest, *_words_among(range_of, {0, 1, one // 2, one})]
    near = _st.builds(lambda value, step: range_of.wrap(value + step), _st.sampled_from(special),
                      _st.integers(-_NEAR, _NEAR))
    whole = _st.builds(lambda count, step: range_of.wrap(count * one + step),
                       _st.integers(range_of.lowest // one, range_of.highest // one),
                       _st.integers(-_NEAR, _NEAR))
    return _st.one_of(_st.integers(range_of.lowest, range_of.highest), _st.sampled_from(edges),
                      near, whole)


def operands(operation: str, format: str = "q16_16",
             to: Optional[str] = None) -> "_st.SearchStrategy[Tuple[Any, ...]]":
    """Draws tuples of operands: cases of `fixproof gen`, which has ties, what lies next to a tie,
    the ends of the range and of the domain, and results about to wrap; the same with operands a few
    units off; and words(). Raises Error as `fixproof.cases` does."""
    known = _known(operation, format, to)
    drawn = _st.sampled_from(known)
    if not all(isinstance(one, int) for one in known[0]):
        return drawn
    range_of = Format(format)
    shifted = drawn.flatmap(lambda case: _st.tuples(*(
        _st.integers(-_NEAR, _NEAR).map(lambda step, word=word: range_of.wrap(word + step))
        for word in case)))
    return _st.one_of(_st.tuples(*(words(format) for _ in known[0])), drawn, shifted)


@lru_cache(maxsize=None)
def _known(operation: str, format: str, to: Optional[str]) -> Tuple[Tuple[Any, ...], ...]:
    return tuple(cases(operation, format=format, to=to, cases=_CASES))


def _words_among(range_of: Format, values: Set[int]) -> List[int]:
    """Returns the values and their negatives that are words, the smallest first."""
    both = {sign * value for value in values for sign in (1, -1)}
    return sorted((value for value in both if value in range_of),
                  key=lambda value: (abs(value), value < 0))
