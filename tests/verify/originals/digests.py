#!/usr/bin/env python3
"""usage: digests.py FIXPROOF ROOT

Assembles every listing of `fixproof list` with NASM, disassembles it with ndisasm, and compares the
digest of its canonical text with the table of docs/originals.md, which also defines that text. Then
plants changes of one instruction in every listing: each has to change the digest."""
import hashlib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

RELATIVE = re.compile(r"^(j\w+|loop\w*|call) (?:short |near )?0x([0-9a-f]+)$")
TABLE = re.compile(r"\[cs:bx[+-]0x[0-9a-f]+\]")
ROW = re.compile(r"^\| (\w+) \| (\w+) \| ([^|]*) \| (the author's|ours) \| (\d+) \| `([0-9a-f]{64})` \|$")
ROWS = 20


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr}")
    return done.stdout


def assemble(source):
    with tempfile.TemporaryDirectory() as folder:
        listing, code = Path(folder, "a.asm"), Path(folder, "a.bin")
        listing.write_text(source)
        run("nasm", "-w+all", "-w+error", "-f", "bin", "-o", code, listing)
        return code.read_bytes()


def disassemble(code):
    """(offset, text) of each instruction."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(code)
        file.flush()
        lines = run("ndisasm", "-b16", file.name).splitlines()
    split = (line.split(None, 2) for line in lines)
    return [(int(offset, 16), text) for offset, _, text in split]


def canonical(rows, start, end):
    """The canonical text of the instructions `rows`, which fill the bytes from `start` to `end`."""
    numbers, kept = {}, []
    for offset, text in rows:
        numbers[offset - start] = len(kept)
        if text != "nop":
            kept.append(text)
    lines = []
    for text in kept:
        jump = RELATIVE.match(text)
        if jump:
            # ndisasm prints targets modulo 2^16.
            target = (int(jump[2], 16) - start) & 0xFFFF
            inside = target in numbers and target < end - start
            text = f"{jump[1]} ->{numbers[target]}" if inside else f"{jump[1]} ext"
        text = re.sub(r"\b(byte|short|near) \+?", "", text)
        lines.append(TABLE.sub("[cs:bx+TAB]", text) + "\n")
    return "".join(lines)


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def routine(code):
    """The canonical text of a listing's first routine, which ends with its only RET."""
    rows = disassemble(code)
    last = next(i for i, (_, text) in enumerate(rows) if text == "ret")
    end = rows[last + 1][0] if last + 1 < len(rows) else len(code)
    return canonical(rows[: last + 1], 0, end)


def listing_of(fixproof, name, target, which):
    options = {"on": ["--round", "on"], "off": ["--round", "off"], "-": []}
    return run(fixproof, "list", name, "--target", target, *options.get(which, [which]))


OTHER_MNEMONIC = {
    "mov": "add", "push": "pop", "pop": "push", "add": "adc", "adc": "add", "sub": "sbb",
    "sbb": "sub", "cmp": "sub", "neg": "not", "inc": "dec", "dec": "inc", "mul": "imul",
    "imul": "mul", "div": "idiv", "idiv": "div", "and": "xor", "xor": "and", "shl": "shr",
    "shr": "sar", "sar": "shr", "rol": "ror", "shld": "shrd", "shrd": "shld", "jmp": "js",
    "js": "jns", "jns": "js", "jz": "jnz", "ja": "jg", "jg": "ja", "ret": "retf",
}


def other_operand(line, labels):
    """The line with another place to jump to, without CS:, or with its last number 2 larger. Where a
    call leads and where in the table a read is, the canonical text does not say: see the document."""
    if "call" in line:
        return None
    where = labels.index(line.split(".")[1]) if "." in line else None
    if where is not None:
        other = labels[where - 1]
        return None if labels[where] == other else line.replace(labels[where], other)
    if "cs:" in line:
        return line.replace("cs:", "")
    found = re.match(r"(.*?)(0x8000|\d+)(\]?)$", line)
    return f"{found[1]}{int(found[2], 0) + 2}{found[3]}" if found else None


def planted(source):
    """Sources of the first routine alone: as it is, then each with one instruction changed."""
    lines = source.splitlines()
    first = next(i for i, line in enumerate(lines) if re.match(r"^\w+:", line))
    last = lines.index("        ret")
    body = [re.sub(r"call \w+", "call near $+0x6000", line) for line in lines[first + 1 : last + 1]]
    yield "as it is", body
    labels = [line[1:-1] for line in body if line.startswith(".")]
    for i, line in enumerate(body):
        if line.startswith("."):
            continue
        mnemonic, _, operands = line.strip().partition(" ")
        if mnemonic in OTHER_MNEMONIC:
            yield line, body[:i] + [f"{OTHER_MNEMONIC[mnemonic]} {operands}"] + body[i + 1 :]
        changed = other_operand(line, labels)
        if changed:
            yield line, body[:i] + [changed] + body[i + 1 :]
        yield line + " left out", body[:i] + body[i + 1 :]
        yield line + " twice", body[:i] + [line] + body[i:]


def digests_of_planted(source):
    """(change, digest) of each, all assembled as one file: a label before each, their offsets last."""
    changes, text = [], ["        cpu 386", "        bits 16", "        CosTable equ 0x2000"]
    for change, body in planted(source):
        text += [f"V{len(changes)}:", *body]
        changes.append(change)
    text += [f"V{len(changes)}:", *(f"        dd V{i}" for i in range(len(changes) + 1))]
    code = assemble("\n".join(text) + "\n")
    table = 4 * (len(changes) + 1)
    offsets = [int.from_bytes(code[i : i + 4], "little") for i in range(len(code) - table, len(code), 4)]
    rows = disassemble(code[:-table])
    at = 0
    for i, change in enumerate(changes):
        begin = at
        while at < len(rows) and rows[at][0] < offsets[i + 1]:
            at += 1
        yield change, digest(canonical(rows[begin:at], offsets[i], offsets[i + 1]))


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: digests.py FIXPROOF ROOT")
    fixproof, root = sys.argv[1], Path(sys.argv[2])
    wanted = [found.groups() for line in (root / "docs/originals.md").read_text().splitlines()
              if (found := ROW.match(line))]
    if len(wanted) != ROWS:
        sys.exit(f"docs/originals.md: {len(wanted)} rows of digests, not {ROWS}")
    wrong, seen, changes = 0, set(), 0
    for name, target, which, whose, instructions, expected in wanted:
        source = listing_of(fixproof, name, target, which)
        text = routine(assemble(source))
        where = f"{name} {target} {which}"
        if digest(text) != expected or text.count("\n") != int(instructions):
            print(f"{where}: {text.count(chr(10))} instructions, {digest(text)}; docs/originals.md has "
                  f"{instructions}, {expected}")
            wrong += 1
        if f"; digest: {expected}, {whose}, {instructions} instructions\n" not in source:
            print(f"{where}: fixproof list names another digest or length")
            wrong += 1
        if text in seen:
            continue
        seen.add(text)
        for change, after in digests_of_planted(source):
            changes += 1
            if (after == expected) != (change == "as it is"):
                print(f"{where}: {change}: the digest does not tell")
                wrong += 1
    print(f"{len(wanted)} listings, {changes} planted changes, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
