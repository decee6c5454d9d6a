#!/usr/bin/env python3
"""usage: notices.py BILL FOLDER SYSROOT

Writes the licence of every library that is part of a package to FOLDER/LIBRARY, from the copyright files of Debian. BILL is
the bill of materials of tests/tools/sbom, SYSROOT the folder with the libraries. Status 2: a library has no copyright file.
"""
import json
import sys
from pathlib import Path

bill, folder = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
names = {package["SPDXID"]: package["name"] for package in bill["packages"]}
# Libraries that are linked or lie beside the command, and headers, whose code is compiled in.
ends = {relation["relatedSpdxElement"] if relation["relationshipType"] != "BUILD_DEPENDENCY_OF" else relation["spdxElementId"]
        for relation in bill["relationships"]
        if relation["relationshipType"] in ("DYNAMIC_LINK", "DEPENDS_ON", "STATIC_LINK", "BUILD_DEPENDENCY_OF")}
# The C library and the kernel's headers are those of the system. Boost's licence asks for no notice with programs, and
# its file here is 2 MB.
without = ("libc6", "linux-libc", "libboost")
texts = {}
for name in sorted({names[end] for end in ends if not names[end].startswith(without)}):
    # The headers of a cross compiler are installed on this system, not under SYSROOT.
    source = next((path for root in (sys.argv[3], "/")
                   if (path := Path(root, "usr/share/doc", name, "copyright")).is_file()), None)
    if not source:
        print(f"notices.py: install the package {name} with its documentation", file=sys.stderr)
        sys.exit(2)
    texts.setdefault(source.read_text(errors="replace"), []).append(name)
for text, owners in texts.items():
    (folder / owners[0]).write_text(f"Fixproof has code of {', '.join(owners)}:\n\n{text}\n")
