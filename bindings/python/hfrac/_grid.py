# SPDX-License-Identifier: BSD-3-Clause
"""A reservoir simulator's grid over the model: what its cells read, and what they put in."""
import ctypes
import os
from typing import TYPE_CHECKING, Any, Optional, Sequence, Tuple, Union

from . import _abi, _arrays
from ._arrays import Array

if TYPE_CHECKING:
    from ._simulation import Simulation

Numbers = Union[Array, Sequence[Any]]


def flat(values: Any, name: str) -> Any:
    """Numbers of any nesting as a ctypes array, last index fastest."""

    def walk(item: Any) -> Any:
        if hasattr(item, "__len__") and not isinstance(item, (str, bytes)):
            for part in item:
                yield from walk(part)
        else:
            yield float(item)

    try:
        if _arrays.numpy is not None:
            plain = _arrays.numpy.asarray(values, dtype=_arrays.numpy.float64).ravel().tolist()
        else:
            plain = list(walk(values))
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name} must be numbers") from error
    return (ctypes.c_double * len(plain))(*plain)


class Grid:
    """A grid laid over a simulation. Arrays have the shape (ny, nx): i runs fastest, as in Eclipse.

        grid = sim.set_grid(nx=10, ny=10, origin=(-200, -200), size=(50, 50))
        cells = grid.cells()
        cells.permeability[..., 0]     # m2, kxx of the cracks
    """

    def __init__(self, simulation: "Simulation", nx: int, ny: int) -> None:
        self._simulation = simulation
        #: cells along i and along j
        self.nx, self.ny = nx, ny

    @property
    def shape(self) -> Tuple[int, int]:
        """(ny, nx), that of the arrays."""
        return self.ny, self.nx

    def cells(self, method: Union[_abi.Upscaling, int] = _abi.Upscaling.FLOW) -> Any:
        """Every cell as it is now: a numpy record array of shape (ny, nx), or a flat ctypes array without numpy; either
        way with the members of hfrac_cell: area, coverage, permeability (xx, yy, xy), matrix_permeability,
        fracture_porosity, matrix_porosity, crack_length, leak_off, outflow, pressure, fracture_pressure, crack_count."""
        count = ctypes.c_int64()
        head = (int(method), ctypes.sizeof(_abi.hfrac_cell))
        records, address = _arrays.new_records(_abi.hfrac_cell, self.nx * self.ny)
        self._simulation._call("hfrac_grid_cells", *head, address, self.nx * self.ny, ctypes.byref(count))
        return records.reshape(self.shape) if _arrays.numpy is not None else records

    def set_boundary_pressure(self, pressure: Optional[Numbers]) -> None:
        """From the next step on, pressure [Pa] beyond the model's edge, by cell; it stays until it is set anew or, by None,
        taken back: the formation's again."""
        values = flat(() if pressure is None else pressure, "pressure")
        self._simulation._call("hfrac_set_boundary_pressure", values, len(values))

    def set_cell_pressure(self, pressure: Numbers) -> Array:
        """At once, gives the rock's pores the host's pressure [Pa]. The fluid [m2] that each cell gave."""
        values = flat(pressure, "pressure")
        added, address = _arrays.new_array("double", len(values), 1)
        self._simulation._call("hfrac_set_cell_pressure", values, len(values), address, len(values))
        return added.reshape(self.shape) if _arrays.numpy is not None else added

    def set_cell_stress(self, stress: Numbers) -> None:
        """From the next step on, stress [Pa] on top of the far field: xx, yy, xy of each cell, shape (ny, nx, 3)."""
        values = flat(stress, "stress")
        self._simulation._call("hfrac_set_cell_stress", values, len(values))

    def set_temperature(self, temperature: Numbers) -> None:
        """Gives the discs of each cell the host's temperature [K]; the rock answers in the next step."""
        values = flat(temperature, "temperature")
        self._simulation._call("hfrac_set_cell_temperature", values, len(values))

    @property
    def temperature(self) -> Array:
        """[K] of the rock, mean of the discs of each cell, shape (ny, nx)"""
        count = ctypes.c_int64()
        values, address = _arrays.new_array("double", self.nx * self.ny, 1)
        self._simulation._call("hfrac_get_cell_temperature", address, self.nx * self.ny, ctypes.byref(count))
        return values.reshape(self.shape) if _arrays.numpy is not None else values

    def write_grdecl(
        self,
        path: Union[str, "os.PathLike[str]"],
        *,
        method: Union[_abi.Upscaling, int] = _abi.Upscaling.FLOW,
        kind: Union[_abi.GrdeclKind, int] = _abi.GrdeclKind.PERM,
        layers: int = 1,
        porosity: float = 0.0,
        permeability: float = 0.0,
    ) -> None:
        """Writes an Eclipse include file for the GRID section. `porosity` and `permeability` [m2] are the host's own of the
        rock; 0: the network's."""
        self._simulation._call(
            "hfrac_write_grdecl", os.fsencode(path), int(method), int(kind), layers, porosity, permeability
        )

    def __repr__(self) -> str:
        return f"<hfrac.Grid: {self.nx} x {self.ny} cells>"


def lay(
    simulation: "Simulation",
    nx: int,
    ny: int,
    origin: Sequence[float],
    size: Optional[Sequence[float]],
    angle: float,
    corners: Optional[Numbers],
) -> Grid:
    """Sets the grid of a simulation: regular cells of `size`, or `corners`."""
    if (size is None) == (corners is None):
        raise TypeError("a grid takes either size or corners")
    struct = _abi.hfrac_grid(struct_size=ctypes.sizeof(_abi.hfrac_grid), nx=nx, ny=ny, angle=angle)
    struct.origin[:] = list(origin)
    if size is not None:
        struct.dx, struct.dy = size
    else:
        numbers = flat(corners, "corners")
        if len(numbers) != 8 * nx * ny:
            raise TypeError(f"corners has {len(numbers)} numbers; {nx} x {ny} cells take {8 * nx * ny}")
        struct.corners = ctypes.addressof(numbers)
    simulation._call("hfrac_set_grid", ctypes.byref(struct))
    return Grid(simulation, nx, ny)
