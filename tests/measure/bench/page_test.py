#!/usr/bin/env python3
"""usage: page_test.py ROOT

The tables of docs/performance.md, from results that are made up.
"""

import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1] + "/measure/bench")
import page  # noqa: E402
import performance  # noqa: E402


def result(name, ns, error=0.5, ours=False, shape="batch", elements=64, operation="multiply"):
    return {"operation": operation, "shape": shape, "elements": elements, "offset": 0, "name": name, "ours": ours,
            "error": error, "ns": ns}


def expect(found, expected):
    if found != expected:
        sys.exit(f"expected {expected!r}, found {found!r}")


# The fastest peer is wrong, so it is no peer: the ratio is that of the idiom.
rows = [result("batch", 2, ours=True), result("idiom, rounds down", 1, error=0.99), result("idiom", 3),
        result("Highway", 4)]
cell = next(iter(page.cells(rows).values()))
expect(page.best_peer(cell)["name"], "idiom")
expect(page.ratio(cell), 1.5)
expect(page.label(rows[1]), "up to 0.99 ulp")
expect(page.label(rows[2]), "exact")
assert "| ir | idiom, rounds down | up to 0.99 ulp: multiply |" in page.peers({"build": rows})

# An error in one shape holds for all: in a chain, the wrong peer had no chance to be wrong.
chain = [result("idiom, rounds down", 1, error=0.4, shape="chain"), result("idiom, rounds down", 1, error=0.99)]
expect([r["error"] for r in performance.merge([chain])], [0.99, 0.99])
# Of several passes the mean of the middle half counts.
expect(performance.merge([[result("idiom", ns)] for ns in (9, 1, 4, 8, 2, 8, 3, 9)])[0]["ns"], (3 + 4 + 8 + 8) / 4)

# Cells below 1 are listed with the peer and the span, and bold in the table of the build; others are neither.
slow = [result("batch", 4, ours=True, elements=8), result("idiom", 1, elements=8)]
assert "| multiply | batch, below 64 | 0.25 i: 8 |" in page.below({"build": rows + slow})
assert "batch, 64 or more" not in page.below({"build": rows + slow})
assert "| **0.25** i |" in page.matrix(rows + slow) and "| 1.50 i |" in page.matrix(rows + slow)

# What has no limit with a name is a tie or shows none.
for ns, bound in ((0.98, "a tie"), (0.9, "")):
    loop = [result("type", 1, ours=True, shape="loop"), result("idiom", ns, shape="loop")]
    assert f"| multiply | loop | {ns:.2f} i | {bound} |" in page.below({"build": loop})

# Only what is between the marks is replaced; peers that are missing are counted.
context = {"machine": "a machine", "compilers": ["a compiler"], "date": "today", "missing": {"build": ["SLEEF"]}}
text = page.replaced(f"before\n{page.BEGIN}\nold\n{page.END}\nafter\n", context, {"build": rows})
assert text.startswith("before\n") and text.endswith(f"{page.END}\nafter\n") and "old" not in text
assert "Not installed, so not compared: 1, SLEEF (build)." in text
try:
    page.replaced("no marks", context, {"build": rows})
    sys.exit("a page without marks is accepted")
except page.Damaged:
    pass
