"""usage: natvis.py TREE

The natvis file is XML of the schema's elements, has a rule for each width of number, and names only the
member that there is, divided by the right power of two.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

root = pathlib.Path(sys.argv[1])
space = "{http://schemas.microsoft.com/vstudio/debugger/natvis/2010}"
tree = xml.etree.ElementTree.parse(root / "packaging/debuggers/fixproof.natvis").getroot()
assert tree.tag == space + "AutoVisualizer", tree.tag
assert " raw_type raw_ = 0;" in (root / "fixed/number.hpp").read_text()

widths = []
for rule in tree:
    assert rule.tag == space + "Type", rule.tag
    bits = int(re.fullmatch(r"fixproof::number<(\d+),\*>", rule.attrib["Name"])[1])
    shown = rule.find(space + "DisplayString").text
    items = [item.text for item in rule.find(space + "Expand")]
    assert f"raw_ / {2**bits}.0" in shown and f"raw_ / {2**bits}.0" in items, (bits, shown, items)
    for expression in re.findall(r"\{(.*?)\}", shown) + items:
        names = set(re.findall(r"[a-z_]+\w*", re.sub(r",[a-z]+$", "", expression)))
        assert names <= {"raw_", "unsigned", "int", "short"}, expression
    widths.append(bits)
assert sorted(widths) == [8, 16], widths
print(f"natvis: {len(widths)} rules")
