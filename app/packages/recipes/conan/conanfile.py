"""The type alone, for Conan 2: no part of it is compiled."""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, get


class Fixproof(ConanFile):
    name = "fixproof"
    version = "@VERSION@"
    description = "Fixed-point numbers of 8 to 64 bits, header-only C++20, verified bit for bit"
    license = "MIT"
    homepage = "https://example.org/fixproof"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def validate(self):
        check_min_cppstd(self, 20)

    def source(self):
        get(self, "https://example.org/fixproof/releases/download/v@VERSION@/fixproof-@VERSION@-source.tar.gz",
            sha256="@SHA256@", strip_root=True)

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.hpp", os.path.join(self.source_folder, "fixed"),
             os.path.join(self.package_folder, "include", "fixproof", "fixed"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.includedirs = [os.path.join("include", "fixproof")]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_target_name", "fixproof::fixed")
        self.cpp_info.set_property("pkg_config_name", "fixproof")
