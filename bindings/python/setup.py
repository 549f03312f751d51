"""Builds the wheel. CMake compiles the module, in $CLERS_BUILD if that is set (a build directory of this project)."""

import os
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
    VERSION = re.search(r"project\(clers VERSION ([0-9.]+)", file.read()).group(1)


class BuildByCMake(build_ext):
    def build_extension(self, ext):
        build = os.path.abspath(os.environ.get("CLERS_BUILD") or os.path.join(ROOT, "build", "python"))
        configure = ["cmake", "-S", ROOT, "-B", build, "-DCLERS_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}"]
        if not os.path.exists(os.path.join(build, "CMakeCache.txt")):
            configure += ["--preset", "python"]
        subprocess.check_call(configure, cwd=ROOT)
        subprocess.check_call(["cmake", "--build", build, "--target", "clers_python", "--parallel"])
        target = self.get_ext_fullpath(ext.name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        made = os.path.join(build, "bindings", "python", "clers", os.path.basename(target))
        self.copy_file(made, target)


setup(name="clers", version=VERSION, description="Mesh compression: any faces, all attributes, without loss",
      python_requires=">=3.9", install_requires=["numpy"], extras_require={"distributed": ["dask", "distributed"]},
      package_dir={"": "src"}, packages=["clers", "clers.distributed"],
      package_data={"clers": ["py.typed", "*.pyi"]},
      ext_modules=[Extension("clers._clers", [])], cmdclass={"build_ext": BuildByCMake})
