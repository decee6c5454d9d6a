#!/usr/bin/env python3
"""usage: recipes.py ROOT

Fills app/packages/recipes as a release does, with a small archive in place of its source, and holds each to the form that
its tool documents: JSON and YAML parse and have the keys that they must, the version is that of fixed/version.hpp, digests are
of the archive, Python and shell parse, and no recipe is without a row in docs/packages.md. Status 1 for any breach.
"""
import ast
import hashlib
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not installed")
    sys.exit(77)

root = Path(sys.argv[1]).resolve()
breaches = []


def expect(holds, what):
    if not holds:
        breaches.append(what)


with tempfile.TemporaryDirectory() as temporary:
    archive, folder = Path(temporary) / "source.tar.gz", Path(temporary) / "recipes"
    archive.write_bytes(b"a stand-in")
    subprocess.run([root / "app/packages/recipes/fill", root, archive, folder], check=True)
    texts = {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*")
             if path.is_file() and "/src/fixed/" not in path.as_posix()}
    headers = {path.relative_to(folder / "embedded/src").as_posix() for path in folder.rglob("*.hpp")}

version = ".".join(re.findall(r"^#define FIXED_VERSION_\w+ (\d+)", (root / "fixed/version.hpp").read_text(), re.M))
sha256, sha512 = hashlib.sha256(b"a stand-in").hexdigest(), hashlib.sha512(b"a stand-in").hexdigest()
for name, text in texts.items():
    expect("@" not in re.sub(r"openssl@3|\w@\w", "", text), f"{name}: a place is not filled")

port = json.loads(texts["vcpkg/vcpkg.json"])
# https://learn.microsoft.com/vcpkg/reference/vcpkg-json
expect(re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", port["name"]) and port["version"] == version, "vcpkg.json: name or version")
expect({"name", "version", "description", "homepage", "license", "dependencies"} == set(port), "vcpkg.json: keys")
expect(sha512 in texts["vcpkg/portfile.cmake"], "portfile.cmake: SHA512")

module = ast.parse(texts["conan/conanfile.py"])
values = {target.id: ast.literal_eval(node.value) for node in ast.walk(module)
          if isinstance(node, ast.Assign) and isinstance(node.value, (ast.Constant, ast.Tuple))
          for target in node.targets if isinstance(target, ast.Name)}
expect(values["name"] == "fixproof" and values["version"] == version and values["license"] == "MIT", "conanfile.py")
for name in ("conan/conanfile.py", "meson/fixproof.wrap", "homebrew/fixproof.rb", "nix/flake.nix"):
    expect(sha256 in texts[name], f"{name}: SHA-256")
expect(f"version: '{version}'" in texts["meson/meson.build"], "meson.build: version")

# https://arduino.github.io/arduino-cli/latest/library-specification
properties = dict(line.split("=", 1) for line in texts["embedded/library.properties"].splitlines())
expect(set(properties) >= {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"},
       "library.properties: keys")
expect(properties["version"] == version and properties["category"] == "Data Processing", "library.properties: version or category")
expect(f"src/{properties['includes']}" in {name.removeprefix("embedded/") for name in texts}, "library.properties: includes")

# https://docs.platformio.org/en/latest/manifests/library-json
library = json.loads(texts["embedded/library.json"])
expect(re.fullmatch(r"[\w .+-]+", library["name"]) and library["version"] == version, "library.json: name or version")
expect(set(library) <= {"name", "version", "description", "keywords", "authors", "homepage", "repository", "license", "headers",
                        "frameworks", "platforms", "dependencies", "examples", "export", "scripts", "build"}, "library.json: keys")
expect(set(library["build"]) <= {"flags", "unflags", "includeDir", "srcDir", "srcFilter", "extraScript", "libArchive",
                                 "libLDFMode", "libCompatMode", "builder"}, "library.json: build")
expect(all(author["name"] for author in library["authors"]) and isinstance(library["keywords"], list), "library.json: authors")

component = yaml.safe_load(texts["embedded/idf_component.yml"])
expect(component["version"] == version and "idf" in component["dependencies"], "idf_component.yml")

tree = {path.relative_to(root).as_posix() for path in root.glob("fixed/**/*.hpp")}
expect(headers == tree, f"embedded/src has other headers than fixed/: {sorted(headers ^ tree)[:5]}")
page = (root / "docs/packages.md").read_text()
for name in texts:
    if name != "embedded/LICENSE":
        expect(f"{name.split('/')[0]}/" in page, f"docs/packages.md: no row for {name}")

print("\n".join(breaches) or f"{len(texts)} files of recipes")
sys.exit(1 if breaches else 0)
