# SPDX-License-Identifier: BSD-3-Clause
"""`hfrac sweep`: the runs of a study, and what follows from them, written into one folder.

    runs/00000/ ...     run folders, each with result.json
    table.csv           a line per run: parameters, packing, status, results, hfrac's sentence where it failed
    percentiles.csv     P10, P50, P90 of each result
    sensitivity.csv     tornado's ends and Sobol indices, by result and parameter
    bands.csv           P10, P50, P90 of pressure, length and width over time
    tornado.png, sobol.png, bands.png
"""
import pathlib
from typing import Any, Dict, List, NamedTuple, Sequence

import numpy as np

from . import charts, sobol, statistics
from .cases import Run, runs_of, settled
from .designs import design
from .measures import NAMES, history, measure
from .pool import Result, result_of
from .study_file import Study, StudyError
from .tables import write_csv, write_parquet

CURVES = ("well_pressure_Pa", "fracture_length_m", "fracture_width_m", "joint_slipped_length_m")
DRAWN = 8  # results with a panel in the charts


class Plan(NamedTuple):
    """What a study runs."""

    study: Study
    folder: pathlib.Path
    points: np.ndarray
    runs: List[Run]


def plan(study: Study, folder: pathlib.Path) -> Plan:
    """The study's runs under `folder`. Raises StudyError."""
    points = design(study)
    return Plan(study, folder, points, runs_of(study, points, folder / "runs", settled(study)))


def results(plan: Plan) -> Dict[int, Result]:
    """What is known of the runs so far."""
    known = {run.index: result_of(run) for run in plan.runs}
    return {index: result for index, result in known.items() if result is not None}


def report(plan: Plan, known: Dict[int, Result]) -> List[str]:
    """Writes tables and charts of what is there; gives sentences for the user."""
    study, folder = plan.study, plan.folder
    measured = {}
    for run in plan.runs:
        if run.index in known and known[run.index].status == "done":
            try:
                measured[run.index] = measure(run.folder, list(study.quantities))
            except (OSError, KeyError, ValueError, IndexError) as error:
                if isinstance(error, StudyError):
                    raise
                known[run.index] = Result("failed", f"its files cannot be read: {error!r}; rerun it by --retry", 0.0)
    names = [*NAMES, *(one.name for one in study.quantities)]
    _write_table(plan, known, measured, names)
    if not measured:
        return ["no run is done, so there are no percentiles and no charts"]
    values = {name: np.array([measured.get(run.index, {}).get(name, np.nan) for run in plan.runs], float) for name in names}
    write_csv(folder / "percentiles.csv", ["result", "runs", "P10", "P50", "P90", "mean", "standard_deviation"], [
        [name, int(np.isfinite(column).sum()), *statistics.percentiles(column), *_moments(column)]
        for name, column in values.items()])
    tables = [history(run.folder) for run in plan.runs if run.index in measured]
    bands = {name: band for name in CURVES if (band := statistics.bands(tables, name))}
    _write_bands(folder / "bands.csv", bands)
    return _sensitivity(plan, values, bands)


def _moments(column: np.ndarray) -> Sequence[float]:
    column = column[np.isfinite(column)]
    return (column.mean(), column.std(ddof=1)) if len(column) > 1 else (column.mean() if len(column) else np.nan, np.nan)


def _write_table(plan: Plan, known: Dict[int, Result], measured: Dict[int, Dict[str, float]], names: List[str]) -> None:
    head = ["run", *(one.name for one in plan.study.parameters), "packing", "status", *names, "sentence"]
    rows: List[List[Any]] = []
    for run in plan.runs:
        result = known.get(run.index, Result("missing", "", 0.0))
        found = measured.get(run.index, {})
        packing = float("nan") if run.packing is None else run.packing
        rows.append([run.index, *run.values.values(), packing, result.status, *(found.get(name, float("nan")) for name in names),
                     result.sentence])
    write_csv(plan.folder / "table.csv", head, rows)
    write_parquet(plan.folder / "table.parquet", head, rows)


def _write_bands(path: pathlib.Path, bands: Dict[str, Dict[str, np.ndarray]]) -> None:
    rows = [[name, *row] for name, band in bands.items() for row in zip(*band.values())]
    write_csv(path, ["column", "time_s", "P10", "P50", "P90", "runs"], rows)


def _sensitivity(plan: Plan, values: Dict[str, np.ndarray], bands: Dict[str, Dict[str, np.ndarray]]) -> List[str]:
    """A sample's result is the mean over its packings."""
    study, each = plan.study, max(1, len(plan.study.packings))
    names = [one.name for one in study.parameters]
    single, designed = study.sampling == "one-at-a-time", study.sampling == "saltelli"
    rows, bars, shares = [], [], []
    for name, column in values.items():
        packed = column.reshape(-1, each)
        counts = np.isfinite(packed).sum(axis=1)
        mean = np.where(counts > 0, np.nansum(packed, axis=1) / np.maximum(counts, 1), np.nan)
        if not varies(mean):
            continue
        swings = statistics.swings(names, plan.points, mean, single)
        total = np.full(len(names), np.nan)
        if designed:
            first, total = sobol.saltelli_indices(mean, len(names))
        else:
            first = np.array([np.nan if single else sobol.sample_index(plan.points[:, k], mean) for k in range(len(names))])
        by_name = {swing.name: swing for swing in swings}
        rows += [[name, one, by_name[one].low, by_name[one].high, first[k], total[k]] for k, one in enumerate(names)]
        bars.append((name, float(mean[0] if single else np.nanmean(mean)), swings))
        if np.isfinite(first).any():
            shares.append((name, first, total))
    write_csv(plan.folder / "sensitivity.csv", ["result", "parameter", "low", "high", "first_order", "total_order"], rows)
    return _draw(plan, foremost(bars, study), foremost(shares, study), bands, names)


def foremost(found: List[Any], study: Study) -> List[Any]:
    """What is drawn, by the name that each begins with: what the study asks for, how far joints slipped (where a zone is broken from
    the start, length_m is the zone's), then the others in the table's order."""
    first = [*(one.name for one in study.quantities), "joint_slipped_length_m"]
    return sorted(found, key=lambda one: first.index(one[0]) if one[0] in first else len(first))[:DRAWN]


def varies(values: np.ndarray) -> bool:
    """By more than rounding, as what a record injects in every run does not."""
    values = values[np.isfinite(values)]
    return len(values) > 0 and bool(np.ptp(values) > 1e-9 * np.abs(values).max())


def goes_on(band: Dict[str, np.ndarray]) -> bool:
    """Not the same from beginning to end."""
    return any(varies(band[level]) for level in ("P10", "P50", "P90"))


def _draw(plan: Plan, bars: Any, shares: Any, bands: Any, names: List[str]) -> List[str]:
    if not charts.available():
        return ["no charts are drawn: apt-get install python3-matplotlib"]
    if bars:
        single = plan.study.sampling == "one-at-a-time"
        charts.tornado(plan.folder / "tornado.png", bars, "P10 and P90, others at P50" if single else "means of lowest and highest fifth")
    if shares:
        charts.indices(plan.folder / "sobol.png", names, shares)
    if drawn := {name: band for name, band in bands.items() if goes_on(band)}:
        charts.bands(plan.folder / "bands.png", drawn)
    return []
