# SPDX-License-Identifier: BSD-3-Clause
"""What follows from all runs together: percentiles, bands over time, and how far each parameter moves a result.

P10 is the value that a tenth of the runs lie below (in reserves' reports it is often the other way round).
"""
from typing import Dict, List, NamedTuple, Sequence

import numpy as np

from .measures import Table

LEVELS = (10.0, 50.0, 90.0)


class Swing(NamedTuple):
    """A parameter's bar in a tornado chart: the result where the parameter is low and where it is high."""

    name: str
    low: float
    high: float


def percentiles(values: np.ndarray) -> np.ndarray:
    """P10, P50, P90 of what is finite."""
    values = values[np.isfinite(values)]
    return np.percentile(values, LEVELS) if len(values) else np.full(3, np.nan)


def bands(tables: Sequence[Table], name: str, points: int = 200) -> Dict[str, np.ndarray]:
    """P10, P50, P90 of a column over time, and how many runs last so long: a run counts up to its own end."""
    curves = [(table["time_s"], table[name]) for table in tables if name in table and np.isfinite(table[name]).any()]
    if not curves:
        return {}
    time = np.linspace(0.0, max(curve[0][-1] for curve in curves), points)
    values = np.array([np.interp(time, *curve, left=np.nan, right=np.nan) for curve in curves])
    found = np.array([percentiles(column) for column in values.T])
    return {"time_s": time, "P10": found[:, 0], "P50": found[:, 1], "P90": found[:, 2],
            "runs": np.isfinite(values).sum(axis=0)}


def swings(names: List[str], shares: np.ndarray, results: np.ndarray, one_at_a_time: bool) -> List[Swing]:
    """Widest bar first. One at a time: the runs at P10 and P90 themselves. From any other sample: means over the runs whose
    parameter is in its lowest and in its highest fifth, whatever the others are."""
    found = []
    for k, name in enumerate(names):
        if one_at_a_time:
            low, high = results[1 + 2 * k], results[2 + 2 * k]
        else:
            low, high = (_mean(results[part]) for part in (shares[:, k] <= 0.2, shares[:, k] >= 0.8))
        found.append(Swing(name, float(low), float(high)))
    return sorted(found, key=lambda one: -abs(np.nan_to_num(one.high - one.low)))


def _mean(values: np.ndarray) -> float:
    values = values[np.isfinite(values)]
    return float(values.mean()) if len(values) else float("nan")
