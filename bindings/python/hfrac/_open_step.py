# SPDX-License-Identifier: BSD-3-Clause
"""A step that may be tried again, for hosts that couple iteratively."""
import types
from typing import TYPE_CHECKING, Optional, Type

from . import _abi

if TYPE_CHECKING:
    from ._simulation import Simulation


class OpenStep:
    """An open step. Leaving its ``with`` block keeps what the last ``do`` gave; an exception, or reject, goes back.

        with sim.open_step() as step:
            step.do(0.1)
            if not content:
                step.do(0.05)
    """

    def __init__(self, simulation: "Simulation") -> None:
        self._simulation = simulation
        simulation._call("hfrac_step_prepare")
        #: whether neither finalize nor reject has closed it
        self.open = True

    def do(self, duration: float) -> _abi.Status:
        """Takes the step, `duration` [s] of fluid time long, from where it was opened; wells and far field as they are
        set now. May be called again."""
        with self._simulation._lock, self._simulation._progress.watched():
            return self._simulation._call("hfrac_step_do", duration)

    def more(self, duration: float) -> _abi.Status:
        """Takes another step of `duration` [s] within the open one, from where the last ``do`` or ``more`` ended."""
        with self._simulation._lock, self._simulation._progress.watched():
            return self._simulation._call("hfrac_step_more", duration)

    def finalize(self) -> None:
        """Closes the step and keeps what the last ``do`` gave and ``more`` added."""
        self._simulation._call("hfrac_step_finalize")
        self.open = False

    def reject(self) -> None:
        """Closes the step and goes back to where it was opened, wells and far field included."""
        self._simulation._call("hfrac_step_reject")
        self.open = False

    def __enter__(self) -> "OpenStep":
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[types.TracebackType]
    ) -> None:
        if not self.open or self._simulation.closed:
            return
        if kind is None:
            self.finalize()
        else:
            self.reject()
