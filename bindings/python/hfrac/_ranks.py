# SPDX-License-Identifier: BSD-3-Clause
"""One simulation over the ranks of a communicator of mpi4py, or of whatever else has py2f()."""
import ctypes
import functools
import os
from typing import Any

from . import _abi
from ._library import call, library_path
from .errors import LibraryError

_FILE = f"libhfrac_mpi.so.{_abi.ABI_VERSION}"


@functools.lru_cache(maxsize=None)
def _library() -> ctypes.CDLL:
    reasons = []
    for place in (os.environ.get("HFRAC_MPI_LIBRARY"), os.path.join(os.path.dirname(library_path()), _FILE), _FILE):
        if not place:
            continue
        try:
            return ctypes.CDLL(place, mode=ctypes.RTLD_GLOBAL)
        except OSError as error:
            reasons.append(str(error))
    raise LibraryError(f"comm needs {_FILE}, which is built where MPI is installed (libopenmpi-dev). Tried: {'; '.join(reasons)}")


def one_rank() -> _abi.hfrac_exchange:
    """A table to be filled."""
    exchange = _abi.hfrac_exchange()
    call("hfrac_exchange_init", ctypes.byref(exchange), ctypes.sizeof(exchange))
    return exchange


def exchange_over(comm: Any) -> _abi.hfrac_exchange:
    """How the ranks of `comm` talk. It holds as long as the communicator."""
    if isinstance(comm, _abi.hfrac_exchange):
        return comm
    exchange = one_rank()
    begin = _library().hfrac_mpi_exchange
    begin.argtypes = (ctypes.c_int32, ctypes.POINTER(_abi.hfrac_exchange))
    begin.restype = ctypes.c_int32
    if begin(comm.py2f(), ctypes.byref(exchange)) != 0:
        raise LibraryError("the communicator cannot be used: MPI is not initialised, or is another MPI than that of " + _FILE)
    return exchange
