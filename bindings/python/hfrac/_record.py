# SPDX-License-Identifier: BSD-3-Clause
"""A struct's values as a named tuple, by what its members are declared to be."""
import ctypes
import enum
from typing import Any, Callable, TypeVar

Record = TypeVar("Record")


def _value(kind: Any, value: Any) -> Any:
    if isinstance(kind, type) and issubclass(kind, enum.Enum):
        return kind(value)
    if isinstance(value, bytes):
        return value.decode()
    return tuple(value) if isinstance(value, ctypes.Array) else value


def filled(record: Callable[..., Record], struct: ctypes.Structure) -> Record:
    """Enums by their number, texts decoded, arrays as tuples."""
    members = record.__annotations__
    return record(**{name: _value(kind, getattr(struct, name)) for name, kind in members.items()})
