#!/usr/bin/env python3
"""usage: python3 measure/bench/neon.py

Counts the instructions that batches and their peers execute for an element on AArch64, where batches take NEON, and
prints a table for docs/performance.md. Compiles measure/bench/fair for AArch64 with g++ and clang++ and runs it in QEMU, which
logs every instruction. Peers whose libraries are not installed for AArch64 do not take part. Takes five minutes.
Needs g++-aarch64-linux-gnu, clang and qemu-user.
Exit status 0: done. 1: a batch has a wrong result. 2: a program is missing or fails. 130: stopped.
"""

import json
import os
import subprocess
import sys
import tempfile

import page

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
COMPILERS = {"g++": ["aarch64-linux-gnu-g++"], "clang++": ["clang++", "--target=aarch64-linux-gnu"]}
FLAGS = ["-std=c++20", "-O3", "-fno-math-errno", "-I", ROOT]
EMULATOR = ["qemu-aarch64"]
ELEMENTS = 1024
TIMES = (1, 9)  # calls: their difference leaves out what a program does before and after


class Failed(Exception):
    """A program is missing or fails."""


def run(command, **options):
    try:
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **options).stdout
    except (OSError, subprocess.CalledProcessError) as failure:
        raise Failed(f"{command[0]}: {failure}") from failure


def build(compiler, folder):
    """Returns the program that verifies contenders and the one that runs a single one."""
    objects = []
    for name in ("fair/arithmetic", "fair/angles", "fair/sums", "fair/highway", "fair/main", "instructions"):
        objects.append(f"{folder}/{os.path.basename(name)}.o")
        run([*compiler, *FLAGS, "-c", f"{ROOT}/measure/bench/{name}.cpp", "-o", objects[-1]])
    programs = []
    for name in ("main", "instructions"):
        programs.append(f"{folder}/{name}")
        run([*compiler, "-static", *objects[:4], f"{folder}/{name}.o", "-o", programs[-1]])
    return programs


def executed(program, operation, name, times):
    log = f"{os.path.dirname(program)}/log"
    run([*EMULATOR, "-singlestep", "-d", "exec,nochain", "-D", log, program, operation, name, str(ELEMENTS), str(times)])
    with open(log, "rb") as lines:
        return sum(line.startswith(b"Trace ") for line in lines)


def counted(compiler, folder):
    """The contenders of batches, with their instructions for an element in place of their times."""
    verifier, program = build(compiler, folder)
    rows = [json.loads(line) for line in run([*EMULATOR, verifier, "--verify", "--most", str(ELEMENTS)]).splitlines()]
    rows = [r for r in rows if r["shape"] == "batch" and r["operation"] != page.COPIES]
    worst = {}
    for r in rows:
        key = (r["operation"], r["name"])
        worst[key] = max(worst.get(key, 0), r["error"])
    kept = []
    for r in {(r["operation"], r["name"]): r for r in rows}.values():
        r["error"] = worst[r["operation"], r["name"]]
        if not page.is_right(r):
            if r["ours"]:
                sys.exit(f"neon: {r['operation']}: the batch is wrong by {r['error']} ulp")
            continue
        print(f"neon: {compiler[0]}: {r['operation']}, {r['name']}", file=sys.stderr)
        few, many = (executed(program, r["operation"], r["name"], times) for times in TIMES)
        kept.append(r | {"elements": ELEMENTS, "offset": 0, "ns": (many - few) / (TIMES[1] - TIMES[0]) / ELEMENTS})
    return kept


def line_of(cell):
    peer = page.best_peer(cell)
    return [f"{page.ours_of(cell)['ns']:.2f}", f"{peer['ns']:.2f} {page.CODES[peer['name']]}", f"{page.ratio(cell):.2f}"]


def main():
    if len(sys.argv) > 1:
        print(__doc__.strip())
        return 0 if sys.argv[1] in ("-h", "--help") else 2
    found = {}
    for name, compiler in COMPILERS.items():
        with tempfile.TemporaryDirectory() as folder:
            for key, cell in page.cells(counted(compiler, folder)).items():
                found.setdefault(key[0], []).extend(line_of(cell))
    head = ["operation", *(f"{name}: {what}" for name in COMPILERS for what in ("ours", "best exact peer", "ratio"))]
    print(page.table(head, [[operation, *cells] for operation, cells in found.items()]))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failed as failure:
        print(f"neon: {failure}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
