# SPDX-License-Identifier: BSD-3-Clause
"""Fields without a copy."""
from typing import TYPE_CHECKING, Any, Iterator

from ._arrays import Array
from ._fields import FieldInfo
from .errors import StaleViewError

if TYPE_CHECKING:
    from ._simulation import Simulation


class View:
    """A field in the library's own memory, read-only, valid until the simulation changes.

    Every access asks whether it still is, and raises StaleViewError if not. ``array`` is the bare array (numpy's, or
    a memoryview): it is not watched any more once taken, so use it before the next step. It can never point to
    freed memory, since the simulation's memory is kept as long as the array is.
    """

    def __init__(self, simulation: "Simulation", info: FieldInfo, array: Array, epoch: int) -> None:
        self._simulation = simulation
        self._array = array
        self.info = info
        #: epoch of the simulation for which the view holds
        self.epoch = epoch

    @property
    def stale(self) -> bool:
        """Whether the simulation has changed or was closed since."""
        return self._simulation.closed or self._simulation.epoch != self.epoch

    @property
    def array(self) -> Array:
        """The bare array."""
        if self.stale:
            name = self.info.name
            raise StaleViewError(f"the view of {name} is stale: the simulation has changed since; take a new one")
        return self._array

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        array = self.array
        if dtype is not None and dtype != array.dtype:
            return array.astype(dtype)
        return array.copy() if copy else array

    def __len__(self) -> int:
        return len(self.array)

    def __getitem__(self, index: Any) -> Any:
        array = self.array
        if isinstance(array, memoryview) and array.ndim > 1 and isinstance(index, int):
            return tuple(array[index, k] for k in range(array.shape[1]))
        return array[index]

    def __iter__(self) -> Iterator[Any]:
        return (self[index] for index in range(len(self)))

    def __repr__(self) -> str:
        state = "stale" if self.stale else f"{len(self)} items"
        return f"<hfrac.View of {self.info.name} [{self.info.unit}]: {state}>"
