#!/usr/bin/env python3
"""usage: provenance.py FOLDER VERSION

Writes FOLDER/fixproof-VERSION.provenance.json: which commit and which compilers made the files of FOLDER, as a statement of
in-toto (https://in-toto.io/Statement/v1) with the predicate of SLSA (https://slsa.dev/provenance/v1). Nobody signs it.
"""
import hashlib
import json
import subprocess
import sys
from pathlib import Path

folder, version = Path(sys.argv[1]), sys.argv[2]
root = Path(__file__).resolve().parents[2]


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, cwd=root).stdout


def package(name):
    return {"name": name, "version": said("dpkg-query", "-W", "-f", "${Version}", name)}


commit = said("git", "rev-parse", "HEAD").strip()
compilers = [said("readlink", "-f", f"/usr/bin/{name}").strip()
             for name in ("g++", "aarch64-linux-gnu-g++", "clang++-14", "nasm")]
owners = sorted({said("dpkg-query", "-S", path).split(":")[0] for path in compilers})
statement = {
    "_type": "https://in-toto.io/Statement/v1",
    "subject": [{"name": path.name, "digest": {"sha256": hashlib.sha256(path.read_bytes()).hexdigest()}}
                for path in sorted(folder.iterdir())],
    "predicateType": "https://slsa.dev/provenance/v1",
    "predicate": {
        "buildDefinition": {
            "buildType": "https://example.org/fixproof/app/packages/build",
            "externalParameters": {"version": version, "command": "app/packages/build"},
            "resolvedDependencies": [{"uri": "git+https://example.org/fixproof.git", "digest": {"gitCommit": commit}}],
            "internalParameters": {"compilers": [package(name) for name in owners]}},
        "runDetails": {"builder": {"id": "https://example.org/fixproof/app/packages/build"}}}}
(folder / f"fixproof-{version}.provenance.json").write_text(json.dumps(statement, indent=1) + "\n")
