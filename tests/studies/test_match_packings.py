#!/usr/bin/python3
"""examples/field/match-packings.toml and match-falloff.toml where the truth comes from packings that the ensemble has not: 11, 12 and 13, each
reported, none chosen.

The record is what match-case.toml gives in that packing with the known values and the study's [set], and 0.03 MPa (0.5 m) of noise. Packings, members,
passes and error of a study, these truths and what counts were committed before any was run with it: P50 within 10 % of the truth as the issue asks,
which the table tells; and, tested, that of the nine 95 % intervals (of 64 members) at most one misses its truth.
match-falloff.toml is a second attempt, set after match-packings.toml had been run for packing 11 (K_Ic -41 %, sigma_hmin +3 %, permeability -43 %).
The tables printed here are the page's (docs/studies.md).
"""
import csv
import json
import os
import pathlib
import sys
import tempfile
import tomllib
import unittest

import support

import numpy as np

TRUTH = {"K_Ic": 4.2e6, "sigma_hmin": 10.8e6, "permeability": 1e-14}
FIELD = support.ROOT / "examples/field"
PACKINGS = tuple(map(int, os.environ.get("HFRAC_PACKINGS", "11 12 13").split()))
AREA = 8.55  # m2
NOISE = {"well_pressure_Pa": 0.03e6, "tip_distance_m": 0.5}


def with_value(text, key, value):
    """The case or study with another number in the one line that sets `key`."""
    lines = text.splitlines()
    (at,) = [k for k, line in enumerate(lines) if line.split("=")[0].strip() == key]
    lines[at] = f"{key} = {value!r}"
    return "\n".join(lines) + "\n"


def truth(top, packing, settings):
    """History of the case with the known values, as columns, and the radius of its hole [m]."""
    case = (FIELD / "match-case.toml").read_text()
    for key, value in (("fracture_toughness", TRUTH["K_Ic"]), ("sigma_hmin", TRUTH["sigma_hmin"]), ("permeability", TRUTH["permeability"])):
        case = with_value(case, key, value)
    for key, value in settings.get("stepping", {}).items():
        case = with_value(case, key, value)
    for key, value in settings["well"].items():
        case = case.replace("\n[[well]]\n", f"\n[[well]]\n{key} = {value!r}\n")
    (top / "truth.toml").write_text(case + f"\n[model]\nseed = {packing}\n")
    done = support.hfrac("run", top / "truth.toml", "-o", top / f"truth-{packing}", "-q", "--overwrite")
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    with open(top / f"truth-{packing}/history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    summary = json.loads((top / f"truth-{packing}/summary.json").read_text())
    return {name: np.array([float(row[name]) for row in rows]) for name in ("time_s", *NOISE)}, summary["wells"][0]["radius_m"]


def record(top, packing, settings):
    """The record's text."""
    table, _ = truth(top, packing, settings)
    random = np.random.default_rng(packing)
    for name, deviation in NOISE.items():
        table[name] = table[name] + deviation * random.standard_normal(len(table[name]))
    return "time_s,well_pressure_Pa,tip_distance_m\n" + "".join(f"{time:g},{pressure:.0f},{distance:.2f}\n" for time, pressure, distance in zip(*table.values()))


def match(top, name, packing):
    """The posterior's rows by parameter, its members' values, and what the command printed."""
    study = tomllib.loads((FIELD / name).read_text())
    text = record(top, packing, study["set"])
    kept = study["match"]["data"][0]["record"]
    if packing == 11 and text != (FIELD / kept).read_text():
        raise AssertionError(f"{kept} is no longer what packing 11 gives")
    (top / kept).write_text(text)
    for file in ("match-case.toml", name):
        (top / file).write_text((FIELD / file).read_text())
    # One folder for all: the first ensemble and the runs in each packing are the same.
    done = support.hfrac("match", top / name, "-o", top / "out", "--jobs", os.environ.get("HFRAC_JOBS", "2"), limit=7000)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    with open(top / "out/parameters.csv", newline="") as file:
        found = {row["parameter"]: row for row in csv.DictReader(file) if row["ensemble"] == "posterior"}
    with open(top / "out/members.csv", newline="") as file:
        members = [row for row in csv.DictReader(file) if row["ensemble"] == "posterior"]
    return found, {name: np.array([float(row[name]) for row in members]) for name in TRUTH}, done.stdout


class OtherPackings(unittest.TestCase):
    def test_how_far_packings_are_apart(self):
        """Pressure off the mean of four packings, same values, with the void between the discs as the hole's fluid and with the area asked for."""
        apart = {}
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            for area in (0.0, AREA):
                runs = [truth(pathlib.Path(top), packing, {"well": {"fluid_area": area}}) for packing in (1, 2, 3, 4)]
                at = np.linspace(0.0, 120.0, 241)
                curves = 1e-6 * np.array([np.interp(at, table["time_s"], table["well_pressure_Pa"]) for table, _ in runs])
                apart[area] = np.sqrt(np.mean((curves - curves.mean(axis=0)) ** 2, axis=1))
                print(f"fluid_area {area:g} m2: packings 1 to 4 with holes of {', '.join(f'{radius:.2f}' for _, radius in runs)} m: pressure rises by "
                      f"{', '.join(f'{(curve[40] - curve[0]) / 20.0:.3f}' for curve in curves)} MPa/s over 20 s; rms off their mean "
                      f"{', '.join(f'{off:.2f}' for off in apart[area])} MPa")
        self.assertLess(np.sqrt(np.mean(apart[AREA] ** 2)), np.sqrt(np.mean(apart[0.0] ** 2)))

    def test_pressure_with_a_short_fall_off(self):
        self.judge("match-packings.toml")

    def test_pressure_until_closure_and_event_radius(self):
        self.judge("match-falloff.toml")

    def judge(self, study):
        missed = []
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as folder:
            for packing in PACKINGS:
                found, members, text = match(pathlib.Path(folder), study, packing)
                print(text)
                for name, value in TRUTH.items():
                    row = found[name]
                    low, high = np.percentile(members[name], [2.5, 97.5])
                    print(f"| {packing} | {name} | {value:g} | " + " | ".join(f"{float(row[part]):.4g}" for part in ("P10", "P50", "P90"))
                          + f" | {100 * (float(row['P50']) / value - 1):+.1f} % | {low:.4g} to {high:.4g} | {float(row['deviation_ratio']):.2f} | {row['verdict']} |")
                    sys.stdout.flush()
                    if row["verdict"] != "record not explained" and not low <= value <= high:
                        missed.append((packing, name))
        self.assertLessEqual(len(missed), 1, f"95 % intervals that miss the truth: {missed}")


if __name__ == "__main__":
    unittest.main()
