# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a study: tornado chart, Sobol indices, bands over time. Without matplotlib there are none, and the study says so."""
import importlib.util
import pathlib
from typing import Any, Dict, List, Sequence, Tuple

import numpy as np

from .statistics import Swing

BLUE, RED, GREY = "#2f6f9f", "#b5503c", "#666666"
#: how names with SI units are shown: the unit in the name's end, factor, unit on the axis
UNITS: Tuple[Tuple[str, float, str], ...] = (
    ("_m2_per_Pa_s", 1.0, "m²/(Pa s)"), ("_m2_per_s", 1.0, "m²/s"), ("_Pa", 1e-6, "MPa"), ("_m2", 1.0, "m²"), ("_m", 1.0, "m"),
    ("_s", 1.0, "s"))


def available() -> bool:
    return importlib.util.find_spec("matplotlib") is not None


def pyplot() -> Any:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"axes.spines.top": False, "axes.spines.right": False, "font.size": 9.0, "figure.dpi": 150})
    return plt


def shown(name: str) -> Tuple[str, float]:
    """A column's name as a label, and the factor from SI to the unit it is shown in."""
    for end, factor, unit in UNITS:
        if name.endswith(end):
            scale = (1e3, "mm") if name == "width_m" or name == "fracture_width_m" else (factor, unit)
            return f"{name[:-len(end)].replace('_', ' ')} [{scale[1]}]", scale[0]
    return name.replace("_", " "), 1.0


def _panels(count: int, height: float) -> Any:
    columns = 1 if count == 1 else 2
    rows = -(-count // columns)
    figure, axes = pyplot().subplots(rows, columns, figsize=(4.6 * columns, height * rows), squeeze=False)
    flat = list(axes.flat)
    for axis in flat[count:]:
        axis.set_visible(False)
    return figure, flat


def _save(figure: Any, path: pathlib.Path) -> None:
    figure.tight_layout()
    figure.savefig(path)
    pyplot().close(figure)


def tornado(path: pathlib.Path, found: Sequence[Tuple[str, float, List[Swing]]], note: str) -> None:
    """A panel for each result: (name, its middle, bars)."""
    figure, axes = _panels(len(found), 0.9 + 0.3 * max(len(bars) for _, _, bars in found))
    for axis, (name, middle, bars) in zip(axes, found):
        label, factor = shown(name)
        for row, bar in enumerate(reversed(bars)):
            centre = 0.5 * (bar.low + bar.high)  # both ends may lie on one side of the middle of all runs
            for value, colour in ((bar.low, BLUE), (bar.high, RED)):
                axis.barh(row, (value - centre) * factor, left=centre * factor, height=0.62, color=colour)
        axis.axvline(middle * factor, color=GREY, linewidth=0.8)
        axis.set_yticks(range(len(bars)), [bar.name for bar in reversed(bars)])
        axis.set_xlabel(label)
    figure.suptitle(f"blue: parameter low, red: high ({note})", fontsize=8.0, color=GREY)
    _save(figure, path)


def indices(path: pathlib.Path, names: Sequence[str], found: Sequence[Tuple[str, np.ndarray, np.ndarray]]) -> None:
    """First and total order, a panel for each result."""
    figure, axes = _panels(len(found), 0.9 + 0.36 * len(names))
    rows = np.arange(len(names))[::-1]
    for axis, (name, first, total) in zip(axes, found):
        both = np.isfinite(total).any()
        axis.barh(rows + (0.19 if both else 0.0), np.nan_to_num(first), height=0.36, color=BLUE, label="first order")
        if both:
            axis.barh(rows - 0.19, np.nan_to_num(total), height=0.36, color=RED, label="total order")
        axis.set_yticks(rows, names)
        axis.set_xlim(left=min(0.0, axis.get_xlim()[0]), right=max(1.0, axis.get_xlim()[1]))
        axis.set_xlabel(f"share of the variance of {shown(name)[0].partition(' [')[0]}")
    axes[0].legend(frameon=False, fontsize=8.0, loc="lower right")
    _save(figure, path)


def bands(path: pathlib.Path, found: Dict[str, Dict[str, np.ndarray]]) -> None:
    """P10 to P90 as an area, P50 as a line, over time."""
    figure, axes = _panels(len(found), 2.6)
    for axis, (name, band) in zip(axes, found.items()):
        label, factor = shown(name)
        axis.fill_between(band["time_s"], band["P10"] * factor, band["P90"] * factor, color=BLUE, alpha=0.25, linewidth=0.0,
                          label="P10 to P90")
        axis.plot(band["time_s"], band["P50"] * factor, color=BLUE, label="P50")
        axis.set_xlabel("time [s]")
        axis.set_ylabel(label)
    axes[0].legend(frameon=False, fontsize=8.0)
    _save(figure, path)
