# SPDX-License-Identifier: BSD-3-Clause
"""What discs, bonds, pipes, domains and joints of a simulation have in common."""
from typing import TYPE_CHECKING, Any

from ._arrays import Array

if TYPE_CHECKING:
    from ._fields import FieldInfo
    from ._simulation import Simulation

__all__ = ["Array", "FieldGroup", "field_of"]


def field_of(info: "FieldInfo") -> Any:
    """A property that copies this field as it is now."""
    shape = f"(n, {info.components})" if info.components > 1 else "(n,)"
    return property(lambda group: group._simulation.field(info.name), doc=f"[{info.unit}] {info.help}; shape {shape}")


class FieldGroup:
    """The fields of one place."""

    def __init__(self, simulation: "Simulation") -> None:
        self._simulation = simulation

    def __repr__(self) -> str:
        names = [name for name, value in vars(type(self)).items() if isinstance(value, property)]
        return f"<hfrac.{type(self).__name__}: {', '.join(names)}>"
