# SPDX-License-Identifier: BSD-3-Clause
"""Cases of a study: the base case with [set] and one row of the design laid over it, as a case file of its own."""
import functools
import pathlib
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from .._definition import Definition
from ..errors import HfracError
from .study_file import Study, StudyError


class Run(NamedTuple):
    """One run of a study."""

    index: int
    folder: pathlib.Path
    #: row of the design it belongs to, and the packing (None: the case's own)
    sample: int
    packing: Optional[int]
    values: Dict[str, Any]
    #: the case file, or why there is none
    text: str
    refusal: str


@functools.lru_cache(maxsize=4)
def base_case(path: pathlib.Path) -> Definition:
    """The base case. Raises StudyError."""
    try:
        return Definition(path)
    except HfracError as error:
        raise StudyError(f"case: {error}") from error


def _keys(definition: Definition, option: str) -> List[str]:
    """`well.rate` means every well, `joint.friction` every joint."""
    kind, _, name = option.partition(".")
    if kind not in ("well", "joint"):
        return [option]
    count = int(definition.get(f"{kind}_count"))
    if count == 0:
        raise StudyError(f"{option}: the case has no [[{kind}]]")
    return [f"{kind}[{index}].{name}" for index in range(count)]


def _lay(definition: Definition, option: str, value: Any) -> None:
    for key in _keys(definition, option):
        definition.set(key, value.item() if isinstance(value, np.generic) else value)


def settled(study: Study) -> Definition:
    """The base case with [set] laid over it, every key of the study tried once. Raises StudyError."""
    definition = base_case(study.case).copy()
    try:
        for option, value in study.settings.items():
            _lay(definition, option, value)
    except (HfracError, TypeError, ValueError) as error:
        raise StudyError(f"set.{option}: {error}") from error
    trial = definition.copy()
    for index, parameter in enumerate(study.parameters):
        try:
            for option in parameter.options:
                _lay(trial, option, parameter.value(0.5))
        except (HfracError, TypeError, ValueError) as error:
            raise StudyError(f"parameter[{index}].option {option!r}: {error}") from error
    return definition


def runs_of(study: Study, points: np.ndarray, folder: pathlib.Path, settings: Definition,
            dealt: Optional[np.ndarray] = None) -> List[Run]:
    """Every row of `points` in every packing of the study, or in the one (of study.packings) that it is dealt, as runs under `folder`."""
    runs: List[Run] = []
    packings: Tuple[Optional[int], ...] = study.packings or (None,)
    for sample, point in enumerate(points):
        values = {one.name: one.value(float(share)) for one, share in zip(study.parameters, point)}
        for packing in packings if dealt is None else (packings[dealt[sample]],):
            index = len(runs)
            text, refusal = "", ""
            try:
                definition = settings.copy()
                for parameter in study.parameters:
                    for option in parameter.options:
                        _lay(definition, option, values[parameter.name])
                if packing is not None:
                    definition.set("model.seed", packing)
                text = definition.text
            except HfracError as error:
                refusal = str(error)
            runs.append(Run(index, folder / f"{index:05d}", sample, packing, values, text, refusal))
    return runs
