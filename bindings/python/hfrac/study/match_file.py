# SPDX-License-Identifier: BSD-3-Clause
"""The [match] part of a study file: the record, and how it is matched.

    [match]
    members = 100                   # of the ensemble; with several packings spread over them
    iterations = 4                  # passes of ES-MDA
    unconstrained_above = 0.7       # posterior over prior standard deviation above which data do not tell a parameter
    [[match.data]]
    record = "record.csv"           # with time_s and the column; or a pump's record, as a schedule_file
    column = "well_pressure_Pa"     # of history.csv
    error = 0.1e6                   # standard deviation of a point: of the gauge and of the model, scatter of packings apart if there are several
    points = 40                     # the record is read at so many times
    from = 0.0                      # s
    until = 200.0
"""
import csv
import math
import pathlib
from typing import NamedTuple, Tuple

import numpy as np

from .._injection import read_record
from ..errors import HfracError
from .measures import read_table
from .study_file import Reader, Study, StudyError


LEAST_PACKINGS = 4


class MatchError(StudyError):
    """Its [match] is."""

    heading = "matching-a-record"


class Data(NamedTuple):
    """A record, at the times it is compared at."""

    column: str
    time: np.ndarray
    value: np.ndarray
    error: float


class Match(NamedTuple):
    """How a record is matched."""

    members: int
    iterations: int
    unconstrained_above: float
    data: Tuple[Data, ...]


def read_match(study: Study) -> Match:
    """The study's [match]. Raises MatchError."""
    try:
        return _match(study)
    except StudyError as error:
        raise MatchError(f"{study.path}: {error}") from error


def _match(study: Study) -> Match:
    if study.match is None:
        raise StudyError("[match] is missing; hfrac match needs a record to match")
    part = Reader("match.", study.match)
    members = part.integer("members", 10, 100_000, 100)
    iterations = part.integer("iterations", 1, 100, 4)
    above = part.number("unconstrained_above", 0.0, 1.0, 0.7)
    tables = part.take("data", list, "[[match.data]] tables", [])
    data = tuple(_data(index, table, study.path.parent) for index, table in enumerate(tables))
    part.end()
    if not data:
        raise StudyError("[[match.data]] is missing; name the record, its column and its error")
    for index, parameter in enumerate(study.parameters):
        if parameter.law == "list":
            raise StudyError(f"parameter[{index}].law = 'list' cannot be matched; take a law of numbers")
    count = len(study.packings)
    if 1 < count < LEAST_PACKINGS or 2 * count > members:
        raise StudyError(f"packings = {list(study.packings)!r} must be one, or at least {LEAST_PACKINGS} for their scatter to be told, and "
                         f"no more than half of match.members = {members}, so that each has two members at least")
    return Match(members, iterations, above, data)


def _data(index: int, table: object, folder: pathlib.Path) -> Data:
    part = Reader(f"match.data[{index}].", table)
    file = folder / part.take("record", str, "the record's file", needed=True)
    column = part.take("column", str, "a column of history.csv", "well_pressure_Pa")
    error = part.number("error", 1e-300, 1e300, needed=True)
    points = part.integer("points", 2, 10_000, 40)
    first = part.number("from", 0.0, 1e12, 0.0)
    last = part.number("until", 0.0, 1e12, math.inf)
    part.end()
    time, value = _record(part, file, column)
    inside = np.isfinite(value) & (time >= first) & (time <= last)
    if inside.sum() < 2:
        raise part.fail("record", f"= '{file}' has {inside.sum()} rows from {first:g} s to {last:g} s; at least 2 are needed")
    time, value = time[inside], value[inside]
    at = np.linspace(time[0], time[-1], points)
    return Data(column, at, np.interp(at, time, value), error)


def _record(part: Reader, file: pathlib.Path, column: str) -> Tuple[np.ndarray, np.ndarray]:
    try:
        with open(file, newline="") as stream:
            head = next(csv.reader(stream), [])
    except OSError as error:
        raise part.fail("record", f"= '{file}' cannot be read: {error.strerror}") from error
    if "time_s" in head and column in head:
        table = read_table(file)
        return table["time_s"], table[column]
    if column != "well_pressure_Pa":
        raise part.fail("record", f"= '{file}' has no columns time_s and {column}; it has {', '.join(head)}")
    try:
        rows = np.array(read_record(file), float)
    except HfracError as error:
        raise part.fail("record", f": {error}") from error
    return rows[:, 0], rows[:, 2]
