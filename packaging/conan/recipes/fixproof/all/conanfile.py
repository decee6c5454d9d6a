import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, get
from conan.tools.layout import basic_layout

required_conan_version = ">=2.0"


class FixproofConan(ConanFile):
    name = "fixproof"
    description = "16.16 and 8.8 fixed-point numbers, header-only C++20, verified bit for bit"
    license = "MIT"
    url = "https://github.com/conan-io/conan-center-index"
    homepage = "https://example.org/fixproof"
    topics = ("fixed-point", "arithmetic", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def layout(self):
        basic_layout(self, src_folder="src")

    def package_id(self):
        self.info.clear()

    def validate(self):
        check_min_cppstd(self, 20)

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.hpp", os.path.join(self.source_folder, "fixed"),
             os.path.join(self.package_folder, "include", "fixed"))

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "fixproof")
        self.cpp_info.set_property("cmake_target_name", "fixproof::fixed")
        self.cpp_info.set_property("pkg_config_name", "fixproof")
