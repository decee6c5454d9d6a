"""Checks the proof pages, docs/functions/*.md. Their tables of errors have exactly what the proofs find. Exactly one of
the pages names each function in its first lines."""
import os
import re
import sys

from bounds.gappa import Error, NotProven, interval

HEADER = "| error of | proven | in units of | the code allows | proof |"


def merged(errors):
    """Merges the errors of one name, which have a proof for each sign or for each side of a bound."""
    by_name = {}
    for error in errors:
        same = by_name.setdefault(error.name, error)
        if (same.bits, same.allowed, same.more) != (error.bits, error.allowed, error.more):
            raise NotProven(f"two errors are called '{error.name}'")
        lows = [e.low for e in (same, error) if e.low is not None]
        highs = [e.high for e in (same, error) if e.high is not None]
        by_name[error.name] = Error(error.name, min(lows, default=None), max(highs, default=None), error.bits,
                                    error.allowed, error.more)
    return by_name.values()


def rows(name, proofs):
    """The rows of a proof."""
    try:
        errors = merged(error for proof in proofs for error in proof.errors())
    except NotProven as error:
        raise NotProven(f"{name}: {error}") from error
    cells = ((e.name, interval(e.low, e.high, e.more), f"2^-{e.bits}" if e.bits else "1", e.allowed, f"`{name}`")
             for e in errors)
    return [f"| {' | '.join(row)} |".replace("|  |", "| |") for row in cells]


def rows_of_page(path):
    """The lines of a page's tables of errors, with their numbers."""
    inside = False
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            line = line.rstrip("\n")
            inside = line == HEADER or (inside and line.startswith("|"))
            if inside and line != HEADER and not line.startswith("| ---"):
                yield number, line


def differences(proofs, source, folder, is_whole=True, decided=None):
    """How many errors the proofs find, and a message for each row that only the pages or only the proofs have. If
    these are not all proofs, ignores the rows of the others. A proof that is `decided`, with the rows that the pages
    have, is not run again."""
    there, wrong, count = {}, [], 0
    names = {prove.__name__ for prove in proofs}
    for name in sorted(os.listdir(folder)):
        for number, line in rows_of_page(os.path.join(folder, name)):
            if not is_whole and line.split("`")[-2] not in names:
                continue
            if line in there:
                wrong.append(f"{name}:{number}: also at {there[line]}: {line}")
            there[line] = f"{name}:{number}"
    for prove in proofs:
        stated = [row for row in there if row.split("`")[-2] == prove.__name__]
        statements = list(prove(source))
        question = "\n".join([*(statement.question() for statement in statements), *stated])
        is_known = decided is not None and decided.has(question, prove.__name__)
        found = stated if is_known else rows(prove.__name__, statements)
        count += len(found)
        wrong += [f"on no page: {row}" for row in found if there.pop(row, None) is None]
    return count, wrong + [f"{place}: not proven: {row}" for row, place in there.items()]


def declared_in(source, header):
    path = os.path.join(os.path.dirname(source.folder.rstrip("/")), f"{header}.hpp")
    with open(path, encoding="ascii") as file:
        return set(re.findall(r"constexpr\s+number<Raw, Point, Rules>\s+(\w+)\(", file.read()))


def in_table_of_functions(folder):
    """The functions in the first table of functions.md, which is beside the folder of pages."""
    with open(os.path.join(folder, os.pardir, "functions.md"), encoding="utf-8") as file:
        table = re.search(r"(?:^\|.*\n)+", file.read(), re.M)[0]
    return {name for row in table.splitlines() for name in re.findall(r"`(\w+)[`(]", row.split("|")[1])}


def without_page(source, folder):
    """A message for each function of the headers unless exactly one page names it before its first "## " heading. The
    last three headers declare other functions, too; only those in the table of functions count."""
    declared = set().union(*(declared_in(source, name) for name in ("exponential", "trigonometry", "angle", "power")))
    others = set().union(*(declared_in(source, name) for name in ("math", "cmath", "wide")))
    declared |= others & in_table_of_functions(folder)
    named = []
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            named += set(re.findall(r"`(\w+)`", file.read().split("\n## ")[0])) & declared
    return [f"{function}() has {named.count(function)} pages, not one" for function in sorted(declared)
            if named.count(function) != 1]


def check(proofs, source, folder, decided):
    try:
        count, wrong = differences(proofs, source, folder, decided=decided)
        wrong += without_page(source, folder)
    except NotProven as error:
        sys.exit(f"not proven\n{error}")
    if wrong or not count:
        wrong.append(f"{len(wrong)} differences: `prove_bounds --rows` prints the rows that are proven")
        sys.exit("\n".join(wrong))
    print(f"{count} errors are on the pages as they are proven; {decided.summary()}")
