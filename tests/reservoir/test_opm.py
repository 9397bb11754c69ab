"""The OPM Flow example: runs it, and solves what its decks say once more with a solver of its own.

The rates that the summary gives at the end, when flow is steady, must be those of a two-point finite-volume solve with
Peaceman's wells on the very include files: so Flow read the cells in the order and units they were written in, and the
summary was read rightly. Ends with 77 if OPM Flow is not there.

usage: test_opm.py FOLDER
"""
import math
import pathlib
import re
import subprocess
import sys

import numpy

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples/reservoir/opm"
sys.path.insert(0, str(EXAMPLE))

from eclipse_summary import read_summary  # noqa: E402

MILLIDARCY, VISCOSITY, THICKNESS, RADIUS = 9.869233e-16, 1e-3, 10.0, 0.1
INJECTION, PRODUCTION = 300e5, 250e5  # Pa


def read_include(path):
    """{"PERMX": [...], ...}"""
    text = re.sub(r"--.*", "", path.read_text())
    found = {}
    for keyword, body in re.findall(r"([A-Z]+)\s([^/]*)/", text):
        values = []
        for word in body.split():
            repeat, _, value = word.rpartition("*")
            values += [float(value)] * int(repeat or 1)
        found[keyword] = values
    return found


def steady_rate(rock, n):
    """Rate of the injector [m3/day]: square cells, harmonic means between them, Peaceman (1983) in an anisotropic cell."""
    kx, ky = (numpy.array(rock[name]).reshape(n, n) * MILLIDARCY for name in ("PERMX", "PERMY"))
    more_x, more_y = (numpy.array(rock.get(name, [1.0] * n * n)).reshape(n, n) for name in ("MULTX", "MULTY"))
    matrix, right = numpy.zeros((n * n, n * n)), numpy.zeros(n * n)

    def join(a, b, k, other, more):
        t = more * THICKNESS / VISCOSITY * 2 / (1 / k + 1 / other)
        matrix[a, a] += t
        matrix[b, b] += t
        matrix[a, b] -= t
        matrix[b, a] -= t

    for j in range(n):
        for i in range(n):
            c = i + n * j
            if i + 1 < n:
                join(c, c + 1, kx[j, i], kx[j, i + 1], more_x[j, i])
            if j + 1 < n:
                join(c, c + n, ky[j, i], ky[j + 1, i], more_y[j, i])
    middle = n // 2
    wells = [(middle, middle, INJECTION)] + [(i, j, PRODUCTION) for i in (0, n - 1) for j in (0, n - 1)]
    for i, j, pressure in wells:
        x, y, size = kx[j, i], ky[j, i], 20.0
        equivalent = 0.28 * size * math.hypot((y / x) ** 0.25, (x / y) ** 0.25) / ((y / x) ** 0.25 + (x / y) ** 0.25)
        index = 2 * math.pi * THICKNESS * math.sqrt(x * y) / VISCOSITY / math.log(equivalent / RADIUS)
        matrix[i + n * j, i + n * j] += index
        right[i + n * j] += index * pressure
        if (i, j) == (middle, middle):
            injector = index
    pressure = numpy.linalg.solve(matrix, right)
    return injector * (INJECTION - pressure[middle * (n + 1)]) * 86400


def run(folder, *options):
    """Runs the example and holds OPM Flow's steady rates against the own solve; gain, and rates before and after."""
    command = [sys.executable, "-B", EXAMPLE / "run", "-o", folder, "--discs", "1500", "--steps", "60", *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    print(done.stdout + done.stderr)
    if done.returncode != 0:
        sys.exit(done.returncode)
    n, rates, rock = 21, {}, {}
    for name in ("BEFORE", "AFTER"):
        vectors, units = read_summary(folder / name)
        assert units["TIME"] == "DAYS" and units["WWIR:INJ"] == "SM3/DAY"
        rate, produced = vectors["WWIR:INJ"][-1], vectors["FWPR"][-1]
        assert abs(produced / rate - 1) < 0.005, f"{name} is not steady: {rate} in, {produced} out"
        rock |= read_include(folder / f"{name}.grdecl")
        wanted = steady_rate(rock, n)
        print(f"{name}: OPM Flow {rate:.4f}, own solve {wanted:.4f} m3/day, {100 * (rate / wanted - 1):+.2f} %")
        assert abs(rate / wanted - 1) < 0.01
        rates[name] = rate
    gain = float(re.search(r"one day: ([0-9.]+) times", done.stdout)[1])
    return gain, rates["BEFORE"], rates["AFTER"]


def main():
    folder = pathlib.Path(sys.argv[1])
    gain, before, after = run(folder / "perm")
    assert gain > 1.5 and after > 1.2 * before, "a fracture of tens of metres must show"
    _, same, by_multipliers = run(folder / "mult", "--kind", "mult")
    assert same == before and before < by_multipliers < after


main()
