#!/usr/bin/env python3
"""usage: page.py FOLDER

Reads the JSON files that the programs of bench/ have written to FOLDER and writes FOLDER/performance.md.
Exit status 1: a benchmark computed a wrong result. 2: the page cannot be made.
"""

import json
import os
import re
import statistics
import sys
import traceback

PATHS = ("avx512", "avx2", "neon", "portable")
PATH_NAMES = {"avx512": "AVX-512", "avx2": "AVX2", "neon": "NEON", "portable": "portable"}
PROGRAMS = ("limit", "batch", "radian", "arithmetic", "scale")
NONE = "–"

# The page; each word in capitals stands for a table or a figure.
PAGE = """\
# Performance

This page compares the number type with the fastest alternative of the same accuracy. `scripts/performance` writes it from
the output of the programs in `build/release/bench/` ([bench/](../bench/README.md)). All except `limit_bench` check their
results before they time them. [trade.md](trade.md#time-on-this-processor) sets times against errors.

- **Machine**: MACHINE
- **Times** are medians in nanoseconds of processor time, for one element, vertex or object. A **ratio** is the peer's time
  divided by ours: above 1, ours is faster. Compare figures of this page with each other, not with another machine's.
- **An exact peer** returns the nearest 16.16 word for every operand that is timed; in a transform, for every product. The
  idiom is `(int64_t(a) * b + 0x8000) >> 16`; its divide truncates, so it is no exact peer of a divide. "Unrounded": the
  peer's result stays in `double` or `float`. "Loop": the type's own operators, where there is no exact peer. FT_DivFix is
  FreeType's, timed by `arithmetic_bench`.
- **Flags**, the same for ours and the peers: `ALL_FLAGS` (`batch_bench`: `BATCH_FLAGS`).
  FreeType and the C library are the installed ones. Without `-march`, all but the AVX2 and AVX-512 paths have SSE2 on
  x86-64. Those two are chosen at run time, so their ratios are the gain of a program that is built for every x86-64
  processor. With `-march=native` the peers are faster and the ratios smaller; this page does not measure that.

## Arrays

`batch_bench`: the operations of `batch/batch.hpp` on 1,024 elements in the first-level cache, in arrays that begin at
multiples of 64 bytes. The limit is what the scarcest resource alone takes on the fastest path, by `limit_bench`:
RESOURCES.

BATCHES

## Vertices in memory

`batch_bench`: the transform by a 3 x 4 matrix on the fastest path and `memcpy` both read and write 12 bytes per vertex.
`memcpy` is no lower limit, because large transforms [write past the caches](batch.md#large-transforms).

MOVING

## Single operations

`arithmetic_bench`, the loops of `fixproof measure --host`: over arrays (each), and in chains, where every result is an
operand of the next. `/` divides [integers or doubles](batch.md#the-scalar-divide).

SINGLE

## Sine and cosine of radians

`radian_bench`. The peer is `std::sin` of `double` and `lrint`, one by one.
[measurements.md](measurements.md#sines-and-cosines-of-radians) has the errors.

SINES

## Large scenes

`scale_bench`: elapsed nanoseconds per vertex for a frame before it is filled (move, transform, project, hide, sort, make
polygons). The objects are balls of 114 vertices and 128 faces, all turning and in sight, and the type is `q16_16_i386`.
The copy moves the coordinates alone, 12 bytes in and 12 out.

FRAMES

Sorting by depth takes SORTED.
"""


class Wrong(Exception):
    """A benchmark computed a wrong result."""


def read(folder, program):
    """The median ns per item of each benchmark of a program, the counters of one run, and the context."""
    with open(f"{folder}/{program}_bench.json", encoding="utf-8") as file:
        text = json.load(file)
    times, counters = {}, {}
    for run in text["benchmarks"]:
        if run.get("error_occurred"):
            raise Wrong(f"{program}_bench: {run['name']}: {run['error_message']}")
        if run["run_type"] == "iteration":
            rate = run["items_per_second"] if "items_per_second" in run else run["bytes_per_second"]
            name = re.sub(r"/(real_time|repeats:\d+)", "", run["run_name"])
            times.setdefault(name, []).append(1e9 / rate)
            counters[name] = run
    return {name: statistics.median(t) for name, t in times.items()}, counters, text["context"]


def number(x):
    """Three digits."""
    if x >= 100:
        return f"{x:,.0f}"
    return f"{x:.3g}" if x < 1 else f"{x:.{2 if x < 10 else 1}f}"


def cell(x):
    return x if isinstance(x, str) else NONE if x is None else number(x)


def over(peer, ours):
    return None if peer is None else peer / ours


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| --- |" + " --- |" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(cell(x) for x in row) + " |" for row in rows])


def paths_of(batch):
    return [p for p in PATHS if f"multiply/batch_{p}/1024" in batch]


def limits(limit, path):
    """For each operation the least time of its most limiting resource, and what that is."""
    one = {"products": f"multiply_{path}", "quotients": f"divide_double_{path}", "roots": f"root_double_{path}",
           "bytes loaded": f"load_{path}", "bytes stored": f"store_{path}"}
    if not all(name in limit for name in one.values()):
        return {}
    transform = (9, 0, 0, 12, 12)
    needs = {"multiply": (1, 0, 0, 8, 4), "mul_add": (1, 0, 0, 12, 4), "divide": (0, 1, 0, 8, 4), "sqrt": (0, 0, 1, 4, 4),
             "dot": (1, 0, 0, 8, 0), "transform": transform, "transform_columns": transform, "project": (2, 2, 0, 12, 8)}
    return {operation: max((count * limit[name], f"{count} {kind}" if count > 1 else f"{count} {kind[:-1]}")
                           for count, (kind, name) in zip(counts, one.items()))
            for operation, counts in needs.items()}


def batches(batch, arithmetic, bounds):
    paths = paths_of(batch)
    fastest = paths[0]
    peers = {"multiply": ("multiply", "idiom"), "mul_add": ("mul_add", "idiom"), "sqrt": ("sqrt", "double"),
             "transform": ("transform", "idiom"), "transform_columns": ("transform", "idiom")}
    names = {"transform": "transform, interleaved", "transform_columns": "transform, in columns"}
    labels = {"idiom": "idiom", "double": "`double`, unrounded:"}
    rows = []
    for operation in ("multiply", "mul_add", "divide", "sqrt", "dot", "transform", "transform_columns", "project"):
        ours = {p: batch[f"{operation}/batch_{p}/1024"] for p in paths}
        peer = far = None
        if operation in peers:
            of, name = peers[operation]
            peer, far = (batch[f"{of}/{name}/{elements}"] for elements in (1024, 1_000_000))
            shown = f"{labels[name]} {number(peer)}"
        elif operation == "divide" and "div/FreeType" in arithmetic:
            peer = arithmetic["div/FreeType"]
            shown = f"FT_DivFix {number(peer)}"
        else:
            shown = f"(loop {number(batch[f'{operation}/q16_16/1024'])})"
        rows.append([names.get(operation, operation), *(ours[p] for p in reversed(paths)), shown,
                     over(peer, ours["portable"]), over(peer, ours[fastest]),
                     over(far, batch[f"{operation}/batch_{fastest}/1000000"]), bounds[operation][0] if bounds else None])
    best = PATH_NAMES[fastest]
    return table(["operation", *(PATH_NAMES[p] for p in reversed(paths)), "best exact peer", "ratio, portable",
                  f"ratio, {best}", f"ratio, {best}, 1,000,000 elements", "limit"], rows)


def moving(batch):
    path = paths_of(batch)[0]
    rows = []
    for count in (1_000_000, 10_000_000):
        copy = batch[f"transform/copy/{count}"]
        for layout, name in (("interleaved", "transform"), ("in columns", "transform_columns")):
            ours = batch[f"{name}/batch_{path}/{count}"]
            rows.append([f"{count:,}, {layout}", ours, copy, over(copy, ours)])
    return table(["vertices", "ours", "`memcpy`", "ratio"], rows)


def single(arithmetic):
    rows = []
    for label, name, peer in (("multiply", "mul", "idiom"), ("divide", "div", "FreeType"), ("square root", "sqrt", "double"),
                              ("cosine of tenths of a degree", "cos", "float"),
                              ("transform of a vertex", "vertex", "idiom")):
        row = [label]
        for end in ("", "/chain"):
            ours, other = (arithmetic.get(f"{name}/{who}{end}") for who in ("q16_16", peer))
            shown = {"FreeType": "FT_DivFix", "idiom": "idiom"}.get(peer, f"`{peer}`, unrounded:")
            row += [ours, f"{shown} {number(other)}" if other else None, over(other, ours)]
        rows.append(row)
    return table(["operation", "each: ours", "best exact peer", "ratio", "chain: ours", "best exact peer", "ratio"], rows)


def sines(radian):
    rows = []
    for words, label in (("within_8", "within ±8"), ("all", "all words")):
        for function in ("sin", "sin_cos"):
            one, batch = (radian[f"{function}/q16_16{how}/{words}"] for how in ("", "_batch"))
            peer = radian.get(f"{function}/double/{words}")
            rows.append([f"`{function}`, {label}", one, batch, peer, over(peer, one), over(peer, batch)])
    return table(["operation", "one by one", "batch", "best exact peer", "ratio, one by one", "ratio, batch"], rows)


def frames(scale, counters):
    rows = []
    for objects in (10, 100, 1_000, 10_000, 100_000):
        one = f"frame<Type>/objects:{objects}/threads:1"
        others = (one.replace("Type", kind).replace("threads:1", f"threads:{threads}")
                  for kind in ("Type", "double") for threads in (1, 2))
        rows.append([f"{114 * objects:,}", *(scale[name] for name in others), scale[f"copy/{objects}"],
                     f"{counters[one]['bytes_per_vertex']:.0f}"])
    return table(["vertices", "type, 1 thread", "type, 2 threads", "`double`, 1 thread", "`double`, 2 threads",
                  "copy", "bytes per vertex"], rows)


def sorted_in(scale):
    """The least and the most time of sorting per object, over all counts of objects."""
    def spread(name):
        found = {int(key.rpartition("/")[2]): t for key, t in scale.items() if key.startswith(name + "/")}
        return f"{number(min(found.values()))} to {number(max(found.values()))} ns"
    return (f"{spread('sort_little')} per object if a tenth of the objects have changed places, and\n"
            f"{spread('sort_reversed')} if their order is reversed, for 10 to 1,000,000 objects")


def machine(context):
    processor = "an unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            match = re.search(r"model name\s*: (.+)", file.read())
            processor = match.group(1) if match else processor
    return (f"{processor}, {context['num_cpus']} processors; {context['compiler']}; {context['date'][:10]}; load at the start "
            f"{context['load_avg'][0]:.1f}.")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = sys.argv[1]
    times, counters, contexts = {}, {}, {}
    for program in PROGRAMS:
        times[program], counters[program], contexts[program] = read(folder, program)
    bounds = limits(times["limit"], paths_of(times["batch"])[0])
    resources = ", ".join(f"{operation} {what}" for operation, (_, what) in bounds.items() if operation != "transform_columns")
    parts = {"MACHINE": machine(contexts["limit"]), "ALL_FLAGS": contexts["limit"]["flags"],
             "BATCH_FLAGS": contexts["batch"]["flags"], "BATCHES": batches(times["batch"], times["arithmetic"], bounds),
             "RESOURCES": resources or "unknown for this processor", "MOVING": moving(times["batch"]),
             "SINGLE": single(times["arithmetic"]), "SINES": sines(times["radian"]),
             "FRAMES": frames(times["scale"], counters["scale"]), "SORTED": sorted_in(times["scale"])}
    with open(f"{folder}/performance.md", "w", encoding="utf-8") as file:
        file.write(re.sub("|".join(parts), lambda match: parts[match.group()], PAGE))
    return 0


try:
    sys.exit(main())
except Wrong as wrong:
    print(f"page.py: {wrong}", file=sys.stderr)
    sys.exit(1)
except Exception:
    traceback.print_exc()
    sys.exit(2)
