#!/usr/bin/python3
"""Two programs print the same.

usage: compare_output.py PROGRAM PROGRAM ARGUMENT...
"""
import subprocess
import sys

first, second = (
    subprocess.run([program, *sys.argv[3:]], check=True, capture_output=True, text=True).stdout.splitlines()
    for program in sys.argv[1:3]
)
different = [f"{a!r} and {b!r}" for a, b in zip(first, second) if a != b]
if len(first) != len(second) or len(first) < 10:
    different.append(f"{len(first)} and {len(second)} lines")
sys.exit("\n".join(different) or 0)
