# SPDX-License-Identifier: BSD-3-Clause
"""Memory for fields and records: numpy arrays if numpy is there, otherwise ctypes arrays.

Both are indexed the same way, array[i] or array[i][k], can be iterated, and offer the buffer protocol.
"""
import ctypes
from typing import Any, Tuple

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

#: A numpy array, or a ctypes array where numpy is not installed.
Array = Any

_ITEMS = {"double": ctypes.c_double, "int32": ctypes.c_int32}


def _array_type(dtype: str, count: int, components: int) -> Any:
    item = _ITEMS[dtype]
    return (item * components if components > 1 else item) * count


def new_array(dtype: str, count: int, components: int) -> Tuple[Array, int]:
    """Room for count items of some components, and its address."""
    if numpy is not None:
        shape = (count, components) if components > 1 else (count,)
        filled = numpy.empty(shape, {"double": numpy.float64, "int32": numpy.int32}[dtype])
        return filled, filled.ctypes.data
    plain = _array_type(dtype, count, components)()
    return plain, ctypes.addressof(plain)


def borrowed_array(address: int, dtype: str, count: int, components: int, owner: object) -> Array:
    """The library's own memory, read-only; `owner` lives as long as the array does."""
    plain = _array_type(dtype, count, components).from_address(address)
    plain.owner = owner
    if numpy is None:
        if not count:
            return memoryview(plain).toreadonly()  # a memoryview of nothing cannot be cast
        flat = memoryview(plain).cast("B").cast({"double": "d", "int32": "i"}[dtype]).toreadonly()
        return flat.cast("B").cast(flat.format, (count, components)) if components > 1 else flat
    shared = numpy.asarray(plain)
    shared.flags.writeable = False
    return shared


def new_records(struct: Any, count: int) -> Tuple[Any, int]:
    """Room for structs: a numpy record array, whose columns and rows have attributes, or a ctypes array."""
    if numpy is not None:
        records = numpy.empty(count, numpy.dtype(struct)).view(numpy.recarray)
        return records, records.ctypes.data
    plain = (struct * count)()
    return plain, ctypes.addressof(plain)
