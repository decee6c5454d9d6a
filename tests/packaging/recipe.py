"""usage: recipe.py TREE

Runs the Conan recipe against this tree, with the modules of Conan replaced by small ones that do what
their manual says, and builds the recipe's test package from what was packaged.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types

sys.dont_write_bytecode = True
root = pathlib.Path(sys.argv[1]).resolve()
recipe_dir = root / "packaging/conan/recipes/fixproof"
work = pathlib.Path(tempfile.mkdtemp())
calls = []


class ConanFile:
    """What a recipe finds in its base class."""

    def __init__(self, **attributes):
        self.cpp_info = types.SimpleNamespace(
            includedirs=["include"], properties={},
            set_property=lambda name, value: self.cpp_info.properties.update({name: value}))
        self.info = types.SimpleNamespace(clear=lambda: calls.append("info.clear"))
        self.cpp = types.SimpleNamespace(build=types.SimpleNamespace(bindir=str(work / "build")))
        self.required = []
        self.requires = self.required.append
        self.__dict__.update(attributes)

    def run(self, command, env):
        assert env == "conanrun"
        subprocess.run(command, check=True)


class CMake:
    def __init__(self, conanfile):
        assert {"CMakeDeps", "CMakeToolchain"} <= set(conanfile.generators)

    def configure(self):
        subprocess.run(["cmake", "-S", recipe_dir / "all/test_package", "-B", work / "build",
                        f"-DCMAKE_PREFIX_PATH={work / 'deps'}"], check=True)

    def build(self):
        subprocess.run(["cmake", "--build", work / "build"], check=True)


def copy(_, pattern, src, dst):
    copied = 0
    for file in pathlib.Path(src).rglob(pattern):
        target = pathlib.Path(dst) / file.relative_to(src)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, target)
        copied += 1
    assert copied, f"nothing to copy: {pattern} in {src}"


def get(_, url, sha256, strip_root):
    assert version in url and re.fullmatch("[0-9a-f]{64}", sha256) and strip_root
    calls.append("get")


def module(name, **members):
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(members)


module("conan", ConanFile=ConanFile)
module("conan.tools")
module("conan.tools.build", can_run=lambda _: True,
       check_min_cppstd=lambda _, least: calls.append(f"cppstd {least}"))
module("conan.tools.cmake", CMake=CMake, cmake_layout=lambda _: None)
module("conan.tools.files", copy=copy, get=get)
module("conan.tools.layout", basic_layout=lambda _, src_folder: calls.append("layout"))


def load(path):
    members = {}
    exec(compile(path.read_text(), path, "exec"), members)
    return next(m for m in members.values()
                if isinstance(m, type) and issubclass(m, ConanFile) and m is not ConanFile)


try:
    parts = re.findall(r"#define FIXED_VERSION_\w+ (\d+)", (root / "fixed/version.hpp").read_text())
    version = ".".join(parts)
    config = (recipe_dir / "config.yml").read_text()
    assert config == f'versions:\n  "{version}":\n    folder: all\n', config
    data = re.fullmatch(r'sources:\n  "(.*)":\n    url: "(.*)"\n    sha256: "(.*)"\n',
                        (recipe_dir / "all/conandata.yml").read_text())
    assert data and data[1] == version, "conandata.yml"

    package = work / "package"
    recipe = load(recipe_dir / "all/conanfile.py")(
        version=version, source_folder=str(root), package_folder=str(package),
        conan_data={"sources": {version: {"url": data[2], "sha256": data[3]}}})
    for attribute in ("name", "description", "license", "url", "homepage", "topics", "settings"):
        assert getattr(recipe, attribute), attribute
    assert recipe.package_type == "header-library"
    for step in ("layout", "package_id", "validate", "source", "package", "package_info"):
        getattr(recipe, step)()
    assert calls == ["layout", "info.clear", "cppstd 20", "get"], calls
    assert (package / "licenses/LICENSE").is_file()
    headers = sorted(p.relative_to(root) for p in (root / "fixed").rglob("*.hpp"))
    assert headers == sorted(p.relative_to(package / "include") for p in package.rglob("*.hpp"))
    info = recipe.cpp_info
    assert info.bindirs == [] and info.libdirs == []

    # What CMakeDeps would write.
    name = info.properties["cmake_file_name"]
    (work / "deps").mkdir()
    (work / "deps" / f"{name}-config.cmake").write_text(
        f"add_library({info.properties['cmake_target_name']} INTERFACE IMPORTED)\n"
        f"target_include_directories({info.properties['cmake_target_name']} INTERFACE "
        f"{package / info.includedirs[0]})\n")
    test = load(recipe_dir / "all/test_package/conanfile.py")(
        tested_reference_str=f"{recipe.name}/{version}")
    for step in ("requirements", "layout", "build", "test"):
        getattr(test, step)()
    assert test.required == [f"fixproof/{version}"], test.required
finally:
    shutil.rmtree(work)
print(f"recipe: {len(headers)} headers packaged, test package runs")
