#!/usr/bin/python3
"""Takes the programs out of a page, builds each as its reader would, runs it, and looks whether it found a fracture.

usage: run_page.py PAGE LIBRARY CC CXX [FC]     without FC, Fortran is left out
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, LIBRARY, CC, CXX = sys.argv[1:5]
FC = sys.argv[5] if len(sys.argv) > 5 else None
FORTRAN = [ROOT / "bindings/fortran" / name for name in ("hfrac_c.f90", "hfrac_text.f90", "hfrac_calls.f90", "hfrac_definition.f90", "hfrac.f90")]
STRICT = ["-Wall", "-Wextra", "-Werror"]


def main():
    page = pathlib.Path(PAGE).read_text()
    found = dict(re.findall(r"^```(c|cpp|fortran|python)\n(.*?)^```$", page, re.S | re.M))
    if set(found) != {"c", "cpp", "fortran", "python"}:
        sys.exit(f"the page shows programs in {sorted(found)} only")
    link = [LIBRARY, f"-Wl,-rpath,{pathlib.Path(LIBRARY).parent}"]
    include = f"-I{ROOT}/capi/include"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        build = {
            "c": [CC, "-std=c99", *STRICT, include, "first.c", *link, "-o", "c"],
            "cpp": [CXX, "-std=c++17", *STRICT, include, "first.cpp", *link, "-o", "cpp"],
            "fortran": [FC, *FORTRAN, "first.f90", *link, "-o", "fortran"] if FC else None,
            "python": ["true"],
        }
        endings = {"c": "c", "cpp": "cpp", "fortran": "f90", "python": "py"}
        environment = os.environ | {"HFRAC_LIBRARY": LIBRARY, "PYTHONPATH": str(ROOT / "bindings/python"), "PYTHONDONTWRITEBYTECODE": "1"}
        for language, program in found.items():
            if build[language] is None:
                continue
            (folder / f"first.{endings[language]}").write_text(program)
            subprocess.run(build[language], cwd=folder, check=True)
            run = [sys.executable, "first.py"] if language == "python" else [folder / language]
            said = subprocess.run(run, cwd=folder, env=environment, check=True, capture_output=True, text=True).stdout
            print(f"{language}: {' '.join(said.split())}")
            if not re.search(r"[1-9]\d* fractures.*the largest [\d.]+ m long", said, re.S):
                sys.exit(f"{language} found no fracture")


main()
