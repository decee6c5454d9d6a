#!/usr/bin/env python3
"""usage: performance.py [--quick] | --verify PROGRAM

Builds measure/bench/fair with two compilers and two sets of flags, times all contenders in turn, and writes the tables of
docs/performance.md. build/performance/ gets results.json and a table of times for each build. Takes a quarter of
an hour.
--quick times for a moment, and leaves docs/performance.md alone. --verify PROGRAM only prints the error of each
contender of one build, over few operands.
Exit status 0: done. 1: the number type or a batch has a wrong result. 2: a build or a program fails. 130: stopped.
"""

import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import time

import page

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORK = os.path.join(ROOT, "build", "performance")
PAGE = os.path.join(ROOT, "docs", "performance.md")
COMPILERS = ("g++", "clang++-14")
FLAGS = ("-O2", "-O3 -march=native")
# Else a loop over std::sqrt checks for errors, on either side.
COMMON_FLAGS = "-fno-math-errno"
# Where its code and its data lie changes the time of a short span by a clock cycle, for ours and for peers. So each pass is
# a process, of a program whose code lies elsewhere. Another user of a shared machine slows one contender for seconds, so
# only the middle half of the passes counts.
PASSES = 12
ROUNDS = 5


class Failed(Exception):
    """A build or a program fails."""


def say(text):
    print(f"performance: {text}", file=sys.stderr, flush=True)


def run(command, log):
    """Runs a command and returns its output, or raises Failed with the end of what it said."""
    with open(log, "w", encoding="utf-8") as errors:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=errors, text=True, check=False)
    if done.returncode != 0:
        with open(log, encoding="utf-8") as errors:
            said = (done.stdout + errors.read()).splitlines()[-15:]
        raise Failed("\n".join([f"{' '.join(command)}: status {done.returncode}, see {log}", *said]))
    return done.stdout


def build(compiler, flags):
    """Builds one program, with its code in PASSES places. Returns the paths and the peers that are not installed."""
    folder = os.path.join(WORK, re.sub(r"[^\w+]+", "-", f"{compiler}{flags}"))
    os.makedirs(folder, exist_ok=True)
    log = folder + ".log"
    options = ("CMAKE_BUILD_TYPE=", f"CMAKE_CXX_COMPILER={compiler}", f"CMAKE_CXX_FLAGS={flags} {COMMON_FLAGS}",
               f"FAIR_PLACES={PASSES}")
    said = run(["cmake", "-S", os.path.join(ROOT, "measure", "bench", "fair"), "-B", folder, "-G", "Ninja",
                *(f"-D{option}" for option in options)], log)
    run(["cmake", "--build", folder], log)
    return [os.path.join(folder, f"fair_{place}") for place in range(PASSES)], re.findall(r"fair: without (\S+),", said)


def results(program, options):
    return [json.loads(line) for line in run([program, *options], program + ".log").splitlines()]


def middle(times):
    """The mean of the middle half of the times."""
    quarter = len(times) // 4
    return statistics.fmean(sorted(times)[quarter : len(times) - quarter])


def merge(passes):
    """The middle() time of the passes and the largest error of each contender. A contender's error in one cell holds for
    all cells of the operation: a chain, for example, meets few operands."""
    times, errors = {}, {}
    for one in passes:
        for r in one:
            key = (r["operation"], r["shape"], r["elements"], r["offset"], r["name"])
            times.setdefault(key, []).append(r)
            who = (r["operation"], r["name"])
            errors[who] = max(errors.get(who, 0), r["error"])
    return [{**of[0], "error": errors[of[0]["operation"], of[0]["name"]], "ns": middle([r["ns"] for r in of])}
            for of in times.values()]


def check_ours(build_name, merged):
    wrong = {(r["operation"], r["name"], r["error"]) for r in merged if r["ours"] and not page.is_right(r)}
    for operation, name, error in sorted(wrong):
        say(f"{build_name}: {operation} by our {name} is wrong by {error} ulp")
    return not wrong


def verify(program):
    merged = merge([results(program, ["--verify", "--most", "4096"])])
    for operation, name, label in sorted({(r["operation"], r["name"], page.label(r)) for r in merged}):
        print(f"{operation}: {name}: {label}")
    return 0 if check_ours(program, merged) else 1


def write(path, text):
    """Replaces a file only once all of it is written."""
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        processor = re.search(r"model name\s*: (.+)", file.read())
    return f"{processor.group(1) if processor else 'an unknown processor'}, {os.cpu_count()} processors"


def version(compiler):
    return subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]


def measure(quick):
    os.makedirs(WORK, exist_ok=True)
    start = time.monotonic()
    programs, missing = {}, {}
    pairs = [(compiler, flags) for compiler in COMPILERS for flags in FLAGS]
    for i, (compiler, flags) in enumerate(pairs):
        name = f"{compiler} {flags}"
        if not shutil.which(compiler):
            missing[name] = [compiler]
            say(f"{name}: left out, {compiler} is not installed")
            continue
        say(f"building {i + 1} of {len(pairs)}: {name}, about 1 min")
        programs[name], missing[name] = build(compiler, flags)
        for peer in missing[name]:
            say(f"{name}: without {peer}, which is not installed")
    if not programs:
        raise Failed(f"neither {' nor '.join(COMPILERS)} is installed")
    options = ["--most", "4096", "--rounds", "3"] if quick else ["--rounds", str(ROUNDS)]
    passes = {name: [] for name in programs}
    total = len(programs) * (1 if quick else PASSES)
    before = time.monotonic()
    for done in range(total):
        name = list(programs)[done % len(programs)]
        left = f"about {(time.monotonic() - before) / done * (total - done):.0f} s left" if done else "half a minute each"
        say(f"timing {done + 1} of {total}: {name}, {left}")
        passes[name].append(results(programs[name][len(passes[name])], options))
    merged = {name: merge(all_passes) for name, all_passes in passes.items()}
    right = all([check_ours(name, rows) for name, rows in merged.items()])
    if not right:
        return 1
    context = {"machine": machine(), "compilers": [version(c) for c in COMPILERS if shutil.which(c)],
               "flags": COMMON_FLAGS, "date": time.strftime("%Y-%m-%d"), "missing": missing}
    write(os.path.join(WORK, "results.json"), json.dumps({"context": context, "results": merged}, indent=1))
    for name, rows in merged.items():
        write(os.path.join(WORK, re.sub(r"[^\w+]+", "-", name) + ".md"), page.times(name, rows))
    if not quick:
        with open(PAGE, encoding="utf-8") as file:
            write(PAGE, page.replaced(file.read(), context, merged))
    say(f"done in {time.monotonic() - start:.0f} s: {WORK}/results.json" + ("" if quick else f", {PAGE}"))
    return 0


def main():
    arguments = sys.argv[1:]
    if arguments in (["-h"], ["--help"]):
        print(__doc__.strip())
        return 0
    if len(arguments) == 2 and arguments[0] == "--verify":
        return verify(arguments[1])
    if arguments in ([], ["--quick"]):
        return measure(bool(arguments))
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        say("stopped; docs/performance.md is unchanged")
        sys.exit(130)
    except (Failed, OSError, page.Damaged) as failure:
        say(str(failure))
        sys.exit(2)
