# SPDX-License-Identifier: BSD-3-Clause
"""Finding libhfrac and calling it.

The library is looked for, in this order: the file HFRAC_LIBRARY names; the build tree this package lies in; this folder (a
wheel); the installation this package lies in; wherever the system's loader looks.
"""
import ctypes
import functools
import os
import pathlib
import sysconfig
from typing import Any, Iterator, List, Optional, Tuple

from . import _abi
from .errors import LibraryError, error_of

_FILE = f"libhfrac.so.{_abi.ABI_VERSION}"


def _places() -> Iterator[str]:
    here = pathlib.Path(__file__).resolve().parent
    if here.parts[-3:] == ("bindings", "python", "hfrac"):
        yield from (str(here.parents[2] / build / "lib" / _FILE) for build in ("build", "build-engine", "build-debug"))
    yield str(here / _FILE)  # a wheel has it beside this file
    for folder in here.parents:
        for lib in ("lib", f"lib/{sysconfig.get_config_var('MULTIARCH')}", "lib64"):
            yield str(folder / lib / _FILE)


def _open() -> Tuple[ctypes.CDLL, str]:
    named = os.environ.get("HFRAC_LIBRARY")
    if named:
        try:
            return ctypes.CDLL(named), named
        except OSError as error:
            raise LibraryError(f"HFRAC_LIBRARY={named} cannot be loaded: {error}") from error
    reasons = []
    for place in [*filter(os.path.exists, _places()), _FILE]:
        try:
            return ctypes.CDLL(place), place
        except OSError as error:
            reasons.append(str(error))
    raise LibraryError(
        f"{_FILE} was not found. Build it (cmake --preset engine && cmake --build --preset engine), install it, or "
        f"name the file in HFRAC_LIBRARY. Tried: {'; '.join(reasons)}"
    )


@functools.lru_cache(maxsize=None)
def _loaded() -> Tuple[ctypes.CDLL, str]:
    library, place = _open()
    try:
        found = ctypes.c_int32(-1)
        library.hfrac_abi_version(ctypes.byref(found))
        if found.value != _abi.ABI_VERSION:
            raise LibraryError(f"{place} has ABI {found.value}, this package needs {_abi.ABI_VERSION}")
        _abi.declare(library)
    except AttributeError as error:
        raise LibraryError(f"{place} is older than this package: {error}") from error
    return library, place


def load() -> ctypes.CDLL:
    """The library, loaded on first use."""
    return _loaded()[0]


def library_path() -> str:
    """Where the library in use was found."""
    return _loaded()[1]


def last_error(handle: Optional[ctypes.c_void_p]) -> str:
    """Text of the last error of a simulation, or of this thread."""
    buffer = ctypes.create_string_buffer(4096)
    load().hfrac_last_error(handle, buffer, len(buffer), None)
    return buffer.value.decode(errors="replace")


def call(function: str, *arguments: Any, handle: Optional[ctypes.c_void_p] = None) -> _abi.Status:
    """Calls a function; errors become exceptions with the text of the simulation `handle`, notes are returned."""
    status: int = getattr(load(), function)(*arguments)
    if status < 0:
        raise error_of(status, last_error(handle) or _abi.STATUS_TEXTS.get(status, f"status {status}"))
    return _abi.Status(status) if status in _abi.STATUS_TEXTS else _abi.Status.OK  # a newer library's note


def text(function: str, *arguments: Any) -> str:
    """Calls a function whose last arguments are a buffer, its capacity and the size needed."""
    needed = ctypes.c_int32()
    call(function, *arguments, None, 0, ctypes.byref(needed))
    buffer = ctypes.create_string_buffer(needed.value)
    call(function, *arguments, buffer, len(buffer), None)
    return buffer.value.decode(errors="replace")


def version() -> Tuple[int, int, int]:
    """Version of the library that runs."""
    numbers = [ctypes.c_int32() for _ in range(3)]
    call("hfrac_version", *map(ctypes.byref, numbers))
    return (numbers[0].value, numbers[1].value, numbers[2].value)


def build_info() -> str:
    """Version, compiler, build type and instruction set of the library, as one line."""
    return text("hfrac_build_info")


def devices() -> List[str]:
    """Name and memory of each card that run.device = "gpu" can use. Empty: there is none (`why_no_devices` says why)."""
    count, lines = _devices()
    return lines.split("\n") if count > 0 else []


def why_no_devices() -> str:
    """Why `devices` is empty; empty if it is not."""
    count, lines = _devices()
    return "" if count > 0 else lines


def _devices() -> Tuple[int, str]:
    count = ctypes.c_int32()
    lines = text("hfrac_devices", ctypes.byref(count))
    return count.value, lines


def status_text(status: int) -> str:
    """What a status code means."""
    return text("hfrac_status_text", status)
