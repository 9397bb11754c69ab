# SPDX-License-Identifier: BSD-3-Clause
"""A simulation: create, step, read, close."""
import ctypes
import os
import threading
import weakref
from typing import Any, Callable, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _abi, _arrays, _grid, _picture
from ._arrays import Array
from ._catalogue import Rule
from ._definition import Definition, PathLike, Value
from ._fields import FIELDS, Bonds, Discs, Domains, FieldInfo, Joints, Pipes
from ._library import call, load
from ._open_step import OpenStep
from ._progress import LogFunction, Progress, ProgressFunction
from ._ranks import exchange_over, give_petsc
from ._records import Balance, Crack, Event, Fracture, FracturePoint, Heat, SetupReport, SimState, Slip, SolverReport, StepLimits, Traffic, WallState
from ._view import View
from ._well import Well
from .errors import BadHandleError, HfracError, StoppedError, UnknownKeyError

#: Wall time [s] between two looks at progress and Ctrl-C.
_LOOK_EVERY = 0.1

_INFO = {field.name: field for field in FIELDS}


class Advance(NamedTuple):
    """How far an advance came."""

    #: [s] model time reached
    time: float
    reason: _abi.StopReason
    status: _abi.Status


class _Handle:
    """Owns a simulation of the library, which ends when nothing refers to this any more: no view, no running call."""

    def __init__(self, pointer: ctypes.c_void_p) -> None:
        self.pointer = pointer
        weakref.finalize(self, load().hfrac_sim_destroy, ctypes.byref(pointer))


class Simulation:
    """A model, its state and its clock.

    ``case`` is a case file or a Definition; wells, joints, schedule, title, discs, bonds and
    options are as for Definition and come on top.
    ``progress(fraction, what)`` is called while the model is built and while it runs; a true result stops.
    ``log(level, message)`` is told what happens, from the start on.
    ``comm``, a communicator of mpi4py or a table of one's own (``hfrac_exchange``), makes one simulation of those of all its ranks, which then make the same calls;
    results are those of one, to the last bit; with ``flow.solver`` or ``solver.factor`` "petsc" to a tolerance.

    Close it with ``with`` or ``close()``, or leave it to the garbage collector. Arrays handed out are copies, except
    for ``view``. Calls of several threads wait for one another.
    """

    def __init__(
        self,
        case: Union[PathLike, Definition, None] = None,
        *,
        wells: Sequence[Mapping[str, Value]] = (),
        joints: Sequence[Mapping[str, Value]] = (),
        schedule: Sequence[Mapping[str, Value]] = (),
        title: Optional[str] = None,
        discs: Optional[Iterable[Sequence[float]]] = None,
        bonds: Optional[Iterable[Sequence[int]]] = None,
        progress: Optional[ProgressFunction] = None,
        log: Optional[LogFunction] = None,
        comm: Any = None,
        **options: Any,
    ) -> None:
        self._handle: Optional[_Handle] = None
        self._lock = threading.RLock()
        self._progress = Progress(progress)
        definition = case.copy() if isinstance(case, Definition) else Definition(case)
        definition.update(wells=wells, joints=joints, schedule=schedule, title=title, discs=discs, bonds=bonds, **options)
        definition._struct.progress = self._progress.callback
        if log is not None:
            self._progress.log_function = log
            definition._struct.log = self._progress.log_callback
            definition._struct.log_level = _abi.LogLevel.INFO
        pointer = ctypes.c_void_p()
        with self._lock, self._progress.watched():
            if comm is None:
                status = call("hfrac_sim_create", ctypes.byref(definition._struct), ctypes.byref(pointer))
            else:
                self._exchange = exchange_over(comm)
                if hasattr(comm, "py2f") and "petsc" in (definition.get("flow.solver"), definition.get("solver.factor")):
                    self._solver = give_petsc(comm, self._exchange)
                status = call("hfrac_sim_create_on", ctypes.byref(definition._struct), ctypes.byref(self._exchange), ctypes.byref(pointer))
            if pointer:
                self._handle = _Handle(pointer)
        if status == _abi.Status.STOPPED:
            raise StoppedError("the progress function stopped the building of the simulation")
        self._title = definition.title
        self.on_progress(progress)
        if log is not None:
            self.on_log(log)

    def _call(self, function: str, *arguments: Any) -> _abi.Status:
        handle = self._handle
        if handle is None:
            raise BadHandleError("the simulation is closed")
        with self._lock:
            status = call(function, handle.pointer, *arguments, handle=handle.pointer)
            self._progress.raise_told()
            return status

    def _read(self, function: str, kind: Any) -> Any:
        """The one value, or the one struct, that a function gives."""
        result = kind()
        if hasattr(result, "struct_size"):
            result.struct_size = ctypes.sizeof(kind)
        self._call(function, ctypes.byref(result))
        return result

    # Life

    def close(self) -> None:
        """Ends the simulation. Calling it again does nothing."""
        self._handle = None

    @property
    def closed(self) -> bool:
        """Whether it has been ended."""
        return self._handle is None

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, *unused: object) -> None:
        self.close()

    def __copy__(self) -> "Simulation":
        raise TypeError("a simulation cannot be copied")

    # Running

    def step(self, count: int = 1) -> _abi.Status:
        """Takes `count` steps. Status.STOPPED if the progress function asked for it, Status.STOP_CONDITION if
        stop.extent_fraction or stop.cracks is reached, Status.NOT_AT_REST if the last step's mechanics did not come to
        rest; all are notes, not errors."""
        with self._lock, self._progress.watched():
            return self._call("hfrac_step", count)

    def advance(self, time: float, exact: bool = False) -> Advance:
        """Steps until model time `time` [s] is reached or a stop condition holds (Status.STOP_CONDITION). With `exact`
        the last step is shortened to end at that time."""
        reached, reason = ctypes.c_double(), ctypes.c_int32()
        with self._lock, self._progress.watched():
            status = self._call("hfrac_advance_to" if exact else "hfrac_advance", time, ctypes.byref(reached), ctypes.byref(reason))
        return Advance(reached.value, _abi.StopReason(reason.value), status)

    def set_stop(self, extent_fraction: float = 1.0, cracks: int = 0) -> None:
        """Other limits than stop.extent_fraction and stop.cracks (0: none) from now on, so that a run goes on past them."""
        self._call("hfrac_set_stop", extent_fraction, cracks)

    def on_progress(self, function: Optional[ProgressFunction], seconds: float = _LOOK_EVERY) -> None:
        """Has `function` called about every `seconds` of wall time during step and advance; None: no function."""
        self._progress.function = function
        self._call("hfrac_set_progress", self._progress.callback, None, seconds)

    def on_step(self, function: Optional[Callable[["Simulation"], Optional[bool]]]) -> None:
        """Has `function(simulation)` called after every step of step and advance; a true result stops after that step,
        which is kept. It may read, not change. None: no function."""
        own = weakref.ref(self)
        self._progress.step_function = (lambda: function(own())) if function else None  # type: ignore[arg-type]
        callback = self._progress.step_callback if function else _abi.hfrac_step_fn()
        self._call("hfrac_set_on_step", callback, None)

    def on_log(self, function: Optional[LogFunction], level: _abi.LogLevel = _abi.LogLevel.INFO) -> None:
        """Has `function(level, message)` told what happens, up to `level`. None: nobody."""
        self._progress.log_function = function
        callback = self._progress.log_callback if function else _abi.hfrac_log_fn()
        self._call("hfrac_set_log", callback, None, level)

    # Going back

    def save(self) -> bytes:
        """An image of the state, for restore."""
        size = self._read("hfrac_state_size", ctypes.c_int64)
        image = ctypes.create_string_buffer(size.value)
        self._call("hfrac_state_save", image, size, ctypes.byref(size))
        return image.raw[: size.value]

    def restore(self, image: bytes) -> None:
        """Goes back to an image of this simulation; a damaged or foreign one is refused and changes nothing."""
        self._call("hfrac_state_restore", image, len(image))

    def save_file(self, path: PathLike) -> None:
        """Saves the state as a file, which is there whole or not at all."""
        self._call("hfrac_state_save_file", os.fsencode(path))

    def load_file(self, path: PathLike) -> None:
        """Goes back to a state in a file, of this simulation or one of the same definition. Anything else is refused
        and changes nothing."""
        self._call("hfrac_state_load_file", os.fsencode(path))

    def open_step(self) -> OpenStep:
        """A step that can be tried several times, and rejected. While it is open, step, advance and restore are
        refused."""
        return OpenStep(self)

    def set_far_field(self, sigma_Hmax: float, sigma_hmin: float) -> None:
        """From the next step on, another far-field stress [Pa]: sigma_Hmax along x, sigma_hmin along y."""
        self._call("hfrac_set_far_field", sigma_Hmax, sigma_hmin)

    def set_formation_pressure(self, pressure: float) -> None:
        """From the next step on, another pressure [Pa, absolute] in the pores outside the model."""
        self._call("hfrac_set_formation_pressure", pressure)

    # Temperature, in kelvin

    def set_temperature(self, temperature: float) -> None:
        """Gives rock and fluid one temperature [K]; the rock answers in the next step."""
        self._call("hfrac_set_temperature", temperature)

    def set_disc_temperature(self, temperature: _grid.Numbers) -> None:
        """Gives every disc its temperature [K], one value per disc. Needs thermal.mode "transport"."""
        values = _grid.flat(temperature, "temperature")
        self._call("hfrac_set_disc_temperature", values, len(values))

    def hold_disc_temperature(self, held: Sequence[int]) -> None:
        """Discs that keep their temperature whatever flows: one value per disc, not 0: held."""
        values = (ctypes.c_int32 * len(held))(*(1 if value else 0 for value in held))
        self._call("hfrac_hold_disc_temperature", values, len(values))

    @property
    def heat(self) -> Heat:
        """The heat balance since the end of the initial equilibration."""
        return Heat.of(self._read("hfrac_get_heat", _abi.hfrac_heat))

    # A reservoir simulator's grid

    def set_grid(
        self,
        nx: int,
        ny: int,
        *,
        origin: Sequence[float] = (0.0, 0.0),
        size: Optional[Sequence[float]] = None,
        angle: float = 0.0,
        corners: Optional[_grid.Numbers] = None,
    ) -> _grid.Grid:
        """Lays a reservoir simulator's grid over the model, in place of an earlier one: nx times ny cells of
        `size` (dx, dy) [m] from `origin` [m], turned by `angle` [rad]; or with `corners` [m], shape (ny, nx, 4, 2), the four
        of each cell in order around it."""
        return _grid.lay(self, nx, ny, origin, size, angle, corners)

    # How it stands

    @property
    def state(self) -> SimState:
        """Time, counts of discs, bonds and cracks, and how the last step ended."""
        return SimState.of(self._read("hfrac_sim_get_state", _abi.hfrac_sim_state))

    @property
    def time(self) -> float:
        """[s] model time"""
        return self.state.time

    @property
    def step_count(self) -> int:
        """Steps taken since creation."""
        return self.state.step

    @property
    def crack_count(self) -> int:
        """Bonds broken so far."""
        return self.state.crack_count

    @property
    def setup(self) -> SetupReport:
        """What the set-up made."""
        return SetupReport.of(self._read("hfrac_sim_get_setup", _abi.hfrac_setup_report))

    @property
    def balance(self) -> Balance:
        """Energy and fluid since the end of the initial equilibration."""
        return Balance.of(self._read("hfrac_get_balance", _abi.hfrac_balance))

    @property
    def solver(self) -> SolverReport:
        """What the quasi-static solver did since the initial equilibration."""
        return SolverReport.of(self._read("hfrac_sim_get_solver", _abi.hfrac_solver_report))

    @property
    def step_limits(self) -> StepLimits:
        """How long a step could be, and what limits it."""
        return StepLimits.of(self._read("hfrac_get_step_limits", _abi.hfrac_step_limits))

    @property
    def walls(self) -> List[WallState]:
        """The walls as they are now: left, right, lower, upper; none with boundary.kind "stress"."""
        found = []
        for index in range(self._read("hfrac_wall_count", ctypes.c_int32).value):
            struct = _abi.hfrac_wall_state(struct_size=ctypes.sizeof(_abi.hfrac_wall_state))
            self._call("hfrac_wall_get", index, ctypes.byref(struct))
            found.append(WallState.of(struct))
        return found

    @property
    def traffic(self) -> Traffic:
        """What this rank receives in a cycle; zeros with one rank."""
        return Traffic.of(self._read("hfrac_get_traffic", _abi.hfrac_traffic))

    @property
    def state_hash(self) -> int:
        """Equal if and only if the state is equal, bit for bit."""
        return self._read("hfrac_state_hash", ctypes.c_int64).value

    @property
    def epoch(self) -> int:
        """Raised by every call that may change the simulation."""
        return self._read("hfrac_epoch", ctypes.c_int64).value

    @property
    def definition(self) -> Definition:
        """What the simulation was built from, defaults filled in."""
        result = Definition()
        self._call("hfrac_sim_definition", ctypes.byref(result._struct))
        return result

    # Wells

    @property
    def wells(self) -> List[Well]:
        """The wells, to read and to control."""
        return [Well(self, index) for index in range(self._read("hfrac_well_count", ctypes.c_int32).value)]

    def add_well(self, x: float, y: float) -> Well:
        """A further well, at any time between two steps: the pore of the rock nearest to (x, y) [m], shut in until it is driven. It
        belongs to the state: an image brings it back, one from before takes it away."""
        index = ctypes.c_int32()
        self._call("hfrac_well_add", x, y, ctypes.byref(index))
        return Well(self, index.value)

    # Cracks and fractures

    @property
    def cracks(self) -> Any:
        """All cracks in order of breakage: a numpy record array, or a list of Crack; either way crack.aperture and so
        on."""
        return self.cracks_since(0)[0]

    def cracks_since(self, cursor: int) -> Tuple[Any, int]:
        """Cracks with id >= cursor, and the cursor for the next call."""
        count, following = ctypes.c_int64(), ctypes.c_int64()
        head = (cursor, ctypes.sizeof(_abi.hfrac_crack))
        self._call("hfrac_cracks_since", *head, None, 0, ctypes.byref(count), None)
        records, address = _arrays.new_records(_abi.hfrac_crack, count.value)
        self._call("hfrac_cracks_since", *head, address, count.value, ctypes.byref(count), ctypes.byref(following))
        cracks = [Crack.of(struct) for struct in records] if _arrays.numpy is None else records
        return cracks, following.value

    @property
    def fractures(self) -> List[Fracture]:
        """Fractures as they are now, most cracks first."""
        count, size = ctypes.c_int64(), ctypes.sizeof(_abi.hfrac_fracture)
        self._call("hfrac_fractures", size, None, 0, ctypes.byref(count))
        records = (_abi.hfrac_fracture * count.value)()
        self._call("hfrac_fractures", size, ctypes.addressof(records), count.value, ctypes.byref(count))
        return [Fracture.of(struct) for struct in records]

    def fracture_line(self, fracture: int = 0) -> Any:
        """A fracture, by its index in `fractures`, as an ordered line from tip to tip: a numpy record array, or a list of
        FracturePoint."""
        count, size = ctypes.c_int64(), ctypes.sizeof(_abi.hfrac_fracture_point)
        self._call("hfrac_fracture_line", fracture, size, None, 0, ctypes.byref(count))
        records, address = _arrays.new_records(_abi.hfrac_fracture_point, count.value)
        self._call("hfrac_fracture_line", fracture, size, address, count.value, ctypes.byref(count))
        return [FracturePoint.of(struct) for struct in records] if _arrays.numpy is None else records

    def events(
        self, distance: float = 0.0, time_window: float = 0.0, cycle_window: int = 0, thickness: float = 1.0
    ) -> List[Event]:
        """The seismic catalogue: cracks that broke together as events. [m] between cracks of one event, 0: two mean disc
        distances; [s] and mechanical cycles between them, 0: the same step, any number; [m] of rock in the plane."""
        return Rule(distance, time_window, cycle_window, thickness).events(*self._log("hfrac_cracks_since", _abi.hfrac_crack))

    @property
    def slips(self) -> Any:
        """What smooth joints slipped, in order of time: a numpy record array, or a list of Slip."""
        return self.slips_since(0)[0]

    def slips_since(self, cursor: int) -> Tuple[Any, int]:
        """Slips with id >= cursor, and the cursor for the next call."""
        count, following = ctypes.c_int64(), ctypes.c_int64()
        head = (cursor, ctypes.sizeof(_abi.hfrac_slip))
        self._call("hfrac_slips_since", *head, None, 0, ctypes.byref(count), None)
        records, address = _arrays.new_records(_abi.hfrac_slip, count.value)
        self._call("hfrac_slips_since", *head, address, count.value, ctypes.byref(count), ctypes.byref(following))
        slips = [Slip.of(struct) for struct in records] if _arrays.numpy is None else records
        return slips, following.value

    def slip_events(
        self, distance: float = 0.0, time_window: float = 0.0, thickness: float = 1.0, shear_modulus: float = 0.0,
        slip_rate: float = 0.0
    ) -> List[Event]:
        """Events from slip of smooth joints, slow slip included: [m] between contacts of one event, 0: two mean disc distances;
        [s] between them, 0: the same increment; [m] of rock in the plane; [Pa] of the rock, 0: as estimated from its bonds;
        [m/s]: slower slips are left out."""
        rule = Rule(distance, time_window, 0, thickness, shear_modulus, slip_rate)
        return rule.slip_events(*self._log("hfrac_slips_since", _abi.hfrac_slip))

    def event_of_cracks(
        self, distance: float = 0.0, time_window: float = 0.0, cycle_window: int = 0, thickness: float = 1.0
    ) -> List[int]:
        """The index, in events() of the same arguments, of the event that each crack belongs to."""
        return Rule(distance, time_window, cycle_window, thickness).event_of_cracks(*self._log("hfrac_cracks_since", _abi.hfrac_crack))

    def _log(self, function: str, struct: Any) -> Tuple[Any, int]:
        count, size = ctypes.c_int64(), ctypes.sizeof(struct)
        self._call(function, 0, size, None, 0, ctypes.byref(count), None)
        entries = (struct * max(1, count.value))()
        self._call(function, 0, size, ctypes.addressof(entries), count.value, ctypes.byref(count), None)
        return entries, count.value

    # Fields

    @property
    def discs(self) -> Discs:
        """Fields of the discs, e.g. sim.discs.position."""
        return Discs(self)

    @property
    def bonds(self) -> Bonds:
        """Fields of the bonds, intact and broken."""
        return Bonds(self)

    @property
    def pipes(self) -> Pipes:
        """Fields of the pipes; pipe i crosses bond i."""
        return Pipes(self)

    @property
    def joints(self) -> Joints:
        """Fields of the contacts of smooth joints, each a piece of its joint; empty without such joints."""
        return Joints(self)

    @property
    def domains(self) -> Domains:
        """Fields of the fluid domains; domain 0 is the outside."""
        return Domains(self)

    def field(self, name: str) -> Array:
        """A copy of the field of that name, e.g. "domain.pressure", of shape (n,) or (n, components)."""
        info, desc = self._described(name)
        copied, address = _arrays.new_array(info.dtype, desc.count, info.components)
        count = ctypes.c_int64()
        function = "hfrac_field_copy_f64" if info.dtype == "double" else "hfrac_field_copy_i32"
        self._call(function, desc.field, address, desc.count * info.components, ctypes.byref(count))
        return copied

    def view(self, name: str) -> View:
        """The field of that name without a copy, valid until the simulation changes."""
        info, desc = self._described(name)
        data, count, epoch = ctypes.c_void_p(), ctypes.c_int64(), ctypes.c_int64()
        self._call("hfrac_field_view", desc.field, ctypes.byref(data), ctypes.byref(count), ctypes.byref(epoch))
        array = _arrays.borrowed_array(data.value or 0, info.dtype, desc.count, info.components, self._handle)
        return View(self, info, array, epoch.value)

    def _described(self, name: str) -> Tuple[FieldInfo, _abi.hfrac_field_desc]:
        if name not in _INFO:
            raise UnknownKeyError(f"{name} is not a field; there are: {', '.join(_INFO)}")
        field = ctypes.c_int32()
        call("hfrac_field_find", name.encode(), ctypes.byref(field))
        desc = _abi.hfrac_field_desc(struct_size=ctypes.sizeof(_abi.hfrac_field_desc))
        self._call("hfrac_field_info", field.value, ctypes.byref(desc))
        return _INFO[name], desc

    def picture(self, *views: str, width: int = 1200) -> bytes:
        """A PNG picture of the simulation as it is now, by the renderer, which must be installed: "discs" if no views are
        named, or some of "discs", "aperture", "crack-time", "pressure", "displacement", "stress", "rotation", "forces",
        "bonds" side by side (`hfrac render --help` lists all). `width` [pixel] 320 to 8192."""
        with self._lock:
            if self._handle is None:
                raise BadHandleError("the simulation is closed")
            return _picture.draw(self._handle.pointer, views or ("discs",), width)

    def _repr_png_(self) -> Optional[bytes]:
        """For notebooks: the picture, where there is a renderer; otherwise the text of repr."""
        if self._handle is None:
            return None
        try:
            return self.picture(width=800)
        except HfracError:
            return None

    def __repr__(self) -> str:
        title = f" {self._title!r}" if getattr(self, "_title", "") else ""
        if self._handle is None:
            return f"<hfrac.Simulation{title}: closed>"
        s = self.state
        counts = f"{s.disc_count} discs, {s.bond_count} bonds, {len(self.wells)} wells, {s.crack_count} cracks"
        return f"<hfrac.Simulation{title}: {counts}, step {s.step}, t = {s.time:g} s>"
