#!/usr/bin/env python3
"""usage: sbom.py ROOT FOLDER

Runs tests/tools/sbom on the build in FOLDER, and holds its output to the form of SPDX 2.3, to what ldd says of the command,
to the libraries that CMake found, and to app/report/vendor. Status 1 for any breach, 77 without dpkg or Ninja.
"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

root, folder = Path(sys.argv[1]), Path(sys.argv[2])
if not shutil.which("dpkg-query") or not shutil.which("ninja") or not (folder / "build.ninja").is_file():
    print("skipped: needs Debian's dpkg-query, and a build by Ninja")
    sys.exit(77)
breaches = []


def expect(holds, what):
    if not holds:
        breaches.append(what)


def owners(paths):
    """The package of each file, by the lists of dpkg itself, which tests/tools/sbom does not read."""
    wanted = {name: path for path in paths
              for name in (os.path.realpath(path), os.path.realpath(path).replace("/usr/lib", "/lib", 1))}
    found = {path: f"no package with {path}" for path in paths}
    for list_ in sorted(Path("/var/lib/dpkg/info").glob("*.list")):
        for name in wanted.keys() & set(list_.read_text().split("\n")):
            found[wanted[name]] = list_.stem.split(":")[0]
    return found


def sbom(*arguments):
    return subprocess.run([str(root / "tests/tools/sbom"), *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "SOURCE_DATE_EPOCH": "0"})


with tempfile.TemporaryDirectory() as temporary:
    output = Path(temporary) / "bill.json"
    run = sbom("--output", output, folder)
    if run.returncode:
        sys.exit(f"tests/tools/sbom has status {run.returncode}: {run.stderr}")
    bill = json.loads(output.read_text())
    nothing = sbom(temporary)
    expect(nothing.returncode == 2 and "no build" in nothing.stderr, f"a folder without a build: {nothing}")

# The form: https://spdx.github.io/spdx-spec/v2.3/
for name, pattern in {"spdxVersion": r"SPDX-2\.3", "dataLicense": r"CC0-1\.0", "SPDXID": "SPDXRef-DOCUMENT",
                      "name": r"fixproof-\d+\.\d+\.\d+", "documentNamespace": r"https://[^#]+[0-9a-f]{64}"}.items():
    expect(re.fullmatch(pattern, bill.get(name, "")), f"{name}: {bill.get(name)}")
expect(bill["creationInfo"]["created"] == "1970-01-01T00:00:00Z", f"created {bill['creationInfo']['created']}")
expect(re.fullmatch(r"Tool: \S+", bill["creationInfo"]["creators"][0]), "no creator")
identifiers = [element["SPDXID"] for element in [bill, *bill["packages"], *bill["files"]]]
expect(len(identifiers) == len(set(identifiers)), "an identifier occurs twice")
expect(all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name) for name in identifiers), "a malformed identifier")
for package in bill["packages"]:
    for key in ("name", "versionInfo", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"):
        expect(package.get(key), f"{package['SPDXID']}: no {key}")
    expect(package.get("filesAnalyzed") is False, f"{package['SPDXID']}: files are not analyzed")
    for reference in package.get("externalRefs", []):
        locator = reference["referenceLocator"]
        expect(re.fullmatch(r"pkg:(deb/\w+|npm)/[\w.%+-]+(/[\w.%+-]+)?@[\w.%+~-]+(\?arch=\w+)?", locator),
               f"{package['SPDXID']}: {locator}")
for file in bill["files"]:
    sums = {sum_["algorithm"]: sum_["checksumValue"] for sum_ in file["checksums"]}
    path = folder / "fixproof" if file["fileName"] == "./fixproof" else root / file["fileName"]
    for kind in ("SHA1", "SHA256"):
        expect(sums.get(kind) == hashlib.new(kind, path.read_bytes()).hexdigest(), f"{path}: another {kind}")
for relation in bill["relationships"]:
    expect({relation["spdxElementId"], relation["relatedSpdxElement"]} <= set(identifiers), f"dangling: {relation}")
kinds = {relation["relationshipType"] for relation in bill["relationships"]}
expect(kinds >= {"DESCRIBES", "CONTAINS", "DYNAMIC_LINK", "DEPENDS_ON", "BUILD_DEPENDENCY_OF", "BUILD_TOOL_OF"},
       f"only {kinds}")
linked = {relation["relatedSpdxElement"] for relation in bill["relationships"]
          if relation["relationshipType"] in ("DYNAMIC_LINK", "STATIC_LINK")}
for package in bill["packages"]:
    expect(package["SPDXID"] not in linked or package["licenseDeclared"] != "NOASSERTION",
           f"{package['name']} is linked, and tests/tools/sbom does not know its licence")
related = {relation[end] for relation in bill["relationships"] for end in ("spdxElementId", "relatedSpdxElement")}
expect(set(identifiers) == related, f"related to nothing: {set(identifiers) - related}")

# The contents.
versions = {package["name"]: package["versionInfo"] for package in bill["packages"]}
libraries = re.findall(r"(/\S+) \(0x", subprocess.run(["ldd", str(folder / "fixproof")], capture_output=True, text=True,
                                                      check=True).stdout)
expect(len(libraries) > 5, f"ldd finds only {libraries}")
for library, owner in owners(libraries).items():
    expect(owner in versions, f"ldd finds {library}, of {owner}: not listed")
cache = (folder / "CMakeCache.txt").read_text()
asked = re.findall(r"^find_package\((\w+)", (root / "CMakeLists.txt").read_text(), re.M)
expect(len(asked) > 8, f"CMakeLists.txt asks only for {asked}")
for name in sorted(set(asked) - {"Threads"}):  # of the C library, which ldd finds
    found = re.findall(rf"^{name}_(?:DIR|LIBRARY\w*|CRYPTO_LIBRARY):\w+=(/.+)$", cache, re.M | re.IGNORECASE)
    files = [str(path) for entry in found
             for path in ([entry] if os.path.isfile(entry) else Path(entry).glob("*onfig.cmake"))]
    if name == "SDL2" and not files:
        continue  # optional
    packages = set(owners(files).values())
    expect(packages and packages <= set(versions), f"CMake finds {name} in {packages or 'nothing'}: not listed")
for line in (root / "app/report/vendor/SHA256SUMS").read_text().splitlines():
    value, name = line.split()
    expect(any(file["fileName"] == f"./app/report/vendor/{name}" and file["checksums"][1]["checksumValue"] == value
               for file in bill["files"]), f"app/report/vendor/{name}: not listed")
installed = set(subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}\n"], capture_output=True, text=True,
                               check=True).stdout.splitlines())
for package in bill["packages"]:
    if package["name"] != "fixproof" and not package["SPDXID"].startswith("SPDXRef-Package-npm-"):
        what = f"{package['name']} {package['versionInfo']}"
        expect(what in installed, f"{what}: not installed")

print("\n".join(breaches) or f"{len(bill['packages'])} packages, {len(libraries)} libraries of ldd: all listed")
sys.exit(1 if breaches else 0)
