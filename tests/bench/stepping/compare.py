#!/usr/bin/python3
"""What stepping through Fortran and Python costs beside C: the same case, step by step, in turns; the median counts.

usage: compare.py BUILD_FOLDER CASE [STEPS [TURNS]]     prints a table; processor time, since machines are busy
"""
import os
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


def main():
    build, case = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    steps = sys.argv[3] if len(sys.argv) > 3 else "40"
    turns = int(sys.argv[4]) if len(sys.argv) > 4 else 7
    environment = os.environ | {
        "HFRAC_LIBRARY": str(build / "lib/libhfrac.so"),
        "PYTHONPATH": str(ROOT / "bindings/python"),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    commands = {"C": [build / "bin/bench_step_c"], "Python": [sys.executable, HERE / "step.py"]}
    if (build / "bin/bench_step_fortran").exists():
        commands["Fortran"] = [build / "bin/bench_step_fortran"]
    seconds = {language: [] for language in commands}
    for _ in range(turns):
        for language, command in commands.items():
            out = subprocess.run([*command, case, steps], env=environment, check=True, capture_output=True, text=True).stdout
            seconds[language].append(float(out))
    base = statistics.median(seconds["C"])
    print(f"{'':8} {'median s':>9} {'fastest s':>9} {'against C':>9}")
    for language, taken in seconds.items():
        middle = statistics.median(taken)
        print(f"{language:8} {middle:9.4f} {min(taken):9.4f} {100.0 * (middle / base - 1.0):+8.2f} %")


main()
