# SPDX-License-Identifier: BSD-3-Clause
"""One exception for each way a call can fail. Texts are the library's: the value at fault, the range, the fix."""
from typing import Dict, Type

from ._abi import Status


class HfracError(Exception):
    """Base of all errors. `status` is the library's code, None for errors of this package itself."""

    status = None


class ArgumentError(HfracError, ValueError):
    """An argument is not finite or out of range; nothing has changed."""

    status = Status.ERR_ARGUMENT


class BadHandleError(HfracError, RuntimeError):
    """The simulation is closed."""

    status = Status.ERR_BAD_HANDLE


class StructSizeError(HfracError, RuntimeError):
    """Package and library disagree about a structure."""

    status = Status.ERR_STRUCT_SIZE


class UnknownKeyError(HfracError, LookupError):
    """No option, or no field, of that name."""

    status = Status.ERR_UNKNOWN_KEY


class CaseFileError(HfracError, ValueError):
    """The case file cannot be read or holds an invalid value."""

    status = Status.ERR_CASE_FILE


class ModelError(HfracError, ValueError):
    """The model cannot be built from these options."""

    status = Status.ERR_MODEL


class DivergedError(HfracError, ArithmeticError):
    """The solution left the range of finite numbers; the state is as before the step."""

    status = Status.ERR_DIVERGED


class CollapsedError(HfracError, ArithmeticError):
    """The rock fell apart: it does not bear its load, or a disc left its place in a step; the state is as before the step."""

    status = Status.ERR_COLLAPSED


class ExchangeError(HfracError, RuntimeError):
    """Another rank of the simulation failed, or does not answer; close it on all ranks."""

    status = Status.ERR_EXCHANGE


class DeviceError(HfracError, RuntimeError):
    """The device of run.device is not there, or failed; the state is as before the step."""

    status = Status.ERR_DEVICE


class OutOfMemoryError(HfracError, MemoryError):
    """Out of memory."""

    status = Status.ERR_MEMORY


class BusyError(HfracError, RuntimeError):
    """Called from inside a callback of the same simulation."""

    status = Status.ERR_BUSY


class PoisonedError(HfracError, RuntimeError):
    """An earlier error left the simulation unusable; close it."""

    status = Status.ERR_POISONED


class FileError(HfracError, OSError):
    """A file cannot be written, cannot be read, or is not what it should be; nothing has changed."""

    status = Status.ERR_FILE


class CallbackError(HfracError, RuntimeError):
    """A callback threw an exception that is none of Python's; the simulation is at its last whole step."""

    status = Status.ERR_CALLBACK


class InternalError(HfracError, RuntimeError):
    """An error of the library itself; please report it."""

    status = Status.ERR_INTERNAL


class StoppedError(HfracError):
    """The progress function stopped the building of a simulation, so there is none."""

    status = Status.STOPPED


class StaleViewError(HfracError, RuntimeError):
    """The simulation has changed, or was closed, since the view was taken."""


class LibraryError(HfracError, ImportError):
    """libhfrac cannot be found, or does not fit this package."""


_BY_STATUS: Dict[Status, Type[HfracError]] = {
    kind.status: kind for kind in HfracError.__subclasses__() if kind.status is not None
}


def error_of(status: int, text: str) -> HfracError:
    """The exception for a status; codes of a newer library become a plain HfracError."""
    error = _BY_STATUS.get(status, HfracError)(text)  # type: ignore[call-overload]
    error.status = status  # type: ignore[misc]
    return error
