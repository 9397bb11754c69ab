# SPDX-License-Identifier: BSD-3-Clause
# Spack: the engine, its C, Fortran and BMI interfaces and the Python package, without the renderer. In a checkout:
#   spack repo add cmake/packaging/spack && spack dev-build hfrac@0.2.0
from spack.package import *


class Hfrac(CMakePackage):
    """Hydraulic fracturing of rock in two dimensions with a bonded-particle model, behind a plain C interface."""

    license("BSD-3-Clause")

    version("0.2.0")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("fortran", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.3:", type="build")
    depends_on("tomlplusplus@3:", type="build")
    depends_on("nlohmann-json@3:", type="build")
    depends_on("python@3.8:", type=("build", "run"))
    depends_on("py-numpy", type="run")

    extends("python")
    generator("ninja")
    conflicts("%gcc@:10", msg="hfrac is C++20")

    def cmake_args(self):
        return [
            self.define("HFRAC_VIZ", False),
            self.define("HFRAC_TESTS", False),
            self.define("HFRAC_BENCH", False),
            self.define("HFRAC_WERROR", False),
            self.define("HFRAC_PYTHON_DIR", python_purelib),
        ]
