#!/usr/bin/env python3
"""usage: hardening.py FOLDER hardened|plain COMPILER

Reads FOLDER/fixproof with readelf and objdump. hardened: every protection of support/cmake/hardening.cmake must be seen in the
program, not only in the options that it was built with. plain: nothing may be compiled with _FORTIFY_SOURCE, because it
hides errors from the sanitizers. COMPILER is CMake's name of the compiler: under Clang, the C++ side of glibc 2.36 checks
no sizes. Status 1 for any breach, 77 for a program that is not an ELF file.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

folder, wanted, compiler = Path(sys.argv[1]), *sys.argv[2:4]
program = folder / "fixproof"
if wanted == "plain":
    commands = (folder / "compile_commands.json").read_text()
    fortified = re.findall(r".{40}-D_FORTIFY_SOURCE.{20}", commands)
    print(fortified[0] if fortified else f"no _FORTIFY_SOURCE in {commands.count('-o ')} commands")
    sys.exit(1 if fortified or "-o " not in commands else 0)
if program.read_bytes()[:4] != b"\x7fELF" or not shutil.which("readelf"):
    print("skipped: needs an ELF file and readelf")
    sys.exit(77)
breaches = []


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def expect(holds, what):
    if not holds:
        breaches.append(what)


headers = output_of("readelf", "-hlW", str(program))
dynamic = output_of("readelf", "-dW", str(program))
symbols = set(re.findall(r"UND (\w+)", output_of("readelf", "--dyn-syms", "-W", str(program))))
segments = re.findall(r"^ +(\w+) +0x\w+ 0x\w+ 0x\w+ 0x\w+ 0x\w+ ([RWE ]{3})", headers, re.M)
expect(re.search(r"Type: +DYN", headers) and re.search(r"FLAGS_1.*\bPIE\b", dynamic),
       "the program is not position-independent")
expect("GNU_RELRO" in dict(segments), "no segment GNU_RELRO: relocations stay writable")
expect(re.search(r"\(FLAGS\).*BIND_NOW", dynamic) and re.search(r"FLAGS_1.*\bNOW\b", dynamic),
       "not bound at the start: the table of functions stays writable")
expect(dict(segments).get("GNU_STACK", "").strip() == "RW", f"the stack is {dict(segments).get('GNU_STACK')}, not RW")
expect(not [name for name, rights in segments if "W" in rights and "E" in rights],
       "a segment is writable and executable")
expect("TEXTREL" not in dynamic, "relocations in code")
expect("__stack_chk_fail" in symbols, "no stack protector: __stack_chk_fail is not called")
checked = {name for name in symbols if re.fullmatch(r"__\w+_chk", name)}
expect(checked or compiler != "GNU", "no _FORTIFY_SOURCE: no function of the C library that checks sizes is called")

processor = re.search(r"Machine: +(.*)", headers)[1]
if "X86-64" in processor:
    # The linker keeps the property of control-flow protection only if the C library's start files have it too, so
    # look at each object of the project.
    archives = sorted(path for path in folder.glob("**/lib*.a")
                      if not {"fuzz", "tests", "examples", "bench"} & set(path.relative_to(folder).parts))
    objects = 0
    for path in [*archives, *folder.glob("app/cli/CMakeFiles/fixproof.dir/**/*.o")]:
        notes = output_of("readelf", "-nW", str(path))
        for part in re.split(r"^File: ", notes, flags=re.M)[1:] or [notes]:
            objects += 1
            # The switch to 16-bit code jumps to targets without ENDBR, and says so.
            marks = ["SHSTK"] if "enter_segment.cpp.o" in part else ["IBT", "SHSTK"]
            expect(all(mark in part for mark in marks), f"{path.name}: {part[:60].split()[:1]}: no control-flow protection")
    expect(objects > 20, f"only {objects} objects of the project are found in {folder}")
    code = output_of("objdump", "-d", "--no-show-raw-insn", str(program))
    expect(code.count("endbr64") > 1000, f"{code.count('endbr64')} targets of indirect branches")
    # A frame of more than a page, which touches each page.
    expect(re.search(r"sub +\$0x1000,%rsp\n[^\n]*(?:or|mov)[ql] +\$0x0,\(%rsp\)", code),
           "no large frame probes the stack")

print("\n".join(breaches) or f"{processor}: all protections; {', '.join(sorted(checked))}")
sys.exit(1 if breaches else 0)
