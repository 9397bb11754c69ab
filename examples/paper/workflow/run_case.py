#!/usr/bin/python3 -B
"""One run: writes its case file, calls hfrac and leaves result.json. usage: run_case.py SET NAME OUT [PACKING]

NAME is a run, or packing:COUNT-POROSITY-SEED. A run that hfrac ends with an error leaves a result that says so, and the
verdict shows it; only what is wrong outside the run (no program, no disk) ends this script with an error. What a run
cost stands beside its result, in cost.json, since results repeat to the bit and times do not.
"""
import csv
import json
import math
import os
import pathlib
import resource
import subprocess
import sys

import families

SUFFIXES = (".vtu", ".pvd")


def numbers(path):
    with open(path, newline="") as file:
        # Empty: not measured in this run, as the energy error with facets.
        return [{key: float(value or "nan") for key, value in row.items()} for row in csv.DictReader(file)]


def pressure_at(history, cracks):
    """Well pressure [Pa] of the first step with so many cracks more than after set-up; None if there never were."""
    before = history[0]["crack_count"]
    return next((row["well_pressure_Pa"] for row in history if row["crack_count"] - before >= cracks), None)


def cracks_at(history, step):
    """Cracks after this step or, in a run that ended before, at its end."""
    return [row["crack_count"] for row in history if row["step"] <= step][-1]


def measured(folder):
    """The numbers a claim may rest on, all from what hfrac wrote."""
    summary = json.loads((folder / "summary.json").read_text())
    history = numbers(folder / "history.csv")
    state, fractures = summary["state"], summary["fractures"]
    longest = max(fractures, key=lambda one: one["length_m"], default=None)
    with open(folder / "cracks.csv", newline="") as file:
        drawn = sum(1 for _ in csv.DictReader(file))
    onset, breakdown = pressure_at(history, 1), pressure_at(history, 8)
    azimuth = None
    if longest:
        degrees = math.degrees(longest["azimuth_rad"]) % 180.0
        azimuth = min(degrees, 180.0 - degrees)
    return {
        "ended": summary["ended"],
        "censored": int(state["stop_reason"] == 2),  # a tip came near the boundary (HFRAC_REASON_EXTENT)
        "onset_MPa": None if onset is None else onset * 1e-6,
        "breakdown_MPa": None if breakdown is None else breakdown * 1e-6,
        "cracks": state["crack_count"],
        "equilibration_cracks": state["equilibration_cracks"],
        "cracks_drawn": drawn,
        "cracks_at_tenth": cracks_at(history, 0.1 * summary["planned"]["steps"]),
        "cracks_at_four_fifths": cracks_at(history, 0.8 * summary["planned"]["steps"]),
        "length_m": longest["length_m"] if longest else 0.0,
        "extent_m": max((one["extent_m"] for one in fractures), default=0.0),
        "width_m": max((one["largest_aperture_m"] for one in fractures), default=0.0),
        "wings": max((one["wings"] for one in fractures), default=0),
        "azimuth_deg": azimuth,
        "steps": state["step"],
        "steps_not_at_rest": summary["steps_not_at_rest"],
        "fluid_error_m2": summary["balance"]["fluid_error_m2"],
        "state_hash": summary["state_hash"],
    }


def hfrac(case, folder, *arguments):
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "asked.toml"
    file.write_text(families.as_toml(case))
    command = [os.environ["HFRAC"], "run", file, "-o", folder, "--workers", "1", "--overwrite", "-q", *arguments]
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def write_whole(path, text):
    """Aside, then renamed: a killed run leaves no half result."""
    aside = path.with_suffix(".part")
    aside.write_text(text)
    aside.replace(path)


def step_of_area(folder, area):
    """The first step after which the fractures are open over this area [m2] together; None if they never were."""
    history = numbers(folder / "history.csv")
    return next((int(row["step"]) for row in history if row["fracture_volume_m2"] >= area), None)


def main(which, name, out, packing=None):
    folder = pathlib.Path(out)
    if name.startswith("packing:"):
        done = hfrac(families.packing_case(name.removeprefix("packing:")), folder, "--steps", "0")
        if done.returncode != 0:
            sys.exit(f"{name}: {done.stderr}")
        return
    run = families.expand(which)[0][name]
    done = hfrac(run.case, folder, "--discs", packing)
    if done.returncode == 0 and run.until is not None:
        last = step_of_area(folder, run.until)
        if last is not None:  # the same run once more, to the bit, up to there
            done = hfrac(run.case, folder, "--discs", packing, "--steps", last)
    if done.returncode in (130, -2, -15):
        sys.exit(f"{name}: interrupted")
    try:
        result = {"status": "done", **measured(folder)} if done.returncode == 0 else None
    except (OSError, KeyError, ValueError, IndexError) as error:
        result = {"status": "broken", "error": f"unreadable: {error!r}"}
    if result is None:
        result = {"status": "broken", "error": (done.stderr.strip() or f"exit status {done.returncode}")[:400]}
    if not run.pictures:
        for path in folder.iterdir():
            if path.suffix in SUFFIXES:
                path.unlink()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    write_whole(folder / "cost.json", json.dumps({"processor_s": round(used.ru_utime + used.ru_stime, 3)}) + "\n")
    write_whole(folder / "result.json", json.dumps({"run": name, **result}, indent=1) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
