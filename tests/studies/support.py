"""What the tests of studies share: a tiny case, a study of it, and the command."""
import os
import pathlib
import subprocess
import sys

try:
    import numpy  # noqa: F401
    import scipy  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

COMMAND = os.environ["HFRAC_COMMAND"]
ROOT = pathlib.Path(__file__).resolve().parents[2]

# 300 discs, a fifth of a second.
CASE = """
[packing]
disc_count = 300
residual = 1e-3
[contact]
mode = "after-break"
[stress]
convention = "effective"
sigma_Hmax = 0.0
sigma_hmin = 0.0
[boundary]
kind = "walls"
[solver]
kind = "quasi-static"
[stepping]
mode = "coupled"
flow_step = 0.1
steps = 4
[output]
every = 2
[[well]]
radius = 9.0
pressure = 20e6
"""
STUDY = """
case = "case.toml"
runs = {runs}
sampling = "{sampling}"
[[parameter]]
option = "bond.tensile_strength"
law = "uniform"
low = 40e6
high = 60e6
[[parameter]]
name = "pressure"
option = "well.pressure"
law = "loguniform"
low = 10e6
high = 30e6
"""


def write_study(folder, runs=6, sampling="sobol", more=""):
    folder = pathlib.Path(folder)
    (folder / "case.toml").write_text(CASE)
    (folder / "study.toml").write_text(more.partition("|")[0] + STUDY.format(runs=runs, sampling=sampling) + more.partition("|")[2])
    return folder / "study.toml"


def hfrac(*words, limit=500, **options):
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, timeout=limit, **options)
