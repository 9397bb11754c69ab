# SPDX-License-Identifier: BSD-3-Clause
"""What a simulation is made of: options by key, wells, own discs, case files."""
import ctypes
import functools
import os
from array import array
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _abi, _library
from ._library import call

Value = Union[int, float, str]
PathLike = Union[str, "os.PathLike[str]"]


class Option(NamedTuple):
    """What the library's table says of one option."""

    #: "section.name", as in case files
    key: str
    #: "real", "integer" or "choice"
    type: str
    #: SI unit, "1" for none
    unit: str
    default: Value
    #: smallest and largest value allowed; of a choice, its first and last index
    minimum: float
    maximum: float
    #: words of a choice, otherwise empty
    choices: Tuple[str, ...]
    help: str

    @property
    def keyword(self) -> str:
        """The same as a keyword argument of Simulation and Definition."""
        return self.key.replace(".", "_")

    def value(self, number: float) -> Value:
        """A number from the library in the option's own type."""
        if self.type == "choice":
            return self.choices[int(number)]
        return int(number) if self.type == "integer" else number


@functools.lru_cache(maxsize=None)
def _option_table(kind_of: str = "hfrac_option") -> Tuple[Option, ...]:
    count = ctypes.c_int32()
    call(f"{kind_of}_count", ctypes.byref(count))
    table = []
    for index in range(count.value):
        info = _abi.hfrac_option_info(struct_size=ctypes.sizeof(_abi.hfrac_option_info))
        call(f"{kind_of}_at", index, ctypes.byref(info))
        choices = tuple(info.choices.decode().split("|")) if info.choices else ()
        kind = ("real", "integer", "choice")[info.type]
        key, unit, text = info.key.decode(), info.unit.decode(), info.help.decode()
        row = Option(key, kind, unit, 0, info.minimum, info.maximum, choices, text)
        table.append(row._replace(default=row.value(info.default_value)))
    return tuple(table)


@functools.lru_cache(maxsize=None)
def _key_of_keyword() -> Dict[str, str]:
    return {option.keyword: option.key for option in _option_table()}


def options() -> List[Option]:
    """Every option there is, with unit, default, range and one sentence of help."""
    return list(_option_table())


def well_options() -> List[Option]:
    """Every value a well has; the key is without its "well[0]."."""
    return list(_option_table("hfrac_well_option"))


def joint_options() -> List[Option]:
    """Every value a joint has; the key is without its "joint[0]."."""
    return list(_option_table("hfrac_joint_option"))


def schedule_options() -> List[Option]:
    """Every value an entry of the wells' schedule has; the key is without its "schedule[0]."."""
    return list(_option_table("hfrac_schedule_option"))


class Definition:
    """The options of a simulation, its wells and, if wanted, its own discs.

    Options are keyword arguments, whole (``bond_tensile_strength=40e6``) or by section
    (``bond={"tensile_strength": 40e6}``). ``wells`` holds one mapping per well: x, y (the model's centre if left
    out), radius, pressure, ramp_per_step, rate, control ("pressure", "ramp" or "rate"), and the
    values of its wellbore (``well_options()``). Wells of a case file are
    changed in order, further ones are added. ``joints`` likewise: lines of weakness from x1, y1 to x2, y2 with
    tensile_factor, shear_factor, friction, state ("bonded" or "broken"). ``schedule``: entries of well, time, value,
    control ("pressure" or "rate"). ``discs``: rows of x, y, radius [m], packed elsewhere; ``bonds``: pairs of their
    indices, from 0, that are bonded, otherwise all that are near.
    """

    def __init__(
        self,
        case: Optional[PathLike] = None,
        *,
        wells: Sequence[Mapping[str, Value]] = (),
        joints: Sequence[Mapping[str, Value]] = (),
        schedule: Sequence[Mapping[str, Value]] = (),
        title: Optional[str] = None,
        discs: Optional[Iterable[Sequence[float]]] = None,
        bonds: Optional[Iterable[Sequence[int]]] = None,
        **options: Any,
    ) -> None:
        self._struct = _abi.hfrac_sim_def()
        self._free = _library.load().hfrac_sim_def_free
        self._discs: Any = None  # what the struct's pointers point to
        self._bonds: Any = None
        call("hfrac_sim_def_init", ctypes.byref(self._struct), ctypes.sizeof(self._struct))
        if case is not None:
            self.load(case)
        self.update(wells=wells, joints=joints, schedule=schedule, title=title, discs=discs, bonds=bonds, **options)

    def __del__(self) -> None:
        if getattr(self, "_free", None) is not None:
            self._free(ctypes.byref(self._struct))

    def load(self, path: PathLike) -> None:
        """Reads a case file over what is set so far."""
        call("hfrac_sim_def_load", ctypes.byref(self._struct), os.fsencode(path))

    def add_traces(self, path: PathLike) -> None:
        """Adds a joint for each trace of a table or of GeoJSON [m]; all but its ends has its default."""
        call("hfrac_sim_def_add_traces", ctypes.byref(self._struct), os.fsencode(path))

    def update(
        self,
        *,
        wells: Sequence[Mapping[str, Value]] = (),
        joints: Sequence[Mapping[str, Value]] = (),
        schedule: Sequence[Mapping[str, Value]] = (),
        title: Optional[str] = None,
        discs: Optional[Iterable[Sequence[float]]] = None,
        bonds: Optional[Iterable[Sequence[int]]] = None,
        **options: Any,
    ) -> None:
        """Sets what the constructor takes, on top of what is set so far."""
        for name, value in options.items():
            if isinstance(value, Mapping):
                for inner, inner_value in value.items():
                    self.set(f"{name}.{inner}", inner_value)
            else:
                self.set(_key_of_keyword().get(name, name.replace("_", ".", 1)), value)
        for kind, items in (("well", wells), ("joint", joints), ("schedule", schedule)):
            for index, item in enumerate(items):
                for name, value in item.items():
                    self.set(f"{kind}[{index}].{name}", value)
        if title is not None:
            self.set("title", title)
        if discs is not None:
            self._give_discs(discs)
        if bonds is not None:
            self._give_bonds(bonds)

    def _give_discs(self, discs: Iterable[Sequence[float]]) -> None:
        values = array("d", (value for x, y, radius in discs for value in (x, y, radius)))
        self._discs = (ctypes.c_double * len(values)).from_buffer(values)
        self._struct.given_discs = ctypes.addressof(self._discs)
        self._struct.given_disc_count = len(values) // 3

    def _give_bonds(self, bonds: Iterable[Sequence[int]]) -> None:
        values = array("q", (int(index) for first, second in bonds for index in (first, second)))
        self._bonds = (ctypes.c_int64 * len(values)).from_buffer(values)
        self._struct.given_bonds = ctypes.addressof(self._bonds) if values else None
        self._struct.given_bond_count = len(values) // 2

    def set(self, key: str, value: Value) -> None:
        """Sets one value by its key: "bond.tensile_strength", "well[0].pressure", "title"."""
        target, name = ctypes.byref(self._struct), key.encode()
        if isinstance(value, str):
            call("hfrac_sim_def_set_str", target, name, value.encode())
        elif hasattr(value, "__index__") and -(2**63) <= value < 2**63:
            call("hfrac_sim_def_set_i64", target, name, value.__index__())
        else:
            call("hfrac_sim_def_set_f64", target, name, float(value))

    def get(self, key: str) -> Value:
        """One value by its key; a choice as its word."""
        if key in ("title", "packing.file"):
            return _library.text("hfrac_sim_def_get_str", ctypes.byref(self._struct), key.encode())
        where, name = ctypes.byref(self._struct), key.encode()
        kind = self._kind(key)
        if kind == "choice":
            return _library.text("hfrac_sim_def_get_str", where, name)
        if kind == "integer":
            integer = ctypes.c_int64()
            call("hfrac_sim_def_get_i64", where, name, ctypes.byref(integer))
            return integer.value
        value = ctypes.c_double()
        call("hfrac_sim_def_get_f64", where, name, ctypes.byref(value))
        return value.value

    @staticmethod
    def _kind(key: str) -> str:
        if key in ("well_count", "joint_count", "schedule_count"):
            return "integer"
        kind, of_a_list, name = key.partition("[")[0], "[" in key, key
        if of_a_list and kind in ("well", "joint", "schedule"):
            name = key.partition("].")[2]
            table = _option_table(f"hfrac_{kind}_option")
        else:
            table = _option_table()
        return next((row.type for row in table if row.key == name), "real")

    @property
    def title(self) -> str:
        """Free text that ends up in the output."""
        return self._struct.title.decode(errors="replace")

    @property
    def well_count(self) -> int:
        """Number of wells."""
        return self._struct.well_count

    @property
    def wells(self) -> List[Dict[str, Value]]:
        """The wells, in the form the constructor takes."""
        return self._items("well", _abi.hfrac_well_def)

    @property
    def joints(self) -> List[Dict[str, Value]]:
        """The joints, in the form the constructor takes."""
        return self._items("joint", _abi.hfrac_joint_def)

    @property
    def schedule(self) -> List[Dict[str, Value]]:
        """The wells' schedule, in the form the constructor takes."""
        return self._items("schedule", _abi.hfrac_schedule_def)

    def _items(self, kind: str, struct: Any) -> List[Dict[str, Value]]:
        names = [name for name, _ in struct._fields_]
        count = self.get(f"{kind}_count")
        return [{name: self.get(f"{kind}[{index}].{name}") for name in names} for index in range(int(count))]

    @property
    def options(self) -> Dict[str, Value]:
        """All options by key."""
        return {option.key: self.get(option.key) for option in _option_table()}

    @property
    def text(self) -> str:
        """The definition as a case file with every option filled in."""
        return _library.text("hfrac_sim_def_write", ctypes.byref(self._struct))

    def check(self, path: Optional[PathLike] = None) -> None:
        """Raises if no simulation can be built from this; the text names the fix, and with the `path` of the case file that
        was loaded also the file and the line of the value."""
        if path is None:
            call("hfrac_sim_def_check", ctypes.byref(self._struct))
        else:
            call("hfrac_sim_def_check_file", ctypes.byref(self._struct), os.fsencode(path))

    def pack(self, path: PathLike) -> None:
        """Packs the model, brings it to rest and keeps it as file `path`, for definitions that name it as packing.file."""
        call("hfrac_pack", ctypes.byref(self._struct), os.fsencode(path))

    @property
    def disc_radii(self) -> Tuple[float, float]:
        """Mean radius of the packing's discs where they are fine, and where they are coarsest [m]; the same in a uniform packing."""
        fine, coarsest = ctypes.c_double(), ctypes.c_double()
        call("hfrac_sim_def_disc_radii", ctypes.byref(self._struct), ctypes.byref(fine), ctypes.byref(coarsest))
        return fine.value, coarsest.value

    def copy(self) -> "Definition":
        """An independent definition with the same values."""
        other = Definition()
        call("hfrac_sim_def_copy", ctypes.byref(self._struct), ctypes.byref(other._struct))
        other._discs = self._discs
        other._bonds = self._bonds
        return other

    def __repr__(self) -> str:
        changed = [o.key for o in _option_table() if self.get(o.key) != o.default]
        parts = [f"{key}={self.get(key)!r}" for key in changed]
        return f"<hfrac.Definition {self.title!r}: {self.well_count} wells, {', '.join(parts) or 'all defaults'}>"
