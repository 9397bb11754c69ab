# SPDX-License-Identifier: BSD-3-Clause
"""The line that says how far a study is, what a run costs and what is left: one line on a terminal, elsewhere one now and then."""
import sys
import time

from .pool import Pool


def duration(seconds: float) -> str:
    if seconds < 90.0:
        return f"{seconds:.0f} s"
    if seconds < 5400.0:
        return f"{seconds / 60.0:.0f} min"
    return f"{seconds / 3600.0:.1f} h"


class Progress:
    """Shows a pool's state on the error output."""

    def __init__(self, total: int, quiet: bool, what: str = "runs") -> None:
        self.total, self.quiet, self.what = total, quiet, what
        self.began, self.shown, self.last = time.monotonic(), "", 0.0
        self.terminal = sys.stderr.isatty()
        self.offset = 0  # runs of ensembles before this one
        self.told = False  # why a run failed

    def text(self, pool: Pool) -> str:
        done = self.offset + len(pool.results)
        failed = sum(result.status == "failed" for result in pool.results.values())
        words = f"{done} of {self.total} {self.what}"
        if failed:
            words += f", {failed} failed"
        if pool.fresh:
            wall = time.monotonic() - self.began
            each = [result.seconds for result in pool.results.values() if result.seconds > 0.0]
            left = (self.total - done) * wall / pool.fresh
            words += f"; {sum(each) / max(1, len(each)):.2g} s a run, {duration(left)} left with {pool.jobs} at a time"
        return words

    def __call__(self, pool: Pool) -> None:
        now = time.monotonic()
        if not self.quiet and not self.told:
            self._tell_first_failure(pool)
        if self.quiet or now - self.last < (0.2 if self.terminal else 10.0):
            return
        self.last = now
        text = self.text(pool)
        if text != self.shown:
            self.shown = text
            sys.stderr.write(f"\r\033[K{text}" if self.terminal else f"{text}\n")
            sys.stderr.flush()

    def _tell_first_failure(self, pool: Pool) -> None:
        """At once, so that nobody waits for hundreds of runs that all fail alike."""
        for index, result in pool.results.items():
            if result.status == "failed":
                self.told = True
                sys.stderr.write(("\r\033[K" if self.terminal else "") + f"run {index} failed: {result.sentence}\n")
                return

    def end(self) -> None:
        if self.terminal and self.shown and not self.quiet:
            sys.stderr.write("\r\033[K")
