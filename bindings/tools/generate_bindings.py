#!/usr/bin/python3
"""Writes the low-level bindings from the C headers; their outputs are committed.

usage: generate_bindings.py             write them
       generate_bindings.py --check     exit 1 if one differs from what would be written
       generate_bindings.py --layout F  write the Fortran program that prints the layout of all types into file F
"""
import pathlib
import sys

from c_subset import ROOT, NotInSubset, read_headers
from write_fortran import FortranWriter, NameClash
from write_fortran_calls import FortranCalls
from write_python import PythonWriter


def outputs(header):
    python = PythonWriter(header)
    package = ROOT / "bindings/python/hfrac"
    return {
        ROOT / "bindings/fortran/hfrac_c.f90": FortranWriter(header).module(),
        ROOT / "bindings/fortran/hfrac_calls.f90": FortranCalls(header).module(),
        package / "_abi.py": python.abi(),
        package / "_records.py": python.records(),
        package / "_fields.py": python.fields(),
    }


def main(arguments):
    header = read_headers()
    if arguments[:1] == ["--layout"]:
        pathlib.Path(arguments[1]).write_text(FortranWriter(header).layout_program())
        return 0
    files = outputs(header)
    if arguments == ["--check"]:
        same = {path: path.exists() and path.read_text() == text for path, text in files.items()}
        stale = [str(path.relative_to(ROOT)) for path in files if not same[path]]
        return "\n".join(f"{name} differs from the headers: run bindings/tools/generate_bindings.py" for name in stale) or 0
    if arguments:
        return __doc__
    for path, text in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return 0


try:
    sys.exit(main(sys.argv[1:]))
except (NotInSubset, NameClash) as refusal:
    sys.exit(str(refusal))
