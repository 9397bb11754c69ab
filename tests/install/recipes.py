#!/usr/bin/python3
"""Recipes of cmake/packaging as far as they can be judged without their tools: syntax, the project's version, and the programs they call.

usage: recipes.py
"""
import ast
import pathlib
import re
import subprocess
import sys

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "cmake/packaging"
CMAKE = (ROOT / "CMakeLists.txt").read_text()
VERSION = re.search(r"project\(hfrac VERSION ([\d.]+)", CMAKE)[1]
OPTIONS = "\n".join(path.read_text() for path in [ROOT / "CMakeLists.txt", *(ROOT / "bindings").rglob("CMakeLists.txt")])


def main():
    faults = []
    spack = (PACKAGING / "spack/packages/hfrac/package.py").read_text()
    ast.parse(spack)
    conda = yaml.safe_load((PACKAGING / "conda/recipe.yaml").read_text())
    yaml.safe_load((PACKAGING / "spack/repo.yaml").read_text())
    container = (PACKAGING / "Containerfile").read_text()
    for name, version in (("spack", re.search(r'version\("([\d.]+)"', spack)[1]), ("conda", conda["context"]["version"])):
        if version != VERSION:
            faults.append(f"{name}: version {version}, the project's is {VERSION}")
    # Wherever else the project's version stands.
    header = (ROOT / "capi/include/hfrac/base.h").read_text()
    numbers = [re.search(rf"HFRAC_VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR", "PATCH")]
    short = VERSION.rsplit(".", 1)[0]
    for name, found in (
        ("base.h", ".".join(numbers)),
        ("CITATION.cff", yaml.safe_load((ROOT / "CITATION.cff").read_text())["version"]),
        ("manual page", re.search(r'^\.TH HFRAC 1 "" "hfrac ([\d.]+)"', (ROOT / "viz/command/manual/hfrac.1").read_text(), re.M)[1]),
        ("packaging/README.md", re.search(r"hfrac@([\d.]+)", (PACKAGING / "README.md").read_text())[1]),
        ("CHANGELOG.md", re.search(r"^## ([\d.]+)", (ROOT / "CHANGELOG.md").read_text(), re.M)[1] + VERSION[len(short):]),
        ("README.md", re.search(r"^Version ([\d.]+);", (ROOT / "README.md").read_text(), re.M)[1] + VERSION[len(short):]),
    ):
        if found != VERSION:
            faults.append(f"{name}: version {found}, the project's is {VERSION}")
    # What the engine looks for stands in each list: as found by find_package and find_path.
    wanted = {"eigen", "tomlplusplus"}
    for name, listed in (("spack", re.findall(r'depends_on\("([\w-]+)', spack)), ("conda", [one.split(" ")[0] for one in conda["requirements"]["host"]])):
        missing = (wanted | {"nlohmann-json"}) - {one.replace("_", "-") for one in listed}
        if missing:
            faults.append(f"{name}: no {', '.join(sorted(missing))}")
    # Options of CMake that are given exist.
    for name, text in (("spack", spack), ("conda", (PACKAGING / "conda/build.sh").read_text()), ("container", container)):
        given = set(re.findall(r"(?:-D|\")(HFRAC_[A-Z_]+)\b", text))
        unknown = [one for one in sorted(given) if not re.search(rf"(option|set)\({one}\b", OPTIONS)]
        if not given or unknown:
            faults.append(f"{name}: options {unknown or 'none'}")
    for line in re.findall(r"^RUN (.*)$", container, re.M):
        done = subprocess.run(["sh", "-n", "-c", line], capture_output=True, text=True)
        if done.returncode:
            faults.append(f"container: {done.stderr}")
        faults += [f"container: no {program}" for program in re.findall(r"\bcmake/[\w-]+", line) if not (ROOT / program).is_file()]
    return "\n".join(faults) or 0


sys.exit(main())
