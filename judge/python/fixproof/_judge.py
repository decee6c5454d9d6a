"""Calls functions on cases and has the command judge their results."""
import json
import re
import subprocess
import tempfile
from itertools import chain
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, List, Optional, Sequence, Tuple, Union

from ._command import Error, message_of, started
from ._lines import DE, Lines
from ._verdict import Verdict, verdict_of

#: About as many bytes of cases are read at a time.
_CHUNK = 1 << 16
_NO_RESULT = {"sqrt": "--negative-root", "from_binary64": "--not-finite", "div": "--divide-by-zero",
              "mul_div": "--divide-by-zero", "fmod": "--divide-by-zero",
              "remainder": "--divide-by-zero"}

Rule = Union[str, int, None]


def judge(function: Callable[..., Any], operation: str, *, format: str = "q16_16",
          to: Optional[str] = None, terms: Optional[int] = None, rounding: Optional[str] = None,
          within: Optional[str] = None, rule: Optional[str] = None, overflow: Rule = None,
          no_result: Rule = None, cases: Optional[int] = None, seed: Optional[int] = None,
          level: Optional[int] = None, show: Optional[int] = None,
          arrays: bool = False) -> Verdict:
    """Calls `function` on every case of `fixproof gen` and judges its results by `fixproof check`.

    The function takes the operands as raw integers in units of `format` and returns one in units of
    `to`, by default the same format. A word is its two's complement value: below 0 for a negative
    one of a signed format. from_binary64 takes a float, from_decimal a str, and to_decimal returns
    a str. A ZeroDivisionError, an OverflowError and the result `fixproof.DE` are a divide error.

    With `arrays`, it is called once, with a NumPy array for each operand, in the integer type that
    stores a word, and returns an array of integers. The masked elements of a masked array are `DE`.

    operation   mul, div, sqrt, add, sin ...; `fixproof check --help` lists them
    rounding    half-up, half-away, half-even, floor, ceiling, toward-zero or faithful; without it,
                the one that fits the results best
    within      in place of a rounding, the largest error: "2" ulps, or "0.5%" of the exact result
    rule        in place of a rounding, a program whose results these should be, such as doom
    overflow    what a result beyond the words should be; wrap, or saturate for functions
    no_result   what a division by zero, a negative root and so on should give; de
    cases       as many cases, evenly spread; by default all, a million of a q16_16 product
    terms, seed, level, show    those of the command

    Raises Error if something cannot be judged: an option is wrong, the command is missing, the
    function raises something else, or returns what is no word.
    """
    lines = Lines(_checked(operation), format, to)
    selected = _selection(lines, terms) + _options(
        ("--seed", seed), ("--level", level), ("--cases", cases))
    rules = _rules(operation, rounding, within, rule, overflow, no_result, show)
    generate = ["gen", *selected]
    if arrays:
        from ._arrays import results_of
        chunks = results_of(function, lines, lambda: _output(generate))
    else:
        chunks = _results(function, lines, generate)
    return _judged(["check", *selected, *rules], lines, chunks)


def check(operation: str, operands: Iterable[Any], results: Iterable[Any], *,
          format: str = "q16_16", to: Optional[str] = None, terms: Optional[int] = None,
          rounding: Optional[str] = None, within: Optional[str] = None, rule: Optional[str] = None,
          overflow: Rule = None, no_result: Rule = None, show: Optional[int] = None) -> Verdict:
    """Judges results that you have, such as those of a device, by the rules of `judge`.

    operands    a tuple for each case; an operation of one operand also takes the operand itself
    results     as many results: integers, or `fixproof.DE` for a divide error

    Raises Error as `judge` does, and if there are no cases, or more or fewer results.
    """
    lines = Lines(_checked(operation), format, to)
    taken = [_tuple_of(one) for one in operands]
    said = list(results)
    if len(taken) != len(said):
        raise Error(f"{operation}: {len(taken)} cases, but {len(said)} results; give one for each")
    rules = _rules(operation, rounding, within, rule, overflow, no_result, show)
    text = "".join(f"{lines.line_of_result(one, _place(n, 'the result is', taken[n]))}\n"
                   for n, one in enumerate(said))
    with tempfile.TemporaryDirectory() as folder:
        # The verdict shows the name.
        Path(folder, "yours").write_text(
            "".join(f"{lines.line_of_operands(one)}\n" for one in taken))
        return _judged(["check", *_selection(lines, terms), "--from", "yours", *rules], lines,
                       [text], folder)


def cases(operation: str, *, format: str = "q16_16", to: Optional[str] = None,
          terms: Optional[int] = None, cases: Optional[int] = None, seed: Optional[int] = None,
          level: Optional[int] = None) -> Iterator[Tuple[Any, ...]]:
    """Yields the operands of each case of `judge`, as tuples. The options are those of `judge`.

    Raises Error for a wrong option, and if the command is missing.
    """
    lines = Lines(_checked(operation), format, to)
    selected = _selection(lines, terms) + _options(
        ("--seed", seed), ("--level", level), ("--cases", cases))
    for chunk in _chunks(["gen", *selected]):
        yield from lines.operands_of(chunk)


def assert_right(function: Callable[..., Any], operation: str, **options: Any) -> None:
    """Raises AssertionError with the verdict as its text unless every result is right.

    For tests, in pytest or unittest. The options are those of `judge`.
    """
    __tracebackhide__ = True
    verdict = judge(function, operation, **options)
    if not verdict:
        raise AssertionError(f"{_name(function)} is not right\n{verdict}")


def _results(function: Callable[..., Any], lines: Lines, generate: List[str]) -> Iterator[str]:
    """Yields the results of the function as lines, many at a time."""
    number = 0
    low, high = lines.results.lowest, lines.results.highest
    mask = (1 << 8 * lines.results.bytes) - 1
    form = f"%0{2 * lines.results.bytes}x\n"
    is_text = lines.operation == "to_decimal"
    for chunk in _chunks(generate):
        said_lines = []
        for operands in lines.operands_of(chunk):
            try:
                said = function(*operands)
            except (ZeroDivisionError, OverflowError):
                said = DE
            except Exception as error:
                place = _place(number, f"{_name(function)}{_call(operands)} raised", ())
                raise Error(f"{place} {type(error).__name__}: {error}; a divide error is a "
                            "ZeroDivisionError or an OverflowError") from error
            if type(said) is int and low <= said <= high and not is_text:
                said_lines.append(form % (said & mask))
            else:
                place = _place(number, f"{_name(function)}{_call(operands)} returned", ())
                said_lines.append(lines.line_of_result(said, place) + "\n")
            number += 1
        yield "".join(said_lines)


def _judged(arguments: List[str], lines: Lines, chunks: Iterable[str],
            folder: Optional[str] = None) -> Verdict:
    """Sends the results to the command, and returns its verdict."""
    with started([*arguments, "--json", "-"], subprocess.PIPE, folder) as checker:
        assert checker.stdin
        try:
            for chunk in chunks:
                checker.stdin.write(chunk.encode())
                checker.stdin.flush()
        except BrokenPipeError:
            pass  # The command has refused something, and says so below.
        out, err = checker.communicate()
        # 0: all results are right. 1: some are wrong.
        if checker.returncode not in (0, 1) or not out:
            raise Error(message_of(err, checker.returncode))
        return verdict_of(json.loads(out), lines)


def _chunks(generate: List[str]) -> Iterator[Sequence[bytes]]:
    """Yields the lines of the command, many at a time."""
    with started(generate) as generator:
        assert generator.stdout and generator.stderr
        while True:
            lines = generator.stdout.readlines(_CHUNK)
            if not lines:
                break
            yield lines
        err = generator.stderr.read()
        if generator.wait() != 0:
            raise Error(message_of(err, generator.returncode))


def _output(generate: List[str]) -> List[bytes]:
    return list(chain.from_iterable(_chunks(generate)))


def _checked(operation: str) -> str:
    # A name that starts with a dash would be an option of the command.
    if isinstance(operation, str) and re.fullmatch(r"[a-z][a-z0-9_]*", operation):
        return operation
    raise Error(f"operation {operation!r}: choose mul, div, sqrt or another of "
                "`fixproof check --help`")


def _options(*options: Tuple[str, Any]) -> List[str]:
    return [f"{name}={value}" for name, value in options if value is not None]


def _selection(lines: Lines, terms: Optional[int]) -> List[str]:
    to = lines.results.name if lines.results is not lines.operands else None
    return [lines.operation,
            *_options(("--format", lines.operands.name), ("--to", to), ("--terms", terms))]


def _rules(operation: str, rounding: Optional[str], within: Optional[str], rule: Optional[str],
           overflow: Rule, no_result: Rule, show: Optional[int]) -> List[str]:
    if rounding is None and within is None and rule is None:
        rounding = "best"
    return _options(("--rounding", rounding), ("--within", within), ("--rule", rule),
                    ("--overflow", overflow),
                    (_NO_RESULT.get(operation, "--outside-domain"), no_result), ("--show", show))


def _tuple_of(operands: Any) -> Tuple[Any, ...]:
    if isinstance(operands, (str, float)) or hasattr(operands, "__index__"):
        return (operands,)
    return tuple(operands)


def _name(function: Callable[..., Any]) -> str:
    return getattr(function, "__name__", type(function).__name__)


def _call(operands: Tuple[Any, ...]) -> str:
    return f"({', '.join(map(repr, operands))})"


def _place(index: int, what: str, operands: Tuple[Any, ...]) -> str:
    return f"case {index + 1:,}{' ' + _call(operands) if operands else ''}: {what}"
