# SPDX-License-Identifier: BSD-3-Clause
"""A well of a running simulation."""
import ctypes
from typing import TYPE_CHECKING, Iterable, Tuple

from . import _abi
from ._abi import WellControl, WellFluid
from ._records import WellState

if TYPE_CHECKING:
    from ._simulation import Simulation


class Well:
    """Well `index` (from 0). Its values are read when asked for; settings hold from the next step on."""

    def __init__(self, simulation: "Simulation", index: int) -> None:
        self._simulation = simulation
        self.index = index

    @property
    def state(self) -> WellState:
        """All values as they are now."""
        struct = _abi.hfrac_well_state(struct_size=ctypes.sizeof(_abi.hfrac_well_state))
        self._simulation._call("hfrac_well_get", self.index, ctypes.byref(struct))
        return WellState.of(struct)

    @property
    def pressure(self) -> float:
        """[Pa] now, as stress.convention says"""
        return self.state.pressure

    @property
    def rate(self) -> float:
        """[m2/s] into the well in the last step"""
        return self.state.rate

    @property
    def injected_volume(self) -> float:
        """[m2] since the initial equilibration, at formation pressure"""
        return self.state.injected_volume

    @property
    def wellhead_pressure(self) -> float:
        """[Pa] absolute: that of the wellbore less rho g depth"""
        return self.state.wellhead_pressure

    def set_pressure(self, pressure: float) -> None:
        """Holds the well at a pressure [Pa]."""
        self._simulation._call("hfrac_well_set_pressure", self.index, pressure)

    def set_ramp(self, pressure: float, per_step: float) -> None:
        """Moves the well's pressure by `per_step` [Pa] each step, up or down to `pressure` [Pa]."""
        self._simulation._call("hfrac_well_set_ramp", self.index, pressure, per_step)

    def set_rate(self, rate: float) -> None:
        """Injects `rate` [m2/s]; negative: takes out; 0: shut in."""
        self._simulation._call("hfrac_well_set_rate", self.index, rate)

    def set_schedule(self, entries: Iterable[Tuple[float, str, float]]) -> None:
        """Replaces the well's schedule: (time [s], "pressure" or "rate", value [Pa or m2/s]) in order of time. Steps end at
        the times; no entries end the schedule."""
        rows = list(entries)
        controls = [WellControl[control.upper()] for _, control, _ in rows]
        count = len(rows)
        self._simulation._call(
            "hfrac_well_set_schedule",
            self.index,
            count,
            (ctypes.c_double * count)(*(time for time, _, _ in rows)),
            (ctypes.c_int32 * count)(*controls),
            (ctypes.c_double * count)(*(value for _, _, value in rows)),
        )

    def set_fluid(self, fluid: str) -> None:
        """Pumps the "first" or the "second" fluid; the well stays driven as it is, and its schedule goes on."""
        self._simulation._call("hfrac_well_set_fluid", self.index, WellFluid[fluid.upper()])

    @property
    def temperature(self) -> float:
        """[K] of the fluid in the well: as injected while it feeds the rock, else the mixture of what flows in"""
        value = ctypes.c_double()
        self._simulation._call("hfrac_well_get_temperature", self.index, ctypes.byref(value))
        return value.value

    def set_temperature(self, temperature: float) -> None:
        """Injects at a temperature [K]. Needs thermal.mode "transport"."""
        self._simulation._call("hfrac_well_set_temperature", self.index, temperature)

    def __repr__(self) -> str:
        s = self.state
        return (
            f"<hfrac.Well {self.index} at ({s.x:g}, {s.y:g}) m, {s.control.name.lower()}: "
            f"{s.pressure / 1e6:.4g} MPa, {s.rate:.4g} m2/s>"
        )
