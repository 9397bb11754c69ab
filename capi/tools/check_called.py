#!/usr/bin/python3
"""Every exported function is called by the tests of the C interface, from C++ and from C.

usage: check_called.py FOLDER [--library hfrac_viz]     FOLDER: where the tests are
"""
import pathlib
import re
import sys

from c_header import library_of

# Comments and texts, so that a name in them does not count.
NOT_CODE = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', re.S)


def called(path):
    return set(re.findall(r"\b(hfrac_\w+)\s*\(", NOT_CODE.sub(" ", path.read_text())))


def main():
    arguments = sys.argv[1:]
    listed = set((library_of(arguments).abi / "symbols.txt").read_text().split())
    folder = pathlib.Path(arguments[0])
    by_language = {"C++": {".cpp", ".hpp", ".h"}, "C": {".c"}}
    problems = []
    for language, endings in by_language.items():
        files = [path for path in folder.iterdir() if path.suffix in endings]
        found = set().union(*map(called, files))
        problems += [f"{name}: not called in {language}" for name in sorted(listed - found)]
    sys.exit("\n".join(problems) or 0)


main()
