"""The table of measurements as the claims see it. What is missing or broken is an exception here, so no claim can be
judged on a gap by oversight."""
import csv
import dataclasses

import numpy as np


class Incomplete(Exception):
    """A run that a claim rests on is missing, broken, or has no such value."""


@dataclasses.dataclass(frozen=True)
class Table:
    x: np.ndarray
    values: np.ndarray  # [packing, x]

    @property
    def means(self):
        return self.values.mean(axis=0)

    @property
    def spread(self):
        return self.values.std(axis=0, ddof=1) if len(self.values) > 1 else np.zeros(len(self.x))

    def at(self, x):
        places = np.flatnonzero(np.isclose(self.x, x))
        if len(places) != 1:
            raise Incomplete(f"nothing was run at {x:g}")
        return self.values[:, places[0]]


class Measured:
    """Rows of measured.csv by family and series. `expected`: the points that the set asks for."""

    def __init__(self, rows, expected):
        self.rows = {(row["family"], row["series"], float(row["x"]), int(row["seed"])): row for row in rows}
        self.expected = expected

    @classmethod
    def read(cls, path, expected):
        with open(path, newline="") as file:
            return cls(list(csv.DictReader(file)), expected)

    def points(self, family, series=None):
        return [one for one in self.expected if one.family == family and series in (None, one.series)]

    def row(self, point):
        return self.rows.get((point.family, point.series, point.x, point.seed), {"status": "missing"})

    def lacking(self, family=None):
        """(run, status) of what a family, or all, lacks."""
        found = {}
        for point in self.expected:
            status = self.row(point)["status"]
            if family in (None, point.family) and status != "done":
                found[point.run] = status
        return sorted(found.items())

    def table(self, family, series, quantity, gaps=False):
        """`gaps`: a finished run may have no such value, as one without cracks has no direction; NaN there."""
        points = self.points(family, series)
        if not points:
            raise Incomplete(f"{family}, {series}, is no part of this set")
        lacking = [self.row(point)["status"] for point in points if self.row(point)["status"] != "done"]
        if lacking:
            kinds = ", ".join(f"{lacking.count(kind)} {kind}" for kind in sorted(set(lacking)))
            raise Incomplete(f"of {len(points)} runs {kinds}")
        xs, seeds = sorted({one.x for one in points}), sorted({one.seed for one in points})
        values = np.full((len(seeds), len(xs)), np.nan)
        for point in points:
            text = self.row(point)[quantity]
            if text != "":
                values[seeds.index(point.seed), xs.index(point.x)] = float(text)
        if np.isnan(values).any() and not gaps or np.isnan(values).all():
            raise Incomplete(f"{int(np.isnan(values).sum())} of {values.size} runs have no {quantity}")
        return Table(np.array(xs), values)
