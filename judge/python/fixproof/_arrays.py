"""Functions of whole NumPy arrays."""
from typing import Any, Callable, Iterator, List

from ._command import Error
from ._lines import DE, Lines, out_of_range_fix

try:
    import numpy
except ImportError as missing:
    raise Error("arrays=True needs NumPy; install it (Debian: python3-numpy, pip: numpy), or leave "
                "arrays out") from missing


def results_of(function: Callable[..., Any], lines: Lines,
               generate: Callable[[], List[bytes]]) -> Iterator[str]:
    """Calls the function once, and yields all of its results as lines."""
    if "decimal" in lines.operation:
        raise Error(f"{lines.operation}: numbers as text are no array; leave arrays out")
    operands = _arrays(generate(), lines)
    name = getattr(function, "__name__", type(function).__name__)
    try:
        said = function(*operands)
    except (ZeroDivisionError, OverflowError) as error:
        raise Error(f"{name} raised {type(error).__name__} for a whole array; return a masked "
                    "array (numpy.ma), whose masked elements are divide errors") from error
    except Exception as error:
        raise Error(f"{name} raised {type(error).__name__} for {len(operands[0])} cases: "
                    f"{error}") from error
    yield _lines_of(said, operands, lines, name)


def _arrays(cases: List[bytes], lines: Lines) -> List[Any]:
    """Returns an array for each operand."""
    is_double = lines.operation == "from_binary64"
    dtype = numpy.dtype("float64" if is_double else lines.operands.dtype)
    count = len(cases[0].split())
    try:
        data = bytes.fromhex(b"".join(cases).decode())
        table = numpy.frombuffer(data, dtype.newbyteorder(">")).reshape(len(cases), count)
    except ValueError as error:
        raise Error(f"{lines.operation}: its cases are no words of {lines.operands.name}; choose "
                    "an operation of `fixproof check --help`") from error
    return [table[:, i].astype(dtype) for i in range(count)]


def _lines_of(said: Any, operands: List[Any], lines: Lines, name: str) -> str:
    """Raises Error for what is no array of results."""
    results, format = numpy.ma.asarray(said), lines.results
    shape = operands[0].shape
    if results.shape != shape:
        raise Error(f"{name} returned an array of shape {results.shape} for operands of shape "
                    f"{shape}; return one result for each case")
    if results.dtype.kind not in "iu":
        raise Error(f"{name} returned an array of {results.dtype}; return integers in units of "
                    f"{format.name}, such as an array of {format.dtype}")
    masked = numpy.ma.getmaskarray(results)
    words = results.filled(0)
    beyond = ((words < format.lowest) | (words > format.highest)) & ~masked
    if beyond.any():
        i = int(beyond.argmax())
        word = int(words[i])
        call = ", ".join(str(one[i]) for one in operands)
        raise Error(f"case {i + 1:,}: {name} returned {word} for ({call}), which is no word of "
                    f"{format.name} ({format.lowest} to {format.highest}); "
                    f"{out_of_range_fix(word, format)}")
    stored = numpy.where(masked, 0, words).astype(f">{format.dtype[0]}{format.bytes}")
    text = stored.tobytes().hex("\n", format.bytes)
    if masked.any():
        rows = text.split("\n")
        for i in masked.nonzero()[0]:
            rows[i] = DE
        text = "\n".join(rows)
    return text + "\n"
