#!/usr/bin/env python3
"""usage: workflow.py ROOT

Holds ROOT/.github/workflows/*.yml to what can be told without running them: they parse, ask for no rights but those of
publishing the playground, and run
nothing but scripts of the tree, with presets, labels, processors and options that there are. Actions are named by commit
with the version beside them, and images by digest, also in the documents and docs/scale. Status 1 for any breach.
"""

import itertools
import json
import os
import re
import shlex
import sys
from pathlib import Path

import yaml

root = Path(sys.argv[1])
breaches = []
# The rights of the one job that publishes.
PUBLISHES = {"contents": "read", "pages": "write", "id-token": "write"}


def expanded(text, matrix):
    """The text under each choice of the matrix."""
    for choice in itertools.product(*matrix.values()):
        values = dict(zip(matrix, choice))
        yield re.sub(r"\$\{\{ matrix\.(\w+) \}\}", lambda name: str(values[name[1]]), text)



presets = {preset["name"] for preset in json.loads((root / "CMakePresets.json").read_text())["testPresets"]}
labels = set(re.findall(r"LABELS (\w+)", " ".join(path.read_text() for path in root.glob("tests/**/CMakeLists.txt"))))
processors = set(re.findall(r'^  "(\w+) [\w-]+-(?:linux-gnu|w64-mingw32)', (root / "tests/tools/platforms").read_text(), re.M))


def check_command(place, command):
    """One command of a step; the commands of prepare.sh are known once it is read."""
    words = shlex.split(command)
    if words[0] == "install_packages":
        return
    script = words[1] if words[0] == "source" else words[0]
    if not (root / script).is_file():
        breaches.append(f"{place}: no script {script}")
    elif words[0] != "source" and not os.access(root / script, os.X_OK):
        breaches.append(f"{place}: {script} cannot be run")
    if script.startswith("tests/tools/") and words[0] != "source":
        known = set(re.findall(r"--[a-z][a-z-]*", (root / script).read_text()))
        breaches.extend(f"{place}: {script} has no {word}" for word in words[1:]
                        if word.startswith("--") and word not in known)
    if script == "./test":
        preset, *options = words[1:]
        if preset not in presets:
            breaches.append(f"{place}: no preset {preset}")
        if options and (options[0] != "-L" or options[1] not in labels):
            breaches.append(f"{place}: no label {' '.join(options)}")
    if script == "tests/tools/platforms":
        breaches.extend(f"{place}: no processor {word}" for word in words[3:] if word not in processors)
        return words[3:]


def check_pins(path):
    """Every action and image that a file names; a comment cannot be seen once YAML is parsed."""
    pins = 0
    local = set()  # stages of a Containerfile
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        place = f"{path.relative_to(root)}:{number}"
        action = re.match(r"[\s-]*uses:\s*(.*)", line)
        image = re.match(r"\s*(?:container|image):\s*(\S.*)|FROM\s+(?:--\S+\s+)*(\S+)(?:\s+AS\s+(\S+))?\s*$", line,
                         re.IGNORECASE)
        if action:
            pins += 1
            # This project's own action, under the name of whoever publishes it.
            if not re.fullmatch(r"[\w./-]+@[0-9a-f]{40} +# v\d+(\.\d+)+|OWNER/fixproof@v\d+(\.\d+)+", action[1]):
                breaches.append(f"{place}: {action[1]}: write ACTION@COMMIT  # vVERSION, with all 40 digits")
        elif image:
            pins += 1
            name = image[1] or image[2]
            local.add(image[3])
            # docs/scale.md builds this image, so it has no public digest.
            pinned = re.fullmatch(r"[\w./:-]+:[\w.-]+@sha256:[0-9a-f]{64}", name)
            if not pinned and name not in local | {"fixproof:latest"}:
                breaches.append(f"{place}: {name}: write IMAGE:TAG@sha256:DIGEST, with all 64 digits")
    return pins


def check_workflow(path):
    workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
    if workflow.get("permissions") != {"contents": "read"}:
        breaches.append(f"{path.name}: permissions are not contents: read")
    commands = 0
    tried = set()
    for name, job in workflow["jobs"].items():
        place = f"{path.name}: {name}"
        if job.get("permissions") != (PUBLISHES if name == "pages" else None):
            breaches.append(f"{place}: asks for rights of its own")
        if "timeout-minutes" not in job:
            breaches.append(f"{place}: may hang for hours")
        matrix = job.get("strategy", {}).get("matrix", {})
        for step in job["steps"]:
            for line in step.get("run", "").splitlines():
                for run in expanded(line, matrix):
                    for command in run.split("&&"):
                        tried.update(check_command(place, command) or ())
                        commands += 1
    if path.name == "ci.yml" and tried != processors:
        breaches.append(f"{path.name}: not tried: {' '.join(sorted(processors - tried))}")
    print(f"{path.name}: {len(workflow['jobs'])} jobs, {commands} commands")
    return commands


commands = sum(check_workflow(path) for path in sorted((root / ".github/workflows").glob("*.yml")))
pins = sum(check_pins(path) for pattern in (".github/workflows/*.yml", "action.yml", "docs/*.md", "docs/scale/*")
           for path in sorted(root.glob(pattern)))
print(f"{pins} actions and images")
if not (commands and pins and presets and labels and processors):
    breaches.append("nothing was checked")
print("\n".join(breaches))
sys.exit(1 if breaches else 0)
