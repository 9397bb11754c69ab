#!/usr/bin/python3
"""Fortran's and Python's types have the sizes and offsets of capi/abi/layout.txt.

usage: check_binding_layout.py [FORTRAN_PROGRAM]     a program as generate_bindings.py --layout writes it
"""
import ctypes
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings/python"))
from hfrac import _abi  # noqa: E402


def parsed(text):
    """{struct: lines} in any order of structs."""
    structs = {}
    for line in text.splitlines():
        if not line.startswith(" "):
            name = line.split()[0]
            structs[name] = []
        structs[name].append(line.split())
    return structs


def of_python():
    lines = []
    for name, kind in vars(_abi).items():
        if isinstance(kind, type) and issubclass(kind, ctypes.Structure):
            lines.append(f"{name} {ctypes.sizeof(kind)}")
            for member, _ in kind._fields_:
                lines.append(f"  {member} {getattr(kind, member).offset} {getattr(kind, member).size}")
    return "\n".join(lines)


def differences(language, found, wanted):
    if found.keys() != wanted.keys():
        return [f"{language}: structs {sorted(found.keys() ^ wanted.keys())} are not in both"]
    pairs = ((w, f) for name in wanted for w, f in zip(wanted[name] + [None], found[name] + [None]))
    return [f"{language}: {f} instead of {w}" for w, f in pairs if w != f]


wanted = parsed((ROOT / "capi/abi/layout.txt").read_text())
problems = differences("Python", parsed(of_python()), wanted)
if len(sys.argv) > 1:
    out = subprocess.run(sys.argv[1:], check=True, capture_output=True, text=True).stdout
    problems += differences("Fortran", parsed(out), wanted)
sys.exit("\n".join(problems) or 0)
