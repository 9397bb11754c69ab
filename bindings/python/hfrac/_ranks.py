# SPDX-License-Identifier: BSD-3-Clause
"""One simulation over the ranks of a communicator of mpi4py, or of whatever else has py2f()."""
import ctypes
import functools
import os
from typing import Any

from . import _abi
from ._library import call, library_path
from .errors import LibraryError


@functools.lru_cache(maxsize=None)
def _library(part: str, needs: str) -> ctypes.CDLL:
    """libhfrac_mpi or libhfrac_petsc."""
    reasons = []
    file = f"libhfrac_{part}.so.{_abi.ABI_VERSION}"
    for place in (os.environ.get(f"HFRAC_{part.upper()}_LIBRARY"), os.path.join(os.path.dirname(library_path()), file), file):
        if not place:
            continue
        try:
            return ctypes.CDLL(place, mode=ctypes.RTLD_GLOBAL)
        except OSError as error:
            reasons.append(str(error))
    raise LibraryError(f"this needs {file}, which is built where {needs} is installed. Tried: {'; '.join(reasons)}")


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
    begin = _library("mpi", "MPI (libopenmpi-dev)").hfrac_mpi_exchange
    begin.argtypes = (ctypes.c_int32, ctypes.POINTER(_abi.hfrac_exchange))
    begin.restype = ctypes.c_int32
    if begin(comm.py2f(), ctypes.byref(exchange)) != 0:
        raise LibraryError("the communicator cannot be used: MPI is not initialised, or is another MPI than that of libhfrac_mpi")
    return exchange


def give_petsc(comm: Any, exchange: _abi.hfrac_exchange) -> Any:
    """PETSc as the solver of the ranks of `comm`. What is returned has to live until a simulation has been made with the table."""
    solver = _abi.hfrac_linear_solver()
    begin = _library("petsc", "PETSc (petsc-dev)").hfrac_petsc_solver
    begin.argtypes = (ctypes.c_int32, ctypes.POINTER(_abi.hfrac_linear_solver))
    begin.restype = ctypes.c_int32
    if begin(comm.py2f(), ctypes.byref(solver)) != 0:
        raise LibraryError("PETSc cannot be used: it could not be initialised, or it is of another MPI than the communicator")
    exchange.linear_solver = ctypes.addressof(solver)
    return solver
