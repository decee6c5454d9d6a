"""Operands and results as the lines of `fixproof gen` and `fixproof check`."""
import struct
from typing import Any, Iterator, NoReturn, Sequence, Tuple

from ._command import Error
from ._format import Format

#: The result of a case that has none: a divide error.
DE = "DE"


class Lines:
    """The lines of an operation, in both directions."""

    def __init__(self, operation: str, format: str, to: Any) -> None:
        self.operation = operation
        self.operands = Format(format)
        self.results = self.operands if to is None else Format(to)

    def operands_of(self, lines: Sequence[bytes]) -> Iterator[Tuple[Any, ...]]:
        """Yields the operands of each line: integers, or a float of from_binary64, or the text of
        from_decimal."""
        if not lines:
            return iter(())
        if self.operation == "from_decimal":
            return ((line.decode().strip(),) for line in lines)
        try:
            return self._unpacked(lines)
        except (ValueError, struct.error) as error:
            raise Error(f"{self.operation}: its cases are no words of {self.operands.name}; choose "
                        "an operation of `fixproof check --help`") from error

    def _unpacked(self, lines: Sequence[bytes]) -> Iterator[Tuple[Any, ...]]:
        code = "d" if self.operation == "from_binary64" else self.operands.code
        count = len(lines[0].split())
        return struct.iter_unpack(f">{count}{code}", bytes.fromhex(b"".join(lines).decode()))

    def line_of_operands(self, operands: Tuple[Any, ...]) -> str:
        """Returns a case as a line. Raises Error for what is no word of the format."""
        if self.operation == "from_decimal":
            return _printed(operands[0], f"operands {operands}:")
        if self.operation == "from_binary64":
            try:
                return struct.pack(">d", operands[0]).hex()
            except struct.error:
                raise Error(
                    f"operands {operands}: {operands[0]!r} is no float; write one") from None
        place = f"operands {operands}:"
        return " ".join(self._hex(self._index(word, self.operands, f"{place} {word!r}"),
                                  self.operands) for word in operands)

    def line_of_result(self, said: Any, place: str) -> str:
        """Returns a result as a line. `place` names the case in the Error for what is no result."""
        if self.operation == "to_decimal":
            return _printed(said, place)
        if isinstance(said, str) and said == DE:
            return DE
        return self._hex(self._index(said, self.results, f"{place} {said!r}"), self.results)

    @staticmethod
    def _index(said: Any, format: Format, place: str) -> int:
        try:
            word = said.__index__()
        except (AttributeError, TypeError):
            _refuse_type(said, format, place)
        if word in format:
            return word
        raise Error(f"{place}, which is no word of {format.name} ({format.lowest} to "
                    f"{format.highest}); {out_of_range_fix(word, format)}")

    @staticmethod
    def _hex(word: int, format: Format) -> str:
        return f"{word & ((1 << 8 * format.bytes) - 1):0{2 * format.bytes}x}"


def _printed(text: Any, place: str) -> str:
    """Returns the text of a decimal number, which must be a line of its own."""
    if isinstance(text, str) and text.isprintable() and text.strip() and not text.startswith("#"):
        return text
    raise Error(f"{place} {text!r}, which is no decimal number; write a str such as '-1.5'")


def out_of_range_fix(word: int, format: Format) -> str:
    """Returns what to do about a result beyond the words of the format."""
    if format.signed and 0 <= word < 1 << format.bits:
        return (f"return the two's complement value, {format.wrap(word)}, "
                f"as Format({format.name!r}).wrap does")
    return "wrap or saturate it, or raise OverflowError"


def _refuse_type(said: Any, format: Format, place: str) -> NoReturn:
    if said is None:
        raise Error(
            f"{place}, which is no result; return an int, or fixproof.DE for a divide error")
    kind = type(said).__name__
    if isinstance(said, float):
        fix = f"return the integer in units of {format.name}"
    elif getattr(said, "shape", None):
        fix = "return one int for each call, or judge whole arrays with arrays=True"
    else:
        fix = "return an int"
    raise Error(f"{place}, which is of type {kind}; {fix}")


def decoded(lines: Lines, text: Any) -> Any:
    """Returns a result of the command as a Python value: an int, DE, the text of to_decimal, or
    None if every result is accepted."""
    if text is None or text == DE or lines.operation == "to_decimal":
        return text
    return struct.unpack(f">{lines.results.code}", bytes.fromhex(text))[0]
