#!/usr/bin/env python3
"""usage: verified.py ROOT PROGRAM

What `performance.py --verify` says about the contenders of one build, over few operands.
"""

import os
import stat
import subprocess
import sys
import tempfile

root, program = sys.argv[1:]
SCRIPT = os.path.join(root, "measure", "bench", "performance.py")


def verdicts(of):
    return subprocess.run([sys.executable, SCRIPT, "--verify", of], capture_output=True, text=True, check=False)


def expect(condition, message):
    if not condition:
        sys.exit(message)


done = verdicts(program)
expect(done.returncode == 0, f"status {done.returncode}: {done.stdout}{done.stderr}")
lines = set(done.stdout.splitlines())

# By hand, in words: 1 * 65535 is 65535/65536, and 1 / 65537 is 65536/65537. Who rounds them down is that far off.
for line in ("multiply: batch: exact", "multiply: type: exact", "multiply: idiom: exact",
             "multiply: idiom, rounds down: up to 0.999985 ulp", "divide: idiom, truncates: up to 0.999985 ulp",
             "divide: batch: exact", "divide: double: exact", "sqrt: batch: exact", "sin: type: exact",
             "sin_cos within 8: batch: exact", "dot: batch: exact", "from double: floor: exact",
             "to double: batch: exact", "transform, columns: batch: exact products, up to 1.5 ulp",
             "transform, columns: Highway: exact products, up to 1.5 ulp" if "transform, columns: Highway" in done.stdout
             else "transform, columns: idiom: exact products, up to 1.5 ulp",
             "fused transform, columns: idiom, one rounding: exact", "fused transform, columns: batch: exact",
             "fused transform, interleaved: batch: exact"):
    expect(line in lines, f"no '{line}' in:\n{done.stdout}")

# A program whose batch is wrong.
with tempfile.TemporaryDirectory() as folder:
    wrong = os.path.join(folder, "wrong")
    with open(wrong, "w", encoding="utf-8") as file:
        file.write("""#!/bin/sh
echo '{"operation": "dot", "shape": "batch", "elements": 4, "offset": 0,
  "name": "batch", "ours": true, "error": 0.51, "ns": 0}' | tr -d '\\n'
""")
    os.chmod(wrong, stat.S_IRWXU)
    done = verdicts(wrong)
    expect(done.returncode == 1 and "dot by our batch is wrong by 0.51 ulp" in done.stderr,
           f"a wrong batch: status {done.returncode}: {done.stdout}{done.stderr}")
