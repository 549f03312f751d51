"""Conan 2: conan create packaging/conan, from the source tree that it is in."""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir
from conan.tools.gnu import PkgConfigDeps


class ClersConan(ConanFile):
    name = "clers"
    version = "0.1.0"
    description = "Compression of meshes, without loss unless less is asked for"
    license = "MIT"
    topics = ("mesh", "compression", "geometry", "gltf")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "gltf": [True, False]}
    default_options = {"shared": False, "fPIC": True, "gltf": True}
    implements = ["auto_shared_fpic"]

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "cmake/*", "topology/*", "codec/*", "bindings/*",
                        "packaging/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("zstd/[>=1.5 <1.6]")
        self.requires("xxhash/[>=0.8 <0.9]")
        if self.options.gltf:
            self.requires("rapidjson/cci.20230929")

    def build_requirements(self):
        self.tool_requires("pkgconf/[>=2.1 <3]")

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["CLERS_GLTF"] = bool(self.options.gltf)
        for off in ("CLERS_CLI", "CLERS_DRACO", "CLERS_MESHOPT"):
            toolchain.cache_variables[off] = False
        toolchain.cache_variables["CLERS_INSTALL"] = True
        toolchain.generate()
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for made_anew in ("cmake", "pkgconfig"):
            rmdir(self, os.path.join(self.package_folder, "lib", made_anew))
        rmdir(self, os.path.join(self.package_folder, "share"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "clers")
        needs = {
            "topology": [],
            "modeling": ["topology"],
            "codec": ["topology", "zstd::zstd", "xxhash::xxhash"],
            "io": ["codec"],
            "c": ["codec"],
        }
        if self.options.gltf:
            needs["gltf"] = ["codec", "rapidjson::rapidjson"]
        for name, requires in needs.items():
            component = self.cpp_info.components[name]
            component.libs = ["clers_" + name]
            component.requires = requires
            component.set_property("cmake_target_name", "clers::" + name)
            if self.settings.os in ("Linux", "FreeBSD"):
                component.system_libs = ["m", "pthread"]
        self.cpp_info.components["codec"].set_property("pkg_config_name", "clers")
        self.cpp_info.components["c"].set_property("pkg_config_name", "clers-c")
        if not self.options.shared:
            self.cpp_info.components["c"].defines = ["CLERS_C_STATIC"]
