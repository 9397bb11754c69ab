#!/usr/bin/python3 -B
"""All results of a set into one table, a line per point of a figure. usage: measure.py SET OUT TABLE.csv

A run without a result stands in the table as missing, one that ended with an error as broken.
"""
import csv
import json
import pathlib
import sys

import families

COLUMNS = [
    "family",
    "series",
    "x",
    "seed",
    "run",
    "status",
    "onset_MPa",
    "breakdown_MPa",
    "cracks",
    "equilibration_cracks",
    "cracks_drawn",
    "cracks_at_tenth",
    "cracks_at_four_fifths",
    "length_m",
    "extent_m",
    "width_m",
    "wings",
    "azimuth_deg",
    "censored",
    "steps",
    "steps_not_at_rest",
    "fluid_error_m2",
    "state_hash",
    "error",
]


def result_of(folder):
    try:
        return json.loads((folder / "result.json").read_text())
    except FileNotFoundError:
        return {"status": "missing"}
    except (OSError, ValueError) as error:
        return {"status": "broken", "error": repr(error)}


def cost_of(folder):
    """Processor time of a run, s; 0 where it is not known."""
    try:
        return json.loads((folder / "cost.json").read_text())["processor_s"]
    except (OSError, ValueError, KeyError):
        return 0.0


def cell(value):
    return "" if value is None else f"{value:.10g}" if isinstance(value, float) else " ".join(str(value).split())


def main(which, out, table):
    points = families.expand(which)[1]
    results = {}
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for point in points:
            if point.run not in results:
                results[point.run] = result_of(pathlib.Path(out) / "runs" / point.run)
            row = {
                **results[point.run],
                "family": point.family,
                "series": point.series,
                "x": point.x,
                "seed": point.seed,
                "run": point.run,
            }
            writer.writerow([cell(row.get(column)) for column in COLUMNS])
    count = {}
    for result in results.values():
        count[result["status"]] = count.get(result["status"], 0) + 1
    cost = sum(cost_of(pathlib.Path(out) / "runs" / name) for name in results)
    states = ", ".join(f"{n} {s}" for s, n in count.items())
    print(f"{table}: {len(points)} points, {len(results)} runs, {states}; {cost:.0f} s of processor time")


if __name__ == "__main__":
    main(*sys.argv[1:])
