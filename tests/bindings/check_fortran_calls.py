#!/usr/bin/python3
"""Every function of the C interface is called from Fortran: runs a program and asks the loader which ones it bound.

usage: check_fortran_calls.py PROGRAM ARGUMENT...     PROGRAM must be linked with lazy binding
"""
import os
import pathlib
import re
import subprocess
import sys

SYMBOLS = pathlib.Path(__file__).resolve().parents[2] / "capi/abi/symbols.txt"

environment = {name: value for name, value in os.environ.items() if name != "LD_BIND_NOW"} | {"LD_DEBUG": "bindings"}
run = subprocess.run(sys.argv[1:], env=environment, capture_output=True, text=True, errors="replace", check=False)
program = re.escape(sys.argv[1])
called = set(re.findall(rf"binding file {program} .*libhfrac\.so.*symbol `(hfrac_\w+)'", run.stderr))
if run.returncode != 0:
    sys.exit("\n".join([f"status {run.returncode}", *re.findall(r"^failed.*", run.stderr, re.M)]))
missing = sorted(set(SYMBOLS.read_text().split()) - called)
sys.exit("\n".join(f"{name} is not called from Fortran" for name in missing) or 0)
