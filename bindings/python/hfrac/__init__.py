# SPDX-License-Identifier: BSD-3-Clause
"""Hydraulic fracturing with a bonded-particle model.

    import hfrac

    with hfrac.Simulation("case.toml", packing_disc_count=2000) as sim:
        sim.step(60)
        for fracture in sim.fractures:
            print(fracture.length, fracture.largest_aperture)

SI units everywhere, unit thickness out of the plane, compression positive for stress and pressure. numpy is used if it
is there and not needed otherwise. One simulation serves one thread at a time; different ones run side by side.
"""
from ._abi import CrackMode, EventKind, GrdeclKind, JointState, LogLevel, Status, StepLimit, StopReason, Upscaling, WellControl, WellFluid
from ._catalogue import magnitude_law
from ._definition import Definition, Option, joint_options, options, schedule_options, well_options
from ._fields import FIELDS, Bonds, Discs, Domains, FieldInfo, Joints, Pipes
from ._grid import Grid
from ._injection import InjectionRow, read_record
from ._lab import LabResult, calibrate, lab
from ._library import build_info, devices, library_path, version, why_no_devices
from ._open_step import OpenStep
from ._records import (
    Balance,
    Calibration,
    Crack,
    Event,
    Fracture,
    FracturePoint,
    Heat,
    LabReport,
    MagnitudeLaw,
    SetupReport,
    SimState,
    Slip,
    SolverReport,
    StepLimits,
    WallState,
    WellState,
)
from ._run import Run
from ._simulation import Advance, Simulation
from ._view import View
from ._well import Well
from .errors import (
    ArgumentError,
    BadHandleError,
    BusyError,
    CallbackError,
    CollapsedError,
    DeviceError,
    ExchangeError,
    CaseFileError,
    DivergedError,
    FileError,
    HfracError,
    InternalError,
    LibraryError,
    ModelError,
    OutOfMemoryError,
    PoisonedError,
    StaleViewError,
    StoppedError,
    StructSizeError,
    UnknownKeyError,
)

__all__ = [
    "FIELDS", "Advance", "ArgumentError", "BadHandleError", "Balance", "Bonds", "BusyError", "Calibration",
    "CallbackError", "CollapsedError", "DeviceError", "ExchangeError",
    "CaseFileError", "Crack", "CrackMode", "Definition", "Discs", "DivergedError", "Domains", "Event", "EventKind", "FieldInfo",
    "FileError", "Fracture", "FracturePoint", "GrdeclKind", "Grid", "Heat", "HfracError", "InjectionRow", "InternalError", "JointState", "Joints", "LabReport",
    "LabResult", "LibraryError", "LogLevel", "MagnitudeLaw", "ModelError", "OpenStep", "Option", "OutOfMemoryError",
    "Pipes", "PoisonedError", "Run", "SetupReport", "SimState", "Simulation", "Slip", "SolverReport", "StaleViewError", "Status",
    "StepLimit", "StepLimits", "StopReason", "StoppedError", "StructSizeError", "UnknownKeyError", "Upscaling", "View",
    "WallState", "Well", "WellControl", "WellFluid", "WellState", "build_info", "calibrate", "devices", "joint_options", "lab",
    "library_path", "magnitude_law", "options", "read_record", "schedule_options", "version", "well_options", "why_no_devices",
]
