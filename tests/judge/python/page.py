"""The examples of docs/python.md, as doctests."""
import doctest
import re
from pathlib import Path

PAGE = Path(__file__).parents[3] / "docs" / "python.md"
#: What an example with these words needs is no part of Python.
NEEDS_MORE = ("numpy", "hypothesis")


def failures(more):
    """Runs the examples in their order, with `more` those that need other packages too. Returns how
    many ran, and what failed as text."""
    names, said = {}, []
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS, verbose=False)
    text = PAGE.read_text()
    for match in re.finditer(r"^```pycon\n(.*?)^```$", text, re.M | re.S):
        if not more and any(word in match[1] for word in NEEDS_MORE):
            continue
        line = text.count("\n", 0, match.start()) + 1
        test = doctest.DocTestParser().get_doctest(match[1], names, PAGE.name, str(PAGE), line)
        runner.run(test, out=said.append, clear_globs=False)
        names = test.globs
    return runner.tries, "".join(said)
