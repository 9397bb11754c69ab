# SPDX-License-Identifier: BSD-3-Clause
"""hfrac behind the Basic Model Interface (BMI 2.0, https://bmi.csdms.io), for frameworks that speak it.

    from hfrac.bmi import BmiHfrac

    model = BmiHfrac()
    model.initialize("case.toml")
    model.update_until(0.1)
    pressure = numpy.empty(model.get_grid_face_count(0))
    model.get_value("rock_pore_fluid__pressure", pressure)
    model.finalize()

The configuration file is a case file. SI units, unit thickness. Variables, units and grids are those of the C face
(bindings/bmi); see there. Grid 0 is the rock, unstructured: discs are its nodes, bonds its edges, domains its faces; grid 1
is one value for the model; grid 2 the wells; grid 3, once set_grid has laid it, a framework's cells. Needs numpy.
"""
from typing import Any, Callable, Dict, NamedTuple, Optional, Tuple

import numpy

from ._abi import Upscaling
from ._grid import Grid
from ._simulation import Simulation

NODE, EDGE, FACE, WELL, MODEL, CELL = "node", "edge", "face", "well", "model", "cell"
_ROCK_GRID, _MODEL_GRID, _WELL_GRID, _CELL_GRID = 0, 1, 2, 3
_BOUNDARY_PRESSURE = "cell_boundary_fluid__pressure"


class _Variable(NamedTuple):
    units: str
    place: str
    get: Callable[[Simulation], Any]
    set: Optional[Callable[[Simulation, int, float], None]] = None
    type: str = "double"


def _field(name: str, component: Optional[int] = None) -> Callable[[Simulation], Any]:
    def get(sim: Simulation) -> Any:
        values = sim.field(name)
        return values if component is None else values[:, component]

    return get


def _inside(name: str) -> Callable[[Simulation], Any]:
    """Of domains, without the outside, which is no face."""
    return lambda sim: sim.field(name)[1:]


def _wells(name: str) -> Callable[[Simulation], Any]:
    return lambda sim: [getattr(well.state, name) for well in sim.wells]


def _largest(name: str) -> Callable[[Simulation], Any]:
    def get(sim: Simulation) -> Any:
        fractures = sim.fractures
        return [getattr(fractures[0], name) if fractures else 0.0]

    return get


_VARIABLES: Dict[str, _Variable] = {
    "rock_disc__radius": _Variable("m", NODE, _field("disc.radius")),
    "rock_disc__x_component_of_displacement": _Variable("m", NODE, _field("disc.displacement", 0)),
    "rock_disc__y_component_of_displacement": _Variable("m", NODE, _field("disc.displacement", 1)),
    "rock_disc__rotation_angle": _Variable("radian", NODE, _field("disc.rotation")),
    "rock__xx_component_of_stress": _Variable("Pa", NODE, _field("disc.stress", 0)),
    "rock__yy_component_of_stress": _Variable("Pa", NODE, _field("disc.stress", 1)),
    "rock__xy_component_of_stress": _Variable("Pa", NODE, _field("disc.stress", 2)),
    "rock_bond__state": _Variable("1", EDGE, _field("bond.state"), type="int32"),
    "rock_bond__normal_force_per_thickness": _Variable("N m-1", EDGE, _field("bond.normal_force")),
    "rock_pipe__hydraulic_aperture": _Variable("m", EDGE, _field("pipe.aperture")),
    "rock_pipe_fluid__volume_flow_rate_per_thickness": _Variable("m2 s-1", EDGE, _field("pipe.flow")),
    "rock_pore_fluid__pressure": _Variable("Pa", FACE, _inside("domain.pressure")),
    "rock_pore_fluid__volume_per_thickness": _Variable("m2", FACE, _inside("domain.volume")),
    "well_fluid__pressure": _Variable(
        "Pa", WELL, _wells("pressure"), lambda sim, well, value: sim.wells[well].set_pressure(value)
    ),
    "well_fluid__injection_rate_per_thickness": _Variable(
        "m2 s-1", WELL, _wells("rate"), lambda sim, well, value: sim.wells[well].set_rate(value)
    ),
    "well_fluid__injected_volume_per_thickness": _Variable("m2", WELL, _wells("injected_volume")),
    "rock__maximum_horizontal_stress": _Variable(
        "Pa",
        MODEL,
        lambda sim: [sim.state.sigma_Hmax],
        lambda sim, _, value: sim.set_far_field(value, sim.state.sigma_hmin),
    ),
    "rock__minimum_horizontal_stress": _Variable(
        "Pa",
        MODEL,
        lambda sim: [sim.state.sigma_hmin],
        lambda sim, _, value: sim.set_far_field(sim.state.sigma_Hmax, value),
    ),
    "rock_formation_fluid__pressure": _Variable(
        "Pa",
        MODEL,
        lambda sim: [sim.state.formation_pressure],
        lambda sim, _, value: sim.set_formation_pressure(value),
    ),
    "rock_crack__count": _Variable("1", MODEL, lambda sim: [sim.crack_count], type="int64"),
    "rock_fracture__length": _Variable("m", MODEL, _largest("length")),
    "rock_fracture__largest_aperture": _Variable("m", MODEL, _largest("largest_aperture")),
    "rock_fracture__volume_per_thickness": _Variable("m2", MODEL, _largest("volume")),
    "rock_boundary_fluid__leaked_volume_per_thickness": _Variable("m2", MODEL, lambda sim: [sim.balance.leaked_volume]),
}

#: Variables of cells: units, member of hfrac_cell, component.
_CELL_VARIABLES: Dict[str, Tuple[str, str, Optional[int]]] = {
    _BOUNDARY_PRESSURE: ("Pa", "", None),
    "cell_boundary_fluid__outflow_rate_per_thickness": ("m2 s-1", "outflow", None),
    "cell_boundary_fluid__conductance_per_thickness": ("m2 Pa-1 s-1", "conductance", None),
    "cell_rock_fluid__leak-off_rate_per_thickness": ("m2 s-1", "leak_off", None),
    "cell_rock_fluid__pressure": ("Pa", "pressure", None),
    "cell_rock_fracture_fluid__pressure": ("Pa", "fracture_pressure", None),
    "cell_rock_fracture__xx_component_of_permeability": ("m2", "permeability", 0),
    "cell_rock_fracture__yy_component_of_permeability": ("m2", "permeability", 1),
    "cell_rock_fracture__xy_component_of_permeability": ("m2", "permeability", 2),
    "cell_rock_matrix__permeability": ("m2", "matrix_permeability", None),
}
_VARIABLES.update({name: _Variable(units, CELL, lambda sim: None) for name, (units, _, _) in _CELL_VARIABLES.items()})

Array = Any


class BmiHfrac:
    """A model for a BMI framework; each is independent of the others."""

    def __init__(self) -> None:
        self._sim: Optional[Simulation] = None
        self._step = 0.0
        self._end = 0.0
        self._shared: Dict[str, Array] = {}
        self._grid: Optional[Grid] = None
        self._lattice: Tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)  # origin x, y; spacing x, y
        self._boundary: Array = numpy.empty(0)

    def _model(self) -> Simulation:
        if self._sim is None:
            raise RuntimeError("the model is not initialized; call initialize first")
        return self._sim

    def _variable(self, name: str) -> _Variable:
        if name not in self._names():
            raise KeyError(f"the model has no variable {name}; there are: {', '.join(self._names())}")
        return _VARIABLES[name]

    def _names(self) -> Tuple[str, ...]:
        wells = bool(self._model().wells)
        there = {WELL: wells, CELL: self._grid is not None}
        return tuple(name for name, row in _VARIABLES.items() if there.get(row.place, True))

    def _of_cells(self, name: str) -> Array:
        if name == _BOUNDARY_PRESSURE or self._grid is None:
            return self._boundary
        _, member, component = _CELL_VARIABLES[name]
        # The tensor of the flow is dear, all else is the same by either way.
        method = Upscaling.FLOW if "permeability" in member else Upscaling.ODA
        values = self._grid.cells(method)[member]
        return (values if component is None else values[..., component]).ravel()

    def _values(self, name: str) -> Array:
        row = self._variable(name)
        if row.place == CELL:
            return numpy.ascontiguousarray(self._of_cells(name), dtype=row.type)
        return numpy.ascontiguousarray(row.get(self._model()), dtype=row.type)

    def _renew(self) -> None:
        for name, array in self._shared.items():
            array[:] = self._values(name)

    # Initialize, run, finalize

    def initialize(self, config_file: str) -> None:
        """Builds the model of a case file."""
        if self._sim is not None:
            raise RuntimeError("the model is initialized already; call finalize first")
        sim = Simulation(config_file)
        definition = sim.definition
        self._step = float(definition.get("stepping.flow_step"))
        end = float(definition.get("stepping.end_time"))
        self._end = end if end > 0.0 else self._step * float(definition.get("stepping.steps"))
        self._sim = sim

    def update(self) -> None:
        """Takes one step."""
        self._model().step()
        self._renew()

    def update_until(self, time: float) -> None:
        """Takes as many steps as fit, and a shorter one to end at `time` [s]."""
        sim, now = self._model(), self._model().time
        if not now <= time < 1e300:
            raise ValueError(f"the time {time} s lies behind {now} s, or is no number")
        # Rounding of added steps must neither cost one more nor leave a splinter of one.
        whole = int((time - now) / self._step + 1e-6)
        sim.step(whole)
        rest = time - (now + whole * self._step)
        if rest > 1e-6 * self._step:
            with sim.open_step() as step:
                step.do(rest)
        self._renew()

    def finalize(self) -> None:
        """Ends the model; initialize may build another."""
        if self._sim is not None:
            self._sim.close()
        self._sim = None
        self._shared = {}
        self._grid = None

    def set_grid(self, nx: int, ny: int, origin: Tuple[float, float], spacing: Tuple[float, float]) -> None:
        """Lays cells over the model, beside the BMI: first corner at `origin` (x, y) [m], each `spacing` (dx, dy) [m]
        large. From then on there is grid 3, and variables "cell_..."; arrays of earlier cells follow no more."""
        self._grid = self._model().set_grid(nx=nx, ny=ny, origin=origin, size=spacing)
        self._lattice = (*origin, *spacing)
        self._boundary = numpy.full(nx * ny, self._model().state.formation_pressure)
        self._shared = {name: array for name, array in self._shared.items() if _VARIABLES[name].place != CELL}

    # Exchange items

    def get_component_name(self) -> str:
        """Name of the model."""
        return "hfrac"

    def get_input_item_count(self) -> int:
        """Number of variables that can be set."""
        return len(self.get_input_var_names())

    def get_output_item_count(self) -> int:
        """Number of variables that can be read."""
        return len(self.get_output_var_names())

    def get_input_var_names(self) -> Tuple[str, ...]:
        """Variables that can be set."""
        return tuple(name for name in self._names() if _VARIABLES[name].set is not None or name == _BOUNDARY_PRESSURE)

    def get_output_var_names(self) -> Tuple[str, ...]:
        """Variables that can be read."""
        return self._names()

    # Variables

    def get_var_grid(self, name: str) -> int:
        """Grid of a variable."""
        return {WELL: _WELL_GRID, MODEL: _MODEL_GRID, CELL: _CELL_GRID}.get(self._variable(name).place, _ROCK_GRID)

    def get_var_type(self, name: str) -> str:
        """Type of a variable's values, as numpy names it."""
        return self._variable(name).type

    def get_var_units(self, name: str) -> str:
        """SI units of a variable."""
        return self._variable(name).units

    def get_var_itemsize(self, name: str) -> int:
        """Bytes of one value."""
        return numpy.dtype(self._variable(name).type).itemsize

    def get_var_nbytes(self, name: str) -> int:
        """Bytes of all values."""
        return int(self._values(name).nbytes)

    def get_var_location(self, name: str) -> str:
        """Where on its grid a variable lives: node, edge, face or none."""
        return {WELL: "node", CELL: "node", MODEL: "none"}.get(self._variable(name).place, self._variable(name).place)

    # Time

    def get_current_time(self) -> float:
        """[s] model time"""
        return self._model().time

    def get_start_time(self) -> float:
        """[s]"""
        self._model()
        return 0.0

    def get_end_time(self) -> float:
        """[s] of the case: stepping.end_time, or its steps"""
        self._model()
        return self._end

    def get_time_units(self) -> str:
        """Units of all times."""
        return "s"

    def get_time_step(self) -> float:
        """[s] of one update"""
        self._model()
        return self._step

    # Getters and setters

    def get_value(self, name: str, dest: Array) -> Array:
        """Copies all values into `dest`, a flat array, and returns it."""
        dest[:] = self._values(name)
        return dest

    def get_value_ptr(self, name: str) -> Array:
        """An array that follows every update and every set_value until finalize; not to be written to."""
        if name not in self._shared:
            self._shared[name] = self._values(name).copy()
        view = self._shared[name].view()
        view.flags.writeable = False
        return view

    def get_value_at_indices(self, name: str, dest: Array, inds: Array) -> Array:
        """Copies the values at `inds` into `dest` and returns it."""
        dest[:] = self._values(name)[self._checked(name, inds)]
        return dest

    def _checked(self, name: str, inds: Array) -> Array:
        indices = numpy.asarray(inds)
        size = self._values(name).size
        if indices.size and (indices.min() < 0 or indices.max() >= size):
            raise IndexError(f"an index is outside the {size} values of {name}")
        return indices

    def set_value(self, name: str, src: Array) -> None:
        """Sets all values."""
        self.set_value_at_indices(name, numpy.arange(self._values(name).size), src)

    def set_value_at_indices(self, name: str, inds: Array, src: Array) -> None:
        """Sets the values at `inds`."""
        row = self._variable(name)
        if row.set is None and name != _BOUNDARY_PRESSURE:
            raise ValueError(f"{name} is an output; what can be set: {', '.join(self.get_input_var_names())}")
        indices, values = self._checked(name, inds), numpy.asarray(src, dtype=float)
        if values.shape != indices.shape:
            raise ValueError(f"{values.size} values for {indices.size} places of {name}")
        if name == _BOUNDARY_PRESSURE and self._grid is not None:
            wanted = self._boundary.copy()
            wanted[indices] = values
            self._grid.set_boundary_pressure(wanted)
            self._boundary = wanted
        for index, value in zip(indices.tolist(), values.tolist()) if row.set is not None else ():
            row.set(self._model(), index, value)
        self._renew()

    # Grids

    def _rock(self, grid: int) -> bool:
        """Whether it is the rock's grid; refuses what is no grid."""
        there = {_WELL_GRID: bool(self._model().wells), _CELL_GRID: self._grid is not None, _ROCK_GRID: True, _MODEL_GRID: True}
        if not there.get(grid, False):
            raise KeyError(f"the model has no grid {grid}")
        return grid == _ROCK_GRID

    def get_grid_rank(self, grid: int) -> int:
        """Number of dimensions."""
        self._rock(grid)
        return 0 if grid == _MODEL_GRID else 2

    def get_grid_size(self, grid: int) -> int:
        """Number of nodes."""
        return self.get_grid_node_count(grid)

    def get_grid_type(self, grid: int) -> str:
        """BMI's name for the kind of grid."""
        self._rock(grid)
        return {_MODEL_GRID: "scalar", _CELL_GRID: "uniform_rectilinear"}.get(grid, "unstructured")

    def _cells(self, grid: int) -> Grid:
        if grid != _CELL_GRID or self._grid is None:
            raise NotImplementedError("this grid is no lattice; see get_grid_type")
        return self._grid

    def get_grid_shape(self, grid: int, shape: Array) -> Array:
        """Nodes, the middles of cells, along y and x; of cells only."""
        shape[:] = self._cells(grid).shape
        return shape

    def get_grid_spacing(self, grid: int, spacing: Array) -> Array:
        """[m] from node to node along y and x; of cells only."""
        self._cells(grid)
        spacing[:] = self._lattice[3], self._lattice[2]
        return spacing

    def get_grid_origin(self, grid: int, origin: Array) -> Array:
        """[m] y and x of the first node; of cells only."""
        self._cells(grid)
        x, y, dx, dy = self._lattice
        origin[:] = y + 0.5 * dy, x + 0.5 * dx
        return origin

    def _coordinates(self, grid: int, axis: int, to: Array) -> Array:
        sim = self._model()
        if self._rock(grid):
            to[:] = sim.field("disc.position")[:, axis]
        elif grid == _WELL_GRID:
            to[:] = [(well.state.x, well.state.y)[axis] for well in sim.wells]
        elif grid == _CELL_GRID:
            cells = self._cells(grid)
            to[:] = self._lattice[axis] + (numpy.arange((cells.nx, cells.ny)[axis]) + 0.5) * self._lattice[2 + axis]
        else:
            raise NotImplementedError("one value for the model has no coordinates")
        return to

    def get_grid_x(self, grid: int, x: Array) -> Array:
        """[m] x of all nodes, now"""
        return self._coordinates(grid, 0, x)

    def get_grid_y(self, grid: int, y: Array) -> Array:
        """[m] y of all nodes, now"""
        return self._coordinates(grid, 1, y)

    def get_grid_z(self, grid: int, z: Array) -> Array:
        """Of models in three dimensions only."""
        raise NotImplementedError("the model is two-dimensional: there is no z")

    def get_grid_node_count(self, grid: int) -> int:
        """Discs, or wells."""
        sim = self._model()
        if self._rock(grid):
            return sim.state.disc_count
        if grid == _CELL_GRID and self._grid is not None:
            return self._grid.nx * self._grid.ny
        return len(sim.wells) if grid == _WELL_GRID else 1

    def get_grid_edge_count(self, grid: int) -> int:
        """Bonds, intact and broken."""
        return self._model().state.bond_count if self._rock(grid) else 0

    def get_grid_face_count(self, grid: int) -> int:
        """Domains, the outside not counted."""
        return self._model().state.domain_count - 1 if self._rock(grid) else 0

    def get_grid_edge_nodes(self, grid: int, edge_nodes: Array) -> Array:
        """The two discs of each bond."""
        if self._rock(grid):
            edge_nodes[:] = self._model().field("bond.discs").ravel()
        return edge_nodes

    def _faces(self) -> Tuple[Array, Array]:
        """Corners of all faces one after the other, and where each face begins, with the end."""
        sim = self._model()
        start, corners = sim.field("domain.corner_offset"), sim.field("domain.corners")
        starts = numpy.append(start, corners.size)[1:]
        return corners[starts[0] :], starts - starts[0]

    def get_grid_face_nodes(self, grid: int, face_nodes: Array) -> Array:
        """Discs around each face in order."""
        if self._rock(grid):
            face_nodes[:] = self._faces()[0]
        return face_nodes

    def get_grid_face_edges(self, grid: int, face_edges: Array) -> Array:
        """Bonds around each face, the first between its first two discs."""
        if self._rock(grid):
            corners, starts = self._faces()
            following = numpy.roll(corners, -1)
            following[starts[1:] - 1] = corners[starts[:-1]]
            discs = self._model().field("bond.discs").astype(numpy.int64)
            count = self._model().state.disc_count
            keys = discs.min(axis=1) * count + discs.max(axis=1)
            order = numpy.argsort(keys)
            wanted = numpy.minimum(corners, following).astype(numpy.int64) * count + numpy.maximum(corners, following)
            face_edges[:] = order[numpy.searchsorted(keys, wanted, sorter=order)]
        return face_edges

    def get_grid_nodes_per_face(self, grid: int, nodes_per_face: Array) -> Array:
        """Discs around each face."""
        if self._rock(grid):
            nodes_per_face[:] = numpy.diff(self._faces()[1])
        return nodes_per_face
