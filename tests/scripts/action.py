#!/usr/bin/env python3
"""usage: action.py ROOT FIXPROOF EXAMPLES

Runs action.yml as GitHub would, in a repository with an assembly routine and a C program, with the step that docs/ci.md
shows. A right routine must pass, and a wrong one must fail. The command is not compiled again: FIXPROOF takes its place.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

root, fixproof, examples = (Path(argument).resolve() for argument in sys.argv[1:])
action = yaml.safe_load((root / "action.yml").read_text(encoding="utf-8"))


def documented_step():
    """The step in docs/ci.md that calls the action."""
    for block in re.findall(r"```yaml\n(.*?)```", (root / "docs/ci.md").read_text(encoding="utf-8"), re.S):
        if "/fixproof@" in block:
            (step,) = yaml.safe_load(block)
            return step
    sys.exit("docs/ci.md has no step that uses the action")


def status_of(repository, action_path, inputs):
    """The status of the first step that fails, or 0, and what it prints."""
    unknown = inputs.keys() - action["inputs"].keys()
    if unknown:
        sys.exit(f"action.yml has no input {', '.join(sorted(unknown))}")
    for step in action["runs"]["steps"]:
        if step["shell"] != "bash":
            sys.exit(f"action.yml: this test runs only bash, not {step['shell']}")
        environment = {name: re.sub(r"\$\{\{ inputs\.(\w+) \}\}", lambda match: inputs[match[1]], value)
                       for name, value in step.get("env", {}).items()}
        # What `shell: bash` means on GitHub.
        ran = subprocess.run(["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", "-c", step["run"]],
                             cwd=repository, check=False, capture_output=True, text=True,
                             env=os.environ | environment | {"GITHUB_ACTION_PATH": str(action_path)})
        if ran.returncode:
            return ran.returncode, ran.stdout + ran.stderr
    return 0, ""


with tempfile.TemporaryDirectory() as folder:
    repository, action_path = Path(folder) / "mine", Path(folder) / "action"
    (repository / "src").mkdir(parents=True)
    (action_path / "build/release").mkdir(parents=True)
    (action_path / "build/release/fixproof").symlink_to(fixproof)
    # The real script would compile everything; it must know the words that it is given.
    (action_path / "run").write_text('#!/bin/sh\n[ "$*" = "-- --help" ]\n')
    (action_path / "run").chmod(0o755)
    if not os.access(root / "run", os.X_OK):
        sys.exit("run cannot be run")
    shutil.copy(examples / "plain", repository / "multiply")
    step = documented_step()

    routine = (root / "tests/judge/code/routines/mul.asm").read_text(encoding="utf-8")
    (repository / "src/mul.asm").write_text(routine)
    status, said = status_of(repository, action_path, step["with"])
    if status:
        sys.exit(f"the documented step fails with status {status}: {said}")
    (repository / "src/mul.asm").write_text(routine.replace("adc edx, 0", "nop"))
    if status_of(repository, action_path, step["with"])[0] != 1:
        sys.exit("a routine that loses a carry passes")
    if status_of(repository, action_path, {"run": "fixproof judge src/missing.asm --as mul\ntrue"})[0] != 2:
        sys.exit("a failure before the last line does not end the step")
print("the documented step passes; a lost carry and a missing file fail it")
