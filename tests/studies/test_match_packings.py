#!/usr/bin/python3
"""examples/field/match.toml where the truth comes from another packing than the ensemble's: packings 2, 3 and 4, each reported, none chosen.

The record is what match-case.toml gives in that packing with the known values, and 0.03 MPa of noise; the ensemble is in packing 1 as
in match.toml. Its `error` is 0.1 MPa, the scatter of packings that docs/studies.md named before this was run. The table printed here is the page's.
"""
import csv
import json
import os
import pathlib
import sys
import tempfile
import unittest

import support

import numpy as np

TRUTH = {"K_Ic": 4.2e6, "sigma_hmin": 10.8e6, "permeability": 1e-14}
FIELD = support.ROOT / "examples/field"
ERROR = 0.1e6  # Pa


def with_value(text, key, value):
    """The case or study with another number in the one line that sets `key`."""
    lines = text.splitlines()
    (at,) = [k for k, line in enumerate(lines) if line.split("=")[0].strip() == key]
    lines[at] = f"{key} = {value!r}"
    return "\n".join(lines) + "\n"


def truth(top, packing):
    """Times and pressures of the case with the known values, and the radius of its hole [m]."""
    case = (FIELD / "match-case.toml").read_text()
    for key, value in (("fracture_toughness", TRUTH["K_Ic"]), ("sigma_hmin", TRUTH["sigma_hmin"]), ("permeability", TRUTH["permeability"])):
        case = with_value(case, key, value)
    (top / "truth.toml").write_text(case + f"\n[model]\nseed = {packing}\n")
    done = support.hfrac("run", top / "truth.toml", "-o", top / f"truth-{packing}", "-q")
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    with open(top / f"truth-{packing}/history.csv", newline="") as file:
        rows = [(float(row["time_s"]), float(row["well_pressure_Pa"])) for row in csv.DictReader(file)]
    summary = json.loads((top / f"truth-{packing}/summary.json").read_text())
    return *np.array(rows).T, summary["wells"][0]["radius_m"]


def match(top, packing):
    """The posterior's rows by parameter."""
    times, pressures, _ = truth(top, packing)
    pressures = pressures + 0.03e6 * np.random.default_rng(packing).standard_normal(len(pressures))
    (top / "match-record.csv").write_text(
        "time_s,well_pressure_Pa\n" + "".join(f"{float(time)!r},{float(pressure)!r}\n" for time, pressure in zip(times, pressures)))
    (top / "match-case.toml").write_text((FIELD / "match-case.toml").read_text())
    (top / "match.toml").write_text(with_value((FIELD / "match.toml").read_text(), "error", ERROR))
    done = support.hfrac("match", top / "match.toml", "-o", top / "out", "--jobs", os.environ.get("HFRAC_JOBS", "2"), limit=5000)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    with open(top / "out/parameters.csv", newline="") as file:
        return {row["parameter"]: row for row in csv.DictReader(file) if row["ensemble"] == "posterior"}


class OtherPackings(unittest.TestCase):
    def test_how_far_packings_are_apart(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            times, first, radius = truth(pathlib.Path(top), 1)
            print(f"packing 1: hole of {radius:.2f} m, largest pressure after {times[first.argmax()]:.0f} s")
            for packing in (2, 3, 4):
                at, other, radius = truth(pathlib.Path(top), packing)
                off = np.interp(times, at, other) - first
                print(f"packing {packing}: hole of {radius:.2f} m, largest pressure after {at[other.argmax()]:.0f} s, {1e-6 * np.sqrt(np.mean(off ** 2)):.2f} MPa "
                      f"rms off packing 1, at most {1e-6 * np.abs(off[times > 90.0]).max():.2f} MPa from 90 s on")
                self.assertGreater(np.sqrt(np.mean(off ** 2)), ERROR, "the scatter of packings is no larger than the error that is said to hold it")

    def test_what_the_truth_of_another_packing_gives(self):
        for packing in map(int, os.environ.get("HFRAC_PACKINGS", "2 3 4").split()):
            with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
                found = match(pathlib.Path(top), packing)
            for name, value in TRUTH.items():
                row = found[name]
                print(f"| {packing} | {name} | {value:g} | " + " | ".join(f"{float(row[part]):.4g}" for part in ("P10", "P50", "P90"))
                      + f" | {100 * (float(row['P50']) / value - 1):+.1f} % | {row['verdict']} |")
                sys.stdout.flush()
                off = abs(float(row["P50"]) / value - 1.0)
                self.assertTrue(off <= 0.1 or row["verdict"] == "record not explained", f"packing {packing} claims a wrong {name}: {row['verdict']}")


if __name__ == "__main__":
    unittest.main()
