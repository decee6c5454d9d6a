#!/usr/bin/env python3
"""usage: page.py FOLDER

Makes FOLDER/performance.md, FOLDER/performance_presets.md and FOLDER/pictures/*.svg of what the programs of
bench/ and `fixproof verify` have written as JSON in FOLDER. No page, and status 1, if one of them has computed something wrong; 2 if the page
cannot be made.
"""

import json
import os
import re
import statistics
import sys
import traceback

try:
    import matplotlib
except ImportError as missing:
    print(f"page.py: {missing}", file=sys.stderr)
    sys.exit(2)

matplotlib.use("svg")
# The same figures make the same files.
matplotlib.rcParams.update({"svg.hashsalt": "fixproof", "svg.fonttype": "none", "font.size": 9,
                            "axes.spines.top": False, "axes.spines.right": False})
import matplotlib.pyplot as plt  # noqa: E402

UNITS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


class Wrong(Exception):
    """Something has computed a wrong result."""


class Timed:
    """What one benchmark took for one item, in ns."""

    def __init__(self, name, runs):
        self.name = name
        self.times = [1e9 / run["items_per_second"] for run in runs]
        self.counters = runs[0]
        self.clock = "the clock on the wall" if "/real_time" in runs[0]["run_name"] else "processor time"

    @property
    def best(self):
        return min(self.times)

    @property
    def median(self):
        return statistics.median(self.times)

    @property
    def spread(self):
        """The middle half of the runs, in percent of the median."""
        if len(self.times) < 4:
            return "-"
        low, _, high = statistics.quantiles(self.times, n=4)
        return f"{100 * (high - low) / self.median:.0f}"


def read(folder, program):
    """The benchmarks of a program by name, and what it says of the machine."""
    with open(f"{folder}/{program}.json", encoding="utf-8") as file:
        text = json.load(file)
    runs = {}
    # As they are registered: repetitions come in any order.
    for run in sorted(text["benchmarks"], key=lambda r: (r["family_index"], r["per_family_instance_index"])):
        if run.get("error_occurred"):
            raise Wrong(f"{program}: {run['name']}: {run['error_message']}")
        if run["run_type"] == "iteration":
            if "items_per_second" not in run:
                run["items_per_second"] = run["bytes_per_second"]
            name = re.sub(r"/(real_time|repeats:\d+)", "", run["run_name"])
            runs.setdefault(name, []).append(run)
    return {name: Timed(name, r) for name, r in runs.items()}, text["context"]


def number(x):
    """Three digits."""
    if x >= 100:
        return f"{x:,.0f}"
    return f"{x:.3g}" if x < 1 else f"{x:.{2 if x < 10 else 1}f}"


def clock(timed):
    """By which clock a program's times were taken."""
    return " and ".join(sorted({t.clock for t in timed.values()}))


def table(rows, base=None):
    """Lines of a table of Timed; with the one named `base` each is compared: 2 is twice as quick."""
    lines = ["| | ns, least | ns, median | spread % |" + (f" rate, {base[0]} = 1 |" if base else ""),
             "| --- | --- | --- | --- |" + (" --- |" if base else "")]
    for label, timed in rows:
        line = f"| {label} | {number(timed.best)} | {number(timed.median)} | {timed.spread} |"
        if base:
            line += f" {number(base[1].median / timed.median)} |"
        lines.append(line)
    return lines + [""]


def save(figure, folder, name):
    figure.tight_layout()
    path = f"{folder}/pictures/{name}.svg"
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
    with open(path, encoding="utf-8") as file:
        svg = file.read()
    # One line for each group, where Matplotlib takes one for each point.
    with open(path, "w", encoding="utf-8") as file:
        file.write(re.sub(r"\n\s*(?!\s|<g)", " ", svg))


def bars(folder, name, title, rows):
    """Times for one item, shortest at the top; rows of (label, Timed)."""
    rows = sorted(rows, key=lambda row: -row[1].median)
    figure, axes = plt.subplots(figsize=(7, 0.5 + 0.24 * len(rows)))
    colors = ["#c2571a" if label.startswith(("batch", "fixed", "q16_16")) else "#8a949e"
              for label, _ in rows]
    bar = axes.barh([label for label, _ in rows], [t.median for _, t in rows], color=colors)
    axes.bar_label(bar, [number(t.median) for _, t in rows], padding=3)
    axes.set_xlabel("ns for one, median")
    axes.set_title(title, loc="left")
    axes.margins(x=0.12)
    save(figure, folder, name)


def curves(folder, name, title, labels, lines):
    """Lines of (label, [(size, value)]), both axes logarithmic."""
    figure, axes = plt.subplots(figsize=(7, 3.6))
    for (label, points), style in zip(lines, ["-o", "--o", "-s", "--s", "-^"]):
        axes.plot([x for x, _ in points], [y for _, y in points], style, label=label, markersize=4)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    axes.set_title(title, loc="left")
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(frameon=False)
    save(figure, folder, name)


def grouped(timed, pattern):
    """[(first group of the pattern, Timed)] of the names that match."""
    found = ((re.fullmatch(pattern, name), t) for name, t in timed.items())
    return [(match.group(1), t) for match, t in found if match]


def sized(timed, pattern):
    """[(size, Timed)], by size, of the names that match."""
    return sorted(((int(size), t) for size, t in grouped(timed, pattern)), key=lambda p: p[0])


def limits(limit, batch):
    """How near the batches come to what the processor can do."""
    path = next((p for p in ("avx512", "avx2") if f"multiply_{p}" in limit), None)
    if not path:
        return []
    lines = ["### How near the batches come to what the processor can do", "",
             "1,024 elements on the quickest path, beside the most that `limit_bench` has found of what they need: products, "
             "quotients and roots of that path's registers, and bytes loaded and stored in the first cache at aligned "
             "addresses. The arrays of `batch_bench` begin at multiples of 64 bytes.", "",
             "| | ns, median | at least | reached | what takes that |", "| --- | --- | --- | --- | --- |"]
    one = {"products": f"multiply_{path}", "quotients": f"divide_double_{path}", "roots": f"root_double_{path}",
           "bytes loaded": f"load_{path}", "bytes stored": f"store_{path}"}
    needs = {"multiply": (1, 0, 0, 8, 4), "mul_add": (1, 0, 0, 12, 4), "divide": (0, 1, 0, 8, 4), "sqrt": (0, 0, 1, 4, 4),
             "dot": (1, 0, 0, 8, 0), "transform": (9, 0, 0, 12, 12), "project": (2, 2, 0, 12, 8)}
    for operation, counts in needs.items():
        least, what = max((count * limit[name].median, f"{kind}: {count}")
                          for count, (kind, name) in zip(counts, one.items()))
        timed = batch[f"{operation}/batch_{path}/1024"]
        lines.append(f"| {operation} | {number(timed.median)} | {number(least)} | "
                     f"{100 * least / timed.median:.0f} % | {what} |")
    return lines + [""]


def moving(batch):
    """Vertices that no cache holds, beside copying them."""
    rows = {"transform, interleaved": "transform/batch_{}", "transform, in columns": "transform_columns/batch_{}",
            "copy": "transform/copy"}
    path = next(p for p in ("avx512", "avx2", "neon", "portable") if f"transform/batch_{p}/10000000" in batch)
    page = ["### Vertices in memory beside the copy of the same bytes", "",
            f"For a vertex, of which 12 bytes are read and 12 written; `memcpy` for the copy; the path `{path}`; all in one "
            f"run, in turns; {batch['transform/copy/1000000'].clock}.", ""]
    for vertices in (1_000_000, 10_000_000):
        timed = [(label, batch[f"{name.format(path)}/{vertices}"]) for label, name in rows.items()]
        page += [f"{vertices:,} vertices, {24 * vertices / 1e6:.0f} MB:", ""] + table(timed, timed[-1])
    return page


def preset_section(preset):
    """Batches beside loops under every preset."""
    page = ["# Every operation under every preset", "",
            "A part of [performance.md](performance.md), made with it: the machine and the flags are there.", "",
            "`build/release/bench/preset_bench`: batches on the quickest path, beside the same loop over the type, 1,024 "
            f"elements; {clock(preset)}.", ""]
    names = [name.split("/") for name in preset]
    for operation in dict.fromkeys(name[1] for name in names):
        page += [f"## {operation}", "",
                 "| | batch: ns, least | median | spread % | loop: ns, least | median | spread % | rate of the batch, loop = 1 |",
                 "| --- |" + " --- |" * 7]
        for name in dict.fromkeys(name[0] for name in names):
            batch, loop = (preset[f"{name}/{operation}/{how}/1024"] for how in ("batch", "loop"))
            cells = [cell for t in (batch, loop) for cell in (number(t.best), number(t.median), t.spread)]
            page.append(f"| `{name}` | {' | '.join(cells)} | {number(loop.median / batch.median)} |")
        page.append("")
    return page


def short_section(everything):
    """The figures that most people come for."""
    batch, radian, arithmetic, scale = (everything[name] for name in ("batch", "radian", "arithmetic", "scale"))
    path = next(p for p in ("avx512", "avx2", "neon", "portable") if f"multiply/batch_{p}/1024" in batch)
    largest = max(size for size, _ in sized(scale, r"frame<Type>/objects:(\d+)/threads:1"))
    rows = [(f"{operation}, 1,024 at once", batch[f"{operation}/batch_{path}/1024"], "plain idiom",
             batch[f"{operation}/idiom/1024"]) for operation in ("multiply", "divide")]
    rows.append(("divide, one by one over arrays", arithmetic["div/q16_16"], "plain idiom", arithmetic["div/idiom"]))
    rows += [(f"sine of any word, {what}", radian[f"sin/{name}/all"], beside, radian[f"sin/{beside}/all"])
             for what, name in (("one by one", "q16_16"), ("at once", "q16_16_batch"))
             for beside in ("libfixmath", "double") if f"sin/{beside}/all" in radian]
    rows += [(f"transform of {count:,} vertices, {layout}", batch[f"{name}/batch_{path}/{count}"],
              "copy of the same bytes", batch[f"transform/copy/{count}"])
             for count in (1_000_000, 10_000_000)
             for layout, name in (("in columns", "transform_columns"), ("interleaved", "transform"))]
    rows.append((f"frame of {114 * largest:,} vertices before it is filled, on two threads",
                 scale[f"frame<Type>/objects:{largest}/threads:2"], "on one",
                 scale[f"frame<Type>/objects:{largest}/threads:1"]))
    lines = ["## In short", "", "Medians; the sections below have the rest, and what each was timed by.", "",
             "| | ns | beside | ns | rate |", "| --- | --- | --- | --- | --- |"]
    for what, timed, beside, other in rows:
        lines.append(f"| {what} | {number(timed.median)} | {beside} | {number(other.median)} | "
                     f"{number(other.median / timed.median)} |")
    return lines + [""]


def batch_section(folder, batch, limit):
    page = ["## Batches beside loops", "",
            "`build/release/bench/batch_bench`: operations over spans, on every path the processor has, beside the same "
            "loop over the type, the plain idiom (64-bit products, rounded half up; 64-bit `idiv`, truncated), `float` and `double`, as "
            "the compiler makes them with the flags of the program. 1,024 elements stay in the first caches, 1,000,000 do not; "
            f"{clock(batch)}.", ""]
    page += moving(batch) + limits(limit, batch)
    for operation in dict.fromkeys(name.split("/")[0] for name in batch):
        for elements in (1024, 1_000_000):
            rows = dict(grouped(batch, rf"{operation}/(.+)/{elements}") or
                        [(operation, t) for _, t in grouped(batch, rf"({operation})/{elements}")])
            base = next((label for label in ("idiom", "q16_16") if label in rows), None)
            page += [f"### {operation}, {elements:,} elements", ""] + \
                table(rows.items(), base and (base, rows[base]))
        small = grouped(batch, rf"{operation}/(.+)/1024")
        if operation in ("multiply", "divide", "transform"):
            bars(folder, f"performance_{operation}", f"{operation}, 1,024 elements", small)
            page += [f"![Times of {operation}](pictures/performance_{operation}.svg)", ""]
    return page


def scale_section(folder, scale):
    frames = {(kind, threads): sized(scale, rf"frame<{kind}>/objects:(\d+)/threads:{threads}")
              for kind in ("Type", "double") for threads in (1, 2)}
    names = {"Type": "q16_16_i386", "double": "double"}
    curves(folder, "performance_frames", "A frame before it is filled",
           ("vertices", "ms"),
           [(f"{names[kind]}, {threads} thread{'s' * (threads > 1)}",
             [(114 * n, t.median * 114 * n / 1e6) for n, t in points])
            for (kind, threads), points in frames.items()])
    sorts = {how: sized(scale, rf"sort_{how}/(\d+)") for how in ("little", "reversed")}
    curves(folder, "performance_sorting", "Sorting by depth", ("objects", "ms"),
           [(label, [(n, t.median * n / 1e6) for n, t in sorts[how]])
            for how, label in (("little", "a tenth changes places"), ("reversed", "all turned about"))])
    page = ["## Scenes of any size", "",
            "`build/release/bench/scale_bench`: balls of 114 vertices and 128 faces, each turning in its own way, all in "
            "sight: moved, transformed, projected, hidden, sorted and made into polygons. In ns for a vertex, by "
            f"{clock({n: t for n, t in scale.items() if not n.startswith('sort')})}:", "",
            "| vertices | type | type, 2 threads | double | double, 2 threads | copying coordinates | bytes a vertex |",
            "| --- | --- | --- | --- | --- | --- | --- |"]
    copies = dict(sized(scale, r"copy/(\d+)"))
    for i, (objects, one) in enumerate(frames["Type", 1]):
        row = [number(frames[key][i][1].median) for key in frames]
        page.append(f"| {114 * objects:,} | " + " | ".join(row) + f" | {number(copies[objects].median)} | "
                    f"{one.counters['bytes_per_vertex']:.0f} |")
    page += ["", "![Time of a frame](pictures/performance_frames.svg)", "",
             "Sorting by depth, in ns for an object, by "
             f"{clock({n: t for n, t in scale.items() if n.startswith('sort')})}:", "",
             "| objects | a tenth changes places | all turned about |", "| --- | --- | --- |"]
    for (objects, little), (_, turned) in zip(sorts["little"], sorts["reversed"]):
        page.append(f"| {objects:,} | {number(little.median)} | {number(turned.median)} |")
    return page + ["", "![Time of sorting](pictures/performance_sorting.svg)", ""]


def fill_section(folder, fill):
    kinds = {(bits, what): sized(fill, rf"{what}<std::uint{bits}_t>/(\d+)")
             for bits in (8, 32) for what in ("fill", "memset_same")}
    names = {"fill": "fill", "memset_same": "memset"}
    pixels = {radius: t.counters["pixels"] for bits in (8, 32) for radius, t in kinds[bits, "fill"]}
    curves(folder, "performance_fill", "Filling an octagon", ("pixels", "µs"),
           [(f"{names[what]}, {bits} bits", [(pixels[r], t.median * pixels[r] / 1e3) for r, t in points])
            for (bits, what), points in kinds.items()])
    page = ["## Filling", "",
            "`build/release/bench/fill_bench`: an octagon on a page of 2048 x 2048, beside `memset` of as many pixels in one "
            "piece. In ns for a pixel: what does not grow with the pixels (finding the rows, and beginning each of "
            f"them) is soon nothing beside them, and from there on the memory is the bound. {clock(fill).capitalize()}.", "",
            "| pixels | 8 bits | memset | 32 bits | memset |", "| --- | --- | --- | --- | --- |"]
    for row in zip(*kinds.values()):
        page.append(f"| {pixels[row[0][0]]:,.0f} | " + " | ".join(number(t.median) for _, t in row) + " |")
    page += ["", "![Time of filling](pictures/performance_fill.svg)", "",
             "Whole frames of a ball of 36 faces, erasing included, 320 x 240; for a pixel:", ""]
    return page + table([(f"`{name}`", t) for name, t in fill.items() if name.startswith("frames")])


def duration(seconds):
    if seconds < 100:
        return f"{seconds:.1f} s"
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def tier_section(folder):
    page = ["## What each level of verification takes", "",
            "`build/release/fixproof verify --level N`, on all processors. A level too long for this run is timed over a part "
            "(`--shard`), and **the time of the whole is computed** from the cases a second of that part. By the clock on the "
            "wall.", "",
            "| level | cases | run here | cases a second | time of the whole | |",
            "| --- | --- | --- | --- | --- | --- |"]
    for level in (1, 2, 3):
        with open(f"{folder}/level_{level}.json", encoding="utf-8") as file:
            report = json.load(file)
        if report["mismatches"] or not report["complete"]:
            raise Wrong(f"level {level}: {report['mismatches']} mismatches, complete: {report['complete']}")
        cases = sum(sum(row["streams"].values()) for row in report["rows"])
        rate = report["cases"] / report["seconds"]
        part = report["shard"][1]
        page.append(f"| {level} | {cases:,} | {report['cases']:,} in {report['seconds']:.1f} s | {rate / 1e6:,.1f} million | "
                    f"{duration(cases / rate)} | {'measured' if part == 1 else f'computed from 1/{part}'} |")
    return page + [""]


def plain_section(title, text, timed, base=None):
    return [f"## {title}", "", f"{text} {clock(timed).capitalize()}.", ""] + \
        table([(f"`{name}`", t) for name, t in timed.items()], base and (base, timed[base]))


PROGRAMS = ("limit", "batch", "preset", "radian", "arithmetic", "scale", "scene", "fill", "model")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = sys.argv[1]
    everything, contexts = {}, {}
    for name in PROGRAMS:
        everything[name], contexts[name] = read(folder, f"{name}_bench")
    limit, context = everything["limit"], contexts["limit"]
    processor = "an unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            match = re.search(r"model name\s*: (.+)", file.read())
            processor = match.group(1) if match else processor
    page = ["# How quick everything is", "",
            "Made by `scripts/performance`, which builds and runs the programs of [bench/](../bench/README.md) one after "
            "the other. What is timed is first held against what it should compute, but for `limit_bench` and `memset`. "
            "Times are for one operation, vertex, call or frame: the least and the median of the repetitions, and the "
            "middle half of them in percent of the median (spread). A rate of 2 is twice as quick as what it is compared "
            "with. Compare within this page, not with that of another machine.", "",
            f"{processor}, {context['num_cpus']} processors; {context['compiler']}; "
            f"{context['date'][:10]}; load at the beginning {context['load_avg'][0]:.1f}. Processor time is what the thread "
            "has run, without what others took of the processor meanwhile.", "",
            "| program | its clock | flags |", "| --- | --- | --- |"]
    page += [f"| `{name}_bench` | {clock(everything[name])} | `{contexts[name]['flags']}` |" for name in PROGRAMS] + [""]
    page += short_section(everything)
    page += plain_section("What the processor can do",
                          "`limit_bench`: operations that do not wait for one another; for `load`, `store` and `copy`, one byte.",
                          limit)
    page += batch_section(folder, everything["batch"], limit)
    page += ["[performance_presets.md](performance_presets.md) has every operation under every preset.", ""]
    bars(folder, "performance_sine", "Sine of an angle in radians, all words",
         grouped(everything["radian"], r"sin/(.+)/all"))
    page += plain_section("Sine and cosine in radians", "`radian_bench`; within ±8, and all words.",
                          everything["radian"])
    page += ["![Times of sines](pictures/performance_sine.svg)", ""]
    page += plain_section("The type under its presets, one by one and in chains",
                          "`arithmetic_bench`, the loops of `fixproof measure --host`. In a chain each result is an "
                          "operand of the next.", everything["arithmetic"])
    page += scale_section(folder, everything["scale"])
    page += plain_section("Whole frames", "`scene_bench`: 320 x 240, erased and filled.", everything["scene"])
    page += fill_section(folder, everything["fill"])
    page += plain_section("The register-level model", "`model_bench`: for a call.", everything["model"])
    page += tier_section(folder)
    presets = preset_section(everything["preset"])
    for name, lines in (("performance", page), ("performance_presets", presets)):
        with open(f"{folder}/{name}.md", "w", encoding="utf-8") as file:
            file.write("\n".join(lines).rstrip() + "\n")
    return 0


try:
    sys.exit(main())
except Wrong as wrong:
    print(f"page.py: {wrong}", file=sys.stderr)
    sys.exit(1)
except Exception:
    traceback.print_exc()
    sys.exit(2)
