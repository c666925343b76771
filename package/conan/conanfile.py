# SPDX-License-Identifier: MIT
"""UNTESTED: no Conan was at hand. Recipe for Conan 2 of the engine alone: conan create package/conan --version 0.1.0"""
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Sinew(ConanFile):
    name = "sinew"
    license = "MIT"
    description = "Skin weights, skeletons and motion for character meshes, by a dependency-free fixed-point engine"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def export_sources(self):
        root = Path(self.recipe_folder).parents[1]
        for pattern in ("engine/*", "LICENSE", "samples/data/sinew_default.*", "samples/data/sinew_rig.*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self, src_folder=".")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_SHARED_LIBS"] = bool(self.options.shared)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder="engine")
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, str(Path(self.package_folder) / "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["sinew"]
        self.cpp_info.set_property("cmake_file_name", "sinew")
        self.cpp_info.set_property("cmake_target_name", "sinew::engine")
        if self.options.shared:
            self.cpp_info.defines = ["SINEW_SHARED"]
