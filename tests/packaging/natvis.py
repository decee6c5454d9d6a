"""usage: natvis.py TREE

The natvis file is XML of the schema's elements, has rules for 16.16, for 8.8 and for any number, and names only
the member that there is, divided by the right power of two.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

root = pathlib.Path(sys.argv[1])
space = "{http://schemas.microsoft.com/vstudio/debugger/natvis/2010}"
tree = xml.etree.ElementTree.parse(root / "fixed/debuggers/fixproof.natvis").getroot()
assert tree.tag == space + "AutoVisualizer", tree.tag
assert " raw_type raw_ = 0;" in (root / "fixed/number.hpp").read_text()

widths = []
for rule in tree:
    assert rule.tag == space + "Type", rule.tag
    raw, bits = re.fullmatch(r"fixproof::number<(.*?),(.*?),\*>", rule.attrib["Name"]).groups()
    one = "(double)(1ull << $T2)" if bits == "*" else f"{2**int(bits)}.0"
    shown = rule.find(space + "DisplayString").text
    items = [item.text for item in rule.find(space + "Expand")]
    assert f"raw_ / {one}" in shown and f"raw_ / {one}" in items, (bits, shown, items)
    for expression in re.findall(r"\{(.*?)\}", shown) + items:
        names = set(re.findall(r"[a-z_]+", re.sub(r",[a-z]+$", "", expression)))
        assert names <= {"raw_", "unsigned", "int", "short", "double", "ull"}, expression
    widths.append((raw, bits))
assert widths == [("int", "16"), ("short", "8"), ("*", "*")], widths
print(f"natvis: {len(widths)} rules")
