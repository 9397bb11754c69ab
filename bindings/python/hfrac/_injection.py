# SPDX-License-Identifier: BSD-3-Clause
"""Injection records of a field: time, rate and pressure, in whatever units their table says, as SI units."""
import ctypes
import os
from typing import List, NamedTuple, Union

from ._library import call


class InjectionRow(NamedTuple):
    """One row; it holds until the next."""

    #: [s]
    time: float
    #: [m2/s], NaN if the file has none
    rate: float
    #: [Pa], NaN if the file has none
    pressure: float


def read_record(path: Union[str, "os.PathLike[str]"], thickness: float = 1.0) -> List[InjectionRow]:
    """The rows of a record; rates of the whole thickness are divided by `thickness` [m]. The columns are those of record.h."""
    count = ctypes.c_int64()
    call("hfrac_read_record", os.fsencode(path), thickness, None, 0, ctypes.byref(count))
    rows = (ctypes.c_double * (3 * count.value))()
    call("hfrac_read_record", os.fsencode(path), thickness, ctypes.addressof(rows), count.value, ctypes.byref(count))
    return [InjectionRow(*rows[3 * k : 3 * k + 3]) for k in range(min(count.value, len(rows) // 3))]
