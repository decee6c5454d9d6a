"""The verdict on a function's results."""
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

from ._lines import Lines, decoded


@dataclass(frozen=True)
class Example:
    """A wrong result."""

    #: The number of the case, from 1.
    case: int
    #: The stream of the case, such as `lattice`, or `cases of yours`.
    stream: str
    #: The operands as the function took them.
    operands: Tuple[Any, ...]
    #: The right result: a word, DE, or the text of to_decimal.
    expected: Any
    #: The function's result.
    said: Any
    #: Where the exact result lies, such as `tie` or `overflow`.
    kind: str
    #: All of it in a line.
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, repr=False)
class Verdict:
    """What `fixproof check` finds. It is true if all results are right, and prints as the command
    does."""

    #: Whether every result is right, and every promise of `within` is kept.
    right: bool
    #: The number of cases.
    cases: int
    #: The number of wrong results.
    wrong: int
    #: The first wrong results, of each kind in turn: at most `show`.
    examples: Tuple[Example, ...]
    #: The rounding that fits the results best, such as `floor`; None if results are exact or none
    #: is in range. `exceptions` says how well it fits.
    rounding: Optional[str]
    #: The number of results in range that do not follow `rounding`.
    exceptions: int
    #: The programs whose arithmetic gives all these results, such as `doom`.
    follows: Tuple[str, ...]
    #: The verdict as the command prints it.
    text: str

    def __bool__(self) -> bool:
        return self.right

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<Verdict: {self.wrong} of {self.cases} results wrong, rounding {self.rounding}>"


def verdict_of(document: Dict[str, Any], lines: Lines) -> Verdict:
    """Returns the verdict of a document that `fixproof check --json` wrote."""
    rounding = document["rounding"] or {"best": None, "exceptions": 0}
    return Verdict(
        right=document["right"], cases=document["cases"], wrong=document["wrong"],
        examples=tuple(_example_of(one, lines) for one in document["examples"]),
        rounding=rounding["best"], exceptions=rounding["exceptions"],
        follows=tuple(document["follows"]), text=document["text"].rstrip("\n"))


def _example_of(one: Dict[str, Any], lines: Lines) -> Example:
    operands = next(lines.operands_of([one["operands"].encode()]))
    return Example(case=one["case"], stream=one["stream"], operands=operands,
                   expected=decoded(lines, one["expected"]), said=decoded(lines, one["said"]),
                   kind=one["kind"], text=one["text"])
