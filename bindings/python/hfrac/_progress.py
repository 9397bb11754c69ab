# SPDX-License-Identifier: BSD-3-Clause
"""Progress functions, and Ctrl-C during a long call.

While C code runs, Python sees no signal. The library's progress callback is where it can look: during a call Ctrl-C
leaves a note, the callback reads the note and stops the library, and KeyboardInterrupt is raised when the call is back.
"""
import contextlib
import signal
import threading
from typing import Any, Callable, Iterator, Optional

try:  # those of module signal turn numbers into enums and back, which costs more than the rest of a call
    from _signal import getsignal as _handler_of
    from _signal import signal as _set_handler
except ImportError:  # not CPython
    from signal import getsignal as _handler_of
    from signal import signal as _set_handler

from . import _abi

_SIGINT = int(signal.SIGINT)

#: Called with the share done, 0 to 1, and what is being done; a true result stops.
ProgressFunction = Callable[[float, str], Optional[bool]]


#: Called with how much it matters and what happened.
LogFunction = Callable[[_abi.LogLevel, str], None]
#: Called after every step, without arguments; a true result stops after it.
StepFunction = Callable[[], Optional[bool]]


class Progress:
    """The library's callbacks around functions of the user."""

    def __init__(self, function: Optional[ProgressFunction]) -> None:
        self.function = function
        self.log_function: Optional[LogFunction] = None
        self.step_function: Optional[StepFunction] = None
        self.callback = _abi.hfrac_progress_fn(self._called)
        self.log_callback = _abi.hfrac_log_fn(self._told)
        self.step_callback = _abi.hfrac_step_fn(self._stepped)
        self._error: Optional[BaseException] = None
        self._log_error: Optional[BaseException] = None
        self._interrupted = False

    def _called(self, user: Any, fraction: float, what: bytes) -> int:
        if self._interrupted:
            return 1
        if self.function is None:
            return 0
        try:
            return 1 if self.function(fraction, what.decode(errors="replace")) else 0
        except BaseException as error:  # must not pass through C; raised again after the call
            self._error = error
            return 1

    def _told(self, user: Any, level: int, message: bytes) -> int:
        try:
            if self.log_function is not None:
                self.log_function(_abi.LogLevel(level), message.decode(errors="replace"))
        except BaseException as error:
            self._log_error = error
        return 0

    def raise_told(self) -> None:
        """After any call: what the log function raised."""
        error, self._log_error = self._log_error, None
        if error is not None:
            raise error

    def _stepped(self, user: Any, simulation: Any, step: int, time: float) -> int:
        if self._interrupted or self._error is not None:
            return 1
        try:
            return 1 if self.step_function is not None and self.step_function() else 0
        except BaseException as error:
            self._error = error
            return 1

    @contextlib.contextmanager
    def watched(self) -> Iterator[None]:
        """Around a call that may take long: what the user's function raised, and Ctrl-C, come out here."""
        self._error, self._interrupted = None, False
        main = threading.current_thread() is threading.main_thread()
        ours = main and _handler_of(_SIGINT) is signal.default_int_handler
        if ours:
            _set_handler(_SIGINT, self._note_interrupt)
        try:
            yield
        finally:
            if ours:
                _set_handler(_SIGINT, signal.default_int_handler)
            error, self._error = self._error, None
        if error is not None:
            raise error
        if self._interrupted:
            raise KeyboardInterrupt

    def _note_interrupt(self, number: int, frame: Any) -> None:
        self._interrupted = True
