#!/usr/bin/env python3
"""usage: page.py FOLDER

Makes FOLDER/performance.md and FOLDER/pictures/*.svg of what the programs of bench/ and `fixproof verify`
have written as JSON in FOLDER. Status 1, and no page, if one of them has computed something wrong.
"""

import json
import os
import re
import statistics
import sys

import matplotlib

matplotlib.use("svg")
# The same figures make the same files.
matplotlib.rcParams.update({"svg.hashsalt": "fixproof", "svg.fonttype": "none", "font.size": 9,
                            "axes.spines.top": False, "axes.spines.right": False})
import matplotlib.pyplot as plt  # noqa: E402

UNITS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


class Timed:
    """What one benchmark took for one item, in ns."""

    def __init__(self, name, runs):
        self.name = name
        self.times = [1e9 / run["items_per_second"] for run in runs]
        self.counters = runs[0]

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
            print(f"page.py: {program}: {run['name']}: {run['error_message']}", file=sys.stderr)
            sys.exit(1)
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


def table(rows, base=None):
    """Lines of a table of Timed; with the one named `base` each is compared."""
    lines = ["| | ns, least | ns, median | spread % |" + (f" times {base[0]} |" if base else ""),
             "| --- | --- | --- | --- |" + (" --- |" if base else "")]
    for label, timed in rows:
        line = f"| {label} | {number(timed.best)} | {number(timed.median)} | {timed.spread} |"
        if base:
            line += f" {number(base[1].median / timed.median)} |"
        lines.append(line)
    return lines + [""]


def save(figure, folder, name):
    figure.tight_layout()
    figure.savefig(f"{folder}/pictures/{name}.svg", metadata={"Date": None})
    plt.close(figure)


def bars(folder, name, title, rows):
    """Times for one item, shortest at the top; rows of (label, Timed)."""
    rows = sorted(rows, key=lambda row: -row[1].median)
    figure, axes = plt.subplots(figsize=(7, 0.5 + 0.24 * len(rows)))
    colors = ["#c2571a" if label.startswith(("batch", "fixed", "q16_16")) else "#8a949e"
              for label, _ in rows]
    bar = axes.barh([label for label, _ in rows], [t.median for _, t in rows], color=colors)
    axes.bar_label(bar, [number(t.median) for _, t in rows], padding=3)
    axes.set_xscale("log")
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
    lines = ["| | ns, median | at least | reached | the limit |", "| --- | --- | --- | --- | --- |"]
    path = next((p for p in ("avx512", "avx2") if f"multiply/batch_{p}/1024" in batch), None)
    if not path:
        return []
    multiply = limit[f"multiply_{path}"].median
    divide = limit[f"divide_double_{path}"].median
    cached = limit["copy/16384"].median
    for operation, least, what in (
            ("multiply", max(multiply, 6 * cached), "one product; 8 bytes read, 4 written"),
            ("divide", divide, "one quotient of doubles"),
            ("transform", max(9 * multiply, 12 * cached), "nine products; 12 bytes read and written"),
            ("project", max(2 * divide, 10 * cached), "two quotients of doubles")):
        timed = batch.get(f"{operation}/batch_{path}/1024")
        if timed:
            lines.append(f"| {operation} | {number(timed.median)} | {number(least)} | "
                         f"{100 * least / timed.median:.0f} % | {what} |")
    return lines + [""]


def presets(batch):
    """Batches beside loops under the presets that have other rules than q16_16."""
    lines = ["### Under other presets, 1,024 elements", "",
             "On the quickest path, beside the same loop over the type: ns, median.", "",
             "| | multiply | loop | divide | loop | transform | loop | project | loop |",
             "| --- |" + " --- |" * 8]
    for preset in dict.fromkeys(label for label, _ in grouped(batch, r"preset/(\w+)/.+")):
        times = [batch[f"preset/{preset}/{operation}/{contender}/1024"].median
                 for operation in ("multiply", "divide", "transform", "project") for contender in ("batch", "loop")]
        lines.append(f"| `q16_16_{preset}` | " + " | ".join(number(t) for t in times) + " |")
    return lines + [""]


def batch_section(folder, batch, limit):
    page = ["## Batches beside loops", "",
            "`build/release/bench/batch_bench`: operations over spans, on every path the processor has, beside the same "
            "loop over the type, the plain idiom (64-bit products, rounded half up; 64-bit `idiv`, truncated), `float` and `double`, as "
            "the compiler makes them with the flags above. 1,024 elements stay in the first caches, 1,000,000 do not.", ""]
    operations = [o for o in dict.fromkeys(name.split("/")[0] for name in batch) if o != "preset"]
    for operation in operations:
        for elements in (1024, 1_000_000):
            rows = grouped(batch, rf"{operation}/(.+)/{elements}") or \
                [(operation, t) for _, t in grouped(batch, rf"({operation})/{elements}")]
            if not rows:
                sys.exit(f"page.py: no times of {operation} for {elements}")
            base = next(((label, t) for label, t in rows if label in ("idiom", "q16_16")), None)
            base = next(((label, t) for label, t in rows if label == "idiom"), base)
            page += [f"### {operation}, {elements:,} elements", ""] + table(rows, base)
        small = grouped(batch, rf"{operation}/(.+)/1024")
        if operation in ("multiply", "divide", "transform") and small:
            bars(folder, f"performance_{operation}", f"{operation}, 1,024 elements", small)
            page += [f"![Times of {operation}](pictures/performance_{operation}.svg)", ""]
    page += presets(batch)
    page += ["### How near that is to what the processor can do", "",
             "`build/release/bench/limit_bench`, in the same run: independent multiplies and divides, and copying in the "
             "first cache.", ""]
    return page + limits(limit, batch)


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
            "sight: moved, transformed, projected, hidden, sorted and made into polygons. In ns for a vertex:", "",
            "| vertices | type | type, 2 threads | double | double, 2 threads | copying coordinates | bytes a vertex |",
            "| --- | --- | --- | --- | --- | --- | --- |"]
    copies = dict(sized(scale, r"copy/(\d+)"))
    for i, (objects, one) in enumerate(frames["Type", 1]):
        row = [number(frames[key][i][1].median) for key in frames]
        page.append(f"| {114 * objects:,} | " + " | ".join(row) + f" | {number(copies[objects].median)} | "
                    f"{one.counters['bytes_per_vertex']:.0f} |")
    page += ["", "![Time of a frame](pictures/performance_frames.svg)", "",
             "Sorting by depth, in ns for an object:", "",
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
            "them) is soon nothing beside them, and from there on the memory is the bound.", "",
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
            "(`--shard`), and **the time of the whole is computed** from the cases a second of that part.", "",
            "| level | cases | run here | cases a second | time of the whole | |",
            "| --- | --- | --- | --- | --- | --- |"]
    for level in (1, 2, 3):
        with open(f"{folder}/level_{level}.json", encoding="utf-8") as file:
            report = json.load(file)
        if report["mismatches"] or not report["complete"]:
            sys.exit(f"page.py: level {level}: {report['mismatches']} mismatches, complete: {report['complete']}")
        cases = sum(sum(row["streams"].values()) for row in report["rows"])
        rate = report["cases"] / report["seconds"]
        part = report["shard"][1]
        page.append(f"| {level} | {cases:,} | {report['cases']:,} in {report['seconds']:.1f} s | {rate / 1e6:,.1f} million | "
                    f"{duration(cases / rate)} | {'measured' if part == 1 else f'computed from 1/{part}'} |")
    return page + [""]


def plain_section(title, text, timed, base=None):
    return [f"## {title}", "", text, ""] + \
        table([(f"`{name}`", t) for name, t in timed.items()], base and (base, timed[base]))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = sys.argv[1]
    limit, context = read(folder, "limit_bench")
    everything = {name: read(folder, f"{name}_bench")[0]
                  for name in ("arithmetic", "batch", "radian", "model", "fill", "scene", "scale")}
    processor = "an unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            match = re.search(r"model name\s*: (.+)", file.read())
            processor = match.group(1) if match else processor
    page = ["# How quick everything is", "",
            "Made by `scripts/performance`, which builds and runs the programs of [bench/](../bench/README.md) one after "
            "the other; every program but `limit_bench` first holds what it computes against what it should be. Times are for one "
            "operation, vertex, call or frame: the least and the median of the repetitions, and the middle half of them "
            "in percent of the median. Compare within this page, not with that of another machine.", "",
            f"{processor}, {context['num_cpus']} processors; {context['compiler']}, `{context['flags']}`; "
            f"{context['date'][:10]}; load at the beginning {context['load_avg'][0]:.1f}.", ""]
    page += plain_section("What the processor can do",
                          "`limit_bench`: independent operations; for `copy`, one byte.", limit)
    page += batch_section(folder, everything["batch"], limit)
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
    with open(f"{folder}/performance.md", "w", encoding="utf-8") as file:
        file.write("\n".join(page).rstrip() + "\n")


main()
