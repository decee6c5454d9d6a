"""The tables of docs/performance.md, from the results of measure/bench/performance.py."""

BEGIN, END = "<!-- begin: tests/tools/performance -->", "<!-- end: tests/tools/performance -->"
NONE = "–"
# Peers in cells: the table has no room for names.
CODES = {"idiom": "i", "idiom, one rounding": "i1", "idiom, rounds down": "ir", "idiom, truncates": "it", "double": "d",
         "float": "f", "rint": "r", "floor": "fl", "libfixmath": "x", "FreeType": "ft", "Highway": "h", "libmvec": "m",
         "SLEEF": "s", "Eigen, double": "e", "Eigen, float arrays": "ef"}
COPIES = "copy of vertices"
SPANS = ((1, 0), (4, 0), (8, 0), (15, 0), (16, 0), (31, 0), (64, 0), (64, 4), (64, 16), (4096, 0), (4096, 4),
         (4096, 16), (1_000_000, 0))
TIE = 0.97  # and above: single cells differ by this much from run to run
SHAPES = {"chain": "chain", "loop": "loop", "short": "batch, below 64", "long": "batch, 64 or more",
          "memory": "batch, millions"}
LAYOUTS = ("columns", "interleaved")
TRANSFORMS = [f"{kind}, {layout}" for layout in LAYOUTS for kind in ("transform", "fused transform")]
# Transforms round each product, as FIXED.ASM does, so their sums are up to three halves away. Fused ones round once.
ROUNDINGS = {f"transform, {layout}": 3 for layout in LAYOUTS}
# What bounds our side, where that is known, by the operation and the kind of the cell.
VERTEX_COST = "vector ALUs: products, and between interleaved vertices shuffles"
LIMITS = {
    ("multiply", "chain"): "latency of multiply, add and shift",
    ("multiply", "long"): "vector ALUs: shifts and shuffles between 64-bit products",
    ("saturating multiply", "chain"): "latency of the compares",
    ("saturating multiply", "long"): "vector ALUs: the report needs every range",
    ("divide", "chain"): "latency of the 64-bit divider, then of rounding",
    ("divide", "loop"): "the floor in every rounding mode, and zero divisors; the peer divides doubles alike",
    ("divide", "long"): "divider of doubles, and the search for zeros",
    ("sqrt", "chain"): "latency of the root, and the test for negative numbers",
    ("sqrt", "loop"): "root of doubles, and the test for negative numbers",
    ("sqrt", "long"): "root unit",
    ("to double and back", "chain"): "latency of the shift by the exponent",
    ("from double", "loop"): "vector ALUs: halves go up in every rounding mode; peers round them as they come",
    ("from double", "long"): "tests for NaN and range, which peers leave undefined",
    ("to double", "long"): "loads and stores; the call in short spans",
    ("sin within 8", "long"): "vector ALUs",
    ("sin", "long"): "vector ALUs",
    ("sin_cos within 8", "long"): "vector ALUs",
    ("dot", "long"): "loads; the call and the sum of the lanes in short spans",
    **{(name, "long"): VERTEX_COST for name in TRANSFORMS},
}


class Damaged(Exception):
    """docs/performance.md lacks the place of the tables."""


def is_right(r):
    """Whether the result is a nearest one, for a transform of each product."""
    return r["error"] <= ROUNDINGS.get(r["operation"], 1) / 2


def label(r):
    """The verdict on a contender, with its largest error."""
    if r["error"] <= 0.5:
        return "exact"
    return ("exact products, " if is_right(r) else "") + f"up to {r['error']:.6g} ulp"


def cells(rows):
    """The contenders of each cell, by operation, shape, elements and offset."""
    found = {}
    for r in rows:
        found.setdefault((r["operation"], r["shape"], r["elements"], r["offset"]), []).append(r)
    return found


def ours_of(cell):
    """The faster of the operator and of its form for loops, where the cell has both."""
    return min((r for r in cell if r["ours"]), key=lambda r: r["ns"])


def codes(cell):
    """The peer, and whether ours is a form for loops."""
    return CODES[best_peer(cell)["name"]] + (" v" if ours_of(cell)["name"].startswith("vectorizable_") else "")


def best_peer(cell):
    """The fastest peer that is exact, or in transforms at least as exact as our side."""
    return min((r for r in cell if not r["ours"] and is_right(r)), key=lambda r: r["ns"], default=None)


def ratio(cell):
    return best_peer(cell)["ns"] / ours_of(cell)["ns"]


def kind(key):
    _, shape, elements, _ = key
    if shape != "batch":
        return shape
    return "memory" if elements >= 1_000_000 else "long" if elements >= 64 else "short"


def limit(key):
    if kind(key) == "memory" and "sin" not in key[0]:
        return "caches and memory"
    if kind(key) == "short":
        return "call, choice of path, masks, report"
    return LIMITS.get((key[0], "long" if kind(key) == "memory" else kind(key)), "")


def place(key):
    _, shape, elements, offset = key
    return shape if shape != "batch" else f"{elements:,}" + (f" + {offset} bytes" if offset else "")


def number(x):
    return f"{x:.3g}" if x < 100 else f"{x:.0f}"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(x) for x in line) + " |" for line in lines)


def times(name, rows):
    """All times of one build, in nanoseconds for an element."""
    lines = []
    for key, cell in cells(rows).items():
        if key[0] == COPIES:
            for r in cell:
                lines.append([key[0], place(key), NONE, f"{r['name']} {number(r['ns'])}", NONE, ""])
            continue
        ours, peer = ours_of(cell), best_peer(cell)
        lines.append([key[0], place(key), number(ours["ns"]), f"{peer['name']} {number(peer['ns'])}",
                      f"{ratio(cell):.2f}", limit(key)])
    head = ["operation", "elements", "ours, ns", "best exact peer, ns", "ratio", "limit"]
    return f"# {name}\n\n{table(head, lines)}\n"


def shown(cell):
    text = f"{ratio(cell):.2f}"
    return (f"**{text}**" if float(text) < 1 else text) + " " + codes(cell)


def operations(rows):
    return list(dict.fromkeys(r["operation"] for r in rows if r["operation"] != COPIES))


def matrix(rows):
    """The ratios of one build: a line for each operation."""
    found = cells(rows)
    columns = [("chain", 4096, 0), ("loop", 4096, 0), *(("batch", *span) for span in SPANS)]
    names = [shape if shape != "batch" else f"{n:,}" + (f"+{offset}" if offset else "") for shape, n, offset in columns]
    lines = []
    for operation in operations(rows):
        line = [found.get((operation, *column)) for column in columns]
        ratios = [shown(cell) if cell else NONE for cell in line]
        lines.append([operation, *ratios, limit((operation, "batch", 4096, 0))])
    return table(["operation", *names, "what bounds long spans"], lines)


def below(merged):
    """The least ratio of every kind of cell that has a ratio below 1, for each build; the worst first."""
    least = {}
    for name, rows in merged.items():
        for key, cell in cells(rows).items():
            if key[0] == COPIES or round(ratio(cell), 2) >= 1:
                continue
            worst = least.setdefault((key[0], kind(key)), {}).setdefault(name, [])
            span = f"{key[2]:,}" + (f"+{key[3]}" if key[3] else "")
            worst.append((ratio(cell), span, codes(cell)))
    lines = []
    def worst_of(item):
        return min(min(found) for found in item[1].values())

    for (operation, of), builds in sorted(least.items(), key=worst_of):
        line = []
        for name in merged:
            found = builds.get(name)
            if not found:
                line.append(NONE)
                continue
            spans = "" if of in ("chain", "loop") else f": {' '.join(span for _, span, _ in found)}"
            line.append(f"{min(found)[0]:.2f} {min(found)[2]}{spans}")
        elements = {"short": 1, "long": 64, "memory": 1_000_000}.get(of, 4096)
        bound = limit((operation, of if of in ("chain", "loop") else "batch", elements, 0))
        if not bound and worst_of((None, builds)) >= (TIE,):
            bound = "a tie"
        lines.append([operation, SHAPES[of], *line, bound])
    return table(["operation", "shape", *merged, "what bounds ours"], lines)


def copies(merged):
    """Transforms of many vertices beside copies of the same bytes."""
    lines = []
    for count in (1_000_000, 10_000_000):
        for operation in TRANSFORMS:
            line = [f"{operation}, {count:,}"]
            for rows in merged.values():
                found = cells(rows)
                cell, copy = found.get((operation, "batch", count, 0)), found.get((COPIES, "batch", count, 0))
                by_name = {r["name"]: r["ns"] for r in copy or []}
                for name in ("memcpy", "copy past the caches"):
                    line.append(f"{by_name[name] / ours_of(cell)['ns']:.2f}" if cell and name in by_name else NONE)
                line.append(shown(cell) if cell else NONE)
            lines.append(line)
    head = [f"{name}: {what}" for name in merged for what in ("memcpy", "streaming copy", "best peer")]
    return table(["vertices", *head], lines)


def peers(merged):
    """What the verification says about each peer, over all builds."""
    worst, order = {}, {}
    for rows in merged.values():
        for r in rows:
            if r["ours"] or r["operation"] == COPIES:
                continue
            order.setdefault(r["name"], []).append(r["operation"])
            key = (r["name"], r["operation"])
            if key not in worst or r["error"] > worst[key]["error"]:
                worst[key] = r
    lines = []
    for name, all_operations in order.items():
        verdicts = {}
        for operation in dict.fromkeys(all_operations):
            verdicts.setdefault(label(worst[name, operation]), []).append(operation)
        lines.append([CODES[name], name, "; ".join(f"{verdict}: {', '.join(of)}" for verdict, of in verdicts.items())])
    return table(["code", "peer", "verified"], lines)


def missing(context):
    absent = [f"{peer} ({name})" for name, names in context["missing"].items() for peer in names]
    return f"Not installed, so not compared: {len(absent)}" + (f", {', '.join(absent)}." if absent else ".")


def generated(context, merged):
    all_cells = [cell for rows in merged.values() for key, cell in cells(rows).items() if key[0] != COPIES]
    slower, beyond_ties, far = (sum(round(ratio(cell), 2) < bound for cell in all_cells) for bound in (1, TIE, 0.7))
    parts = [
        f"{context['machine']}; {'; '.join(context['compilers'])}; {context['date']}. {missing(context)}",
        f"## Where a peer is faster\n\n{slower} of {len(all_cells)} cells are below 1, {beyond_ties} of them below "
        f"{TIE}, {far} below 0.7. Each line has the least ratio and all spans below 1.\n\n{below(merged)}",
        *(f"## {name}\n\n{matrix(rows)}" for name, rows in merged.items()),
        "## Vertices in memory\n\nThe time of a copy of the same bytes, and of the best peer, divided by ours.\n\n"
        f"{copies(merged)}",
        f"## Peers\n\n{peers(merged)}",
    ]
    return "\n\n".join(parts)


def replaced(text, context, merged):
    """The page with new tables between its marks."""
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise Damaged(f"docs/performance.md needs '{BEGIN}' and '{END}', once each and in this order: put them back")
    return text[:text.index(BEGIN)] + f"{BEGIN}\n\n{generated(context, merged)}\n\n" + text[text.index(END):]
