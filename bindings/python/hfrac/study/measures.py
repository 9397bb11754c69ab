# SPDX-License-Identifier: BSD-3-Clause
"""What is read from a run folder: a fixed set of results, and those that [[quantity]] asks for.

Everything comes from summary.json, history.csv and events.csv as `hfrac run` writes them; the names carry the units. A run is
measured whenever the table is made, so a new quantity needs no new run.
"""
import csv
import json
import pathlib
import tomllib
from typing import Any, Dict, List

import numpy as np

from .study_file import Quantity, StudyError

#: in the table's order; what a run cannot have is nan
NAMES = ("length_m", "width_m", "fracture_volume_m2", "largest_pressure_Pa", "end_pressure_Pa", "injectivity_m2_per_Pa_s",
         "injected_volume_m2", "crack_count", "event_count", "largest_magnitude", "joint_slipped_length_m")

Table = Dict[str, np.ndarray]


def read_table(path: pathlib.Path) -> Table:
    """Columns of numbers; what is empty or a word is nan."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return {name: np.array([_number(row[k]) for row in rows[1:]]) for k, name in enumerate(rows[0])}


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return float("nan")


def history(folder: pathlib.Path) -> Table:
    return read_table(folder / "history.csv")


def column(table: Table, name: str) -> np.ndarray:
    if name not in table:
        raise StudyError(f"history.csv has no column {name!r}; it has {', '.join(table)}")
    return table[name]


def injectivity(table: Table, case: Dict[str, Any]) -> float:
    """Rate over pressure above the formation's, at the last step of injection, in the first well."""
    rate, pressure = table["well_rate_m2_per_s"], table["well_pressure_Pa"]
    if case.get("stress", {}).get("convention", "total") == "total":
        pressure = pressure - case.get("fluid", {}).get("formation_pressure", 0.0)
    driven = np.flatnonzero((rate > 0.0) & (pressure > 0.0))
    return float(rate[driven[-1]] / pressure[driven[-1]]) if driven.size else float("nan")


def taken(table: Table, quantity: Quantity) -> float:
    values = column(table, quantity.column)
    if quantity.take == "at":
        time = table["time_s"]
        inside = time[0] <= quantity.time <= time[-1] * (1.0 + 1e-9)
        return float(np.interp(quantity.time, time, values)) if inside else float("nan")
    return float({"last": lambda: values[-1], "first": lambda: values[0], "largest": lambda: np.nanmax(values),
                  "smallest": lambda: np.nanmin(values), "mean": lambda: np.nanmean(values)}[quantity.take]())


def measure(folder: pathlib.Path, quantities: List[Quantity]) -> Dict[str, float]:
    """The results of a run by name."""
    summary = json.loads((folder / "summary.json").read_text())
    table = history(folder)
    with open(folder / "case.toml", "rb") as file:
        case = tomllib.load(file)
    magnitudes = read_table(folder / "events.csv")["magnitude"]
    magnitudes = magnitudes[np.isfinite(magnitudes)]  # a joint that was broken from the start has none
    pressure = table["well_pressure_Pa"]
    found = dict(zip(NAMES, (
        summary["longest_fracture"]["length_m"], summary["longest_fracture"]["width_m"], summary["fracture_volume_m2"],
        float(np.nanmax(pressure)) if np.isfinite(pressure).any() else float("nan"), float(pressure[-1]),
        injectivity(table, case), summary["balance"]["injected_volume_m2"], summary["state"]["crack_count"],
        len(magnitudes), float(magnitudes.max()) if len(magnitudes) else float("nan"),
        float(table["joint_slipped_length_m"][-1]) if "joint_slipped_length_m" in table else float("nan"))))
    found.update({one.name: taken(table, one) for one in quantities})
    return found
