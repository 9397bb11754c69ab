#!/usr/bin/python3
"""Compiles each public header alone, as C99 and as C++11, with every warning an error.

usage: check_headers.py CC CXX
"""
import subprocess
import sys

from c_header import INCLUDE, LIBRARIES, VIZ_INCLUDE

STRICT = ["-Wall", "-Wextra", "-pedantic", "-pedantic-errors", "-Wshadow", "-Werror", "-fsyntax-only", f"-I{INCLUDE}", f"-I{VIZ_INCLUDE}"]


def main():
    cc, cxx = sys.argv[1:]
    failed = 0
    for header in [header for library in LIBRARIES.values() for header in library.headers]:
        line = f"#include <hfrac/{header.name}>\n"
        for command in ([cc, "-std=c99", "-Wstrict-prototypes", "-xc"], [cxx, "-std=c++11", "-xc++"]):
            failed |= subprocess.run([*command, *STRICT, "-"], input=line, text=True, check=False).returncode
    sys.exit(failed)


main()
