# SPDX-License-Identifier: BSD-3-Clause
"""A run folder as tables: history, cracks, events and fractures as pandas data frames, fields as xarray datasets.

    run = hfrac.Run("out/first")
    run.history.plot(x="time_s", y="well_pressure_Pa")
    run.fields(120.0)["pressure_Pa"]

pandas and xarray are needed only here, and only when asked for. Files are read anew each time, so a run that goes on may be watched.
"""
import json
import os
import pathlib
from typing import Any, Dict, List, Optional, Union

from . import _vtu
from .errors import FileError, LibraryError

SERIES = ("discs", "bonds", "flow", "cracks", "fractures", "joints")


def _module(name: str) -> Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise LibraryError(f"this needs {name}: apt-get install python3-{name} ({error})") from error


class Run:
    """The folder that `hfrac run` has written, or is writing."""

    def __init__(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        self.folder = pathlib.Path(folder)
        if not (self.folder / "history.csv").is_file():
            raise FileError(f"'{self.folder}' is no run folder: it has no history.csv")

    def _table(self, name: str) -> Any:
        pandas = _module("pandas")
        try:
            return pandas.read_csv(self.folder / f"{name}.csv")
        except (OSError, ValueError) as error:
            raise FileError(f"'{self.folder / name}.csv' cannot be read: {error}") from error

    @property
    def history(self) -> Any:
        """A row per step; columns as in history.csv, units in their names."""
        return self._table("history")

    @property
    def cracks(self) -> Any:
        """A row per broken bond."""
        return self._table("cracks")

    @property
    def events(self) -> Any:
        """A row per seismic event of the whole run."""
        return self._table("events")

    @property
    def fractures(self) -> Any:
        """A row per fracture at the end."""
        return self._table("fractures")

    @property
    def summary(self) -> Dict[str, Any]:
        """summary.json as it is."""
        try:
            return dict(json.loads((self.folder / "summary.json").read_text()))
        except (OSError, ValueError) as error:
            raise FileError(f"'{self.folder}/summary.json' cannot be read: {error}") from error

    def times(self, series: str = "discs") -> List[float]:
        """Times of the snapshots [s]."""
        return [time for time, _ in self._snapshots(series)]

    def _snapshots(self, series: str) -> Any:
        if series not in SERIES:
            raise FileError(f"series {series!r} must be one of {', '.join(SERIES)}")
        found = _vtu.series(self.folder / f"{series}.pvd")
        if not found:
            raise FileError(f"'{self.folder}/{series}.pvd' lists no snapshot")
        return found

    def fields(self, time: Optional[float] = None, series: str = "discs") -> Any:
        """The snapshot nearest to `time` [s], the last without one: a variable per array, along `item` (and `component`), with its
        unit; coordinates `x` and `y` [m] of items that are points, and `time` the snapshot's own. Arrays of corners, where items have several,
        go along `point`."""
        xarray = _module("xarray")
        when, file = self._snapshots(series)[-1]
        if time is not None:
            when, file = min(self._snapshots(series), key=lambda entry: abs(entry[0] - time))
        found = _vtu.arrays(self.folder / file)
        points = next(iter(found["Points"].values()))[0]
        cells = len(found["Cells"]["types"][0]) if found["Cells"] else 0
        where = "item" if cells == len(points) else "point"
        data = {}
        for section, along in (("PointData", where), ("CellData", "item")):
            for name, (values, unit) in found[section].items():
                sizes = [along] if values.ndim == 1 else [along, f"component_{values.shape[1]}"]
                data[name] = (sizes, values, {"units": unit} if unit else {})
        places = {"x": (where, points[:, 0], {"units": "m"}), "y": (where, points[:, 1], {"units": "m"})}
        return xarray.Dataset(data, {**places, "time": when}, {"series": series, "file": file})
