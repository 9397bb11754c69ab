# SPDX-License-Identifier: BSD-3-Clause
"""The rock laboratory: standard tests on specimens, and micro-parameters from what a rock is known to have."""
import ctypes
from typing import Any, List, NamedTuple, Optional, Tuple, Union

from . import _abi
from ._definition import Definition, PathLike
from ._library import call
from ._progress import Progress, ProgressFunction
from ._records import Calibration, LabReport
from .errors import StoppedError

_COLUMNS = {"curve": 7, "discs": 5, "cracks": 5, "opening": 3}


class LabResult(NamedTuple):
    """What a test found. Tables have a row per entry; their columns stand in lab.h (enum hfrac_lab_table)."""

    report: LabReport
    curve: List[Tuple[float, ...]]
    discs: List[Tuple[float, ...]]
    cracks: List[Tuple[float, ...]]
    opening: List[Tuple[float, ...]]


def _table(lab: Any, name: str) -> List[Tuple[float, ...]]:
    table, count, columns = _abi.LabTable[name.upper()], ctypes.c_int64(), _COLUMNS[name]
    call("hfrac_lab_copy_f64", lab, table, None, 0, ctypes.byref(count))
    values = (ctypes.c_double * max(1, count.value))()
    call("hfrac_lab_copy_f64", lab, table, values, count.value, ctypes.byref(count))
    return [tuple(values[at : at + columns]) for at in range(0, count.value, columns)]


def lab(
    test: str,
    case: Union[PathLike, Definition, None] = None,
    *,
    disc_count: Optional[int] = None,
    seed: Optional[int] = None,
    width: Optional[float] = None,
    confining: Optional[float] = None,
    slit_fraction: Optional[float] = None,
    progress: Optional[ProgressFunction] = None,
    **options: Any,
) -> LabResult:
    """Does a test on a specimen of the rock a case describes: "elastic", "tension", "uniaxial", "biaxial", "brazilian",
    "centre_crack", "sent", "pressurised_crack" or "permeability". width [m], confining [Pa]; what is left out is as in
    lab.h. Stopped by `progress`, it gives what there is."""
    definition = case.copy() if isinstance(case, Definition) else Definition(case)
    definition.update(**options)
    spec = _abi.hfrac_lab_spec()
    call("hfrac_lab_spec_init", ctypes.byref(spec), ctypes.sizeof(spec))
    try:
        spec.test = _abi.LabTest[test.upper()]
    except KeyError:
        names = ", ".join(each.name.lower() for each in _abi.LabTest)
        raise ValueError(f"there is no laboratory test {test!r}; the tests are {names}") from None
    given = {"disc_count": disc_count, "seed": seed, "width": width, "confining": confining, "slit_fraction": slit_fraction}
    for name, value in given.items():
        if value is not None:
            setattr(spec, name, value)
    handle = ctypes.c_void_p()
    told = Progress(progress)
    with told.watched():
        given_by = ctypes.byref(definition._struct), ctypes.byref(spec)
        call("hfrac_lab_run", *given_by, told.callback, None, ctypes.byref(handle))
    try:
        report = _abi.hfrac_lab_report(struct_size=ctypes.sizeof(_abi.hfrac_lab_report))
        call("hfrac_lab_get_report", handle, ctypes.byref(report))
        return LabResult(LabReport.of(report), *(_table(handle, name) for name in _COLUMNS))
    finally:
        call("hfrac_lab_destroy", ctypes.byref(handle))


def calibrate(
    case: Union[PathLike, Definition, None] = None, *, progress: Optional[ProgressFunction] = None, **targets: Any
) -> Tuple[Definition, Calibration]:
    """Finds micro-parameters for `targets`, from those of a case: modulus [Pa], poisson, compressive_strength [Pa],
    tensile_strength [Pa], toughness [Pa m^0.5], permeability [m2]; packings, disc_count, strength_disc_count, seed,
    plane_slopes. Gives a definition with them, and what was achieved."""
    definition = case.copy() if isinstance(case, Definition) else Definition(case)
    wanted = _abi.hfrac_targets()
    call("hfrac_targets_init", ctypes.byref(wanted), ctypes.sizeof(wanted))
    known = {name for name, *_ in wanted._fields_} - {"struct_size"}
    for name, value in targets.items():
        if name not in known:
            raise TypeError(f"calibrate() has no target {name!r}")
        setattr(wanted, name, value)
    found = _abi.hfrac_calibration(struct_size=ctypes.sizeof(_abi.hfrac_calibration))
    told = Progress(progress)
    with told.watched():
        given_by = ctypes.byref(definition._struct), ctypes.byref(wanted)
        status = call("hfrac_calibrate", *given_by, told.callback, None, ctypes.byref(found))
    if status == _abi.Status.STOPPED:
        raise StoppedError("the progress function stopped the calibration")
    return definition, Calibration.of(found)
