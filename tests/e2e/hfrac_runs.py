"""What the end-to-end tests share: starting the program and reading what it left."""
import csv
import json
import os
import pathlib
import re
import subprocess

COMMAND = os.environ["HFRAC_COMMAND"]
CASE = os.environ["HFRAC_CASE"]
READER = os.environ["HFRAC_READER"]
TINY_CASE = """[packing]
disc_count = 300
[solver]
kind = "quasi-static"
[[well]]
radius = 8.0
pressure = 30e6
"""
SERIES = ("discs", "bonds", "cracks", "flow", "fractures")


def hfrac(*arguments, **options):
    """Runs the program to its end; gives exit code and texts."""
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=600, **options)


def run_case(folder, *arguments, **options):
    return hfrac("run", CASE, "-o", folder, *arguments, **options)


def entries(folder, series):
    """(time, file) of each entry in a PVD list."""
    text = (pathlib.Path(folder) / f"{series}.pvd").read_text()
    return [(float(time), file) for time, file in re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', text)]


def history(folder):
    with open(pathlib.Path(folder) / "history.csv", newline="") as file:
        return list(csv.DictReader(file))


def summary(folder):
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())


def names(folder):
    return sorted(path.name for path in pathlib.Path(folder).iterdir())


def reader_verdict(folder):
    """Lets VTK read every file that the lists name; gives exit code and text."""
    environment = dict(os.environ, HFRAC_RUN_FOLDER=str(folder))
    done = subprocess.run([READER, "--gtest_brief=1"], capture_output=True, text=True, timeout=600, env=environment)
    return done.returncode, done.stdout + done.stderr


def check_whole(test, folder):
    """What holds in a run folder at any moment: no half file, no list that names what is not there."""
    left = [name for name in names(folder) if name.startswith(".")]
    test.assertEqual(left, [], "files left half-written")
    for series in SERIES:
        for _, file in entries(folder, series):
            test.assertTrue((pathlib.Path(folder) / file).is_file(), file)
    code, text = reader_verdict(folder)
    test.assertEqual(code, 0, text)
