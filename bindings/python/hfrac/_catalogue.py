# SPDX-License-Identifier: BSD-3-Clause
"""The seismic catalogue: cracks and slips as events, and the law of their magnitudes."""
import ctypes
from typing import Any, Iterable, List

from . import _abi
from ._library import call
from ._records import Event, MagnitudeLaw


class Rule:
    """How cracks and slips make events, see catalogue.h."""

    def __init__(self, distance: float, time_window: float, cycle_window: int, thickness: float,
                 shear_modulus: float = 0.0, slip_rate: float = 0.0) -> None:
        self._options = _abi.hfrac_catalogue_options(
            struct_size=ctypes.sizeof(_abi.hfrac_catalogue_options),
            distance=distance,
            time_window=time_window,
            cycle_window=cycle_window,
            thickness=thickness,
            shear_modulus=shear_modulus,
            slip_rate=slip_rate,
        )

    def _head(self, cracks: Any, count: int) -> tuple:
        return cracks, ctypes.sizeof(_abi.hfrac_crack), count, ctypes.byref(self._options)

    def events(self, cracks: Any, count: int) -> List[Event]:
        """The events of an array of hfrac_crack."""
        return self._events("hfrac_find_events", self._head(cracks, count), count)

    def slip_events(self, slips: Any, count: int) -> List[Event]:
        """The events of an array of hfrac_slip."""
        head = slips, ctypes.sizeof(_abi.hfrac_slip), count, ctypes.byref(self._options)
        return self._events("hfrac_find_slip_events", head, count)

    @staticmethod
    def _events(function: str, head: tuple, count: int) -> List[Event]:
        found, size = ctypes.c_int64(), ctypes.sizeof(_abi.hfrac_event)
        records = (_abi.hfrac_event * max(1, count))()  # never more events than cracks or slips
        call(function, *head, size, ctypes.addressof(records), count, ctypes.byref(found))
        return [Event.of(struct) for struct in records[: found.value]]

    def event_of_cracks(self, cracks: Any, count: int) -> List[int]:
        """The index of each crack's event."""
        found, indices = ctypes.c_int64(), (ctypes.c_int64 * max(1, count))()
        call("hfrac_find_event_of_cracks", *self._head(cracks, count), ctypes.addressof(indices), count, ctypes.byref(found))
        return indices[: found.value]


def magnitude_law(magnitudes: Iterable[float], completeness: float = float("nan")) -> MagnitudeLaw:
    """Gutenberg and Richter's a and b of some magnitudes (Aki 1965), from `completeness` on; NaN: found from them."""
    values = [float(magnitude) for magnitude in magnitudes]
    law = _abi.hfrac_magnitude_law(struct_size=ctypes.sizeof(_abi.hfrac_magnitude_law))
    array = (ctypes.c_double * max(1, len(values)))(*values)
    call("hfrac_find_magnitude_law", array, len(values), completeness, ctypes.byref(law))
    return MagnitudeLaw.of(law)
