# SPDX-License-Identifier: BSD-3-Clause
"""Runs spread over cores, each a process `hfrac run` of one worker with a run folder of its own.

A run that is over leaves `result.json` beside its tables: done, or failed with hfrac's sentence. It holds a hash of the case, so a
study that is started again does only what is missing or has another case by now. A run that was broken off goes on from its
checkpoint (`hfrac resume`), to the same bits. A process that a signal killed (no memory, a node that went down) is tried a second
time. Runs end with the process that started them, and hold its lock until they do: two studies never write into one folder.
"""
import ctypes
import fcntl
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import time
from typing import Callable, Dict, List, NamedTuple, Optional

from .cases import Run
from .study_file import StudyError

_libc = ctypes.CDLL(None)
PR_SET_PDEATHSIG = 1
STOPPED = (130, -signal.SIGINT, -signal.SIGTERM, -signal.SIGHUP)
FIELD_FILES = ("*.vtu", "*.pvtu", "*.pvd", "state.hfrac", "paraview_state.py")


class Result(NamedTuple):
    """How a run ended."""

    status: str  # done, failed
    sentence: str
    seconds: float


def key_of(run: Run) -> str:
    return hashlib.sha256(run.text.encode()).hexdigest()


def result_of(run: Run) -> Optional[Result]:
    """What is known of the run as it is now asked for; None: nothing."""
    try:
        kept = json.loads((run.folder / "result.json").read_text())
        return Result(kept["status"], kept["sentence"], kept["seconds"]) if kept["case"] == key_of(run) else None
    except (OSError, ValueError, KeyError):
        return None


def write_whole(path: pathlib.Path, text: str) -> None:
    """Aside, then renamed: whoever reads meets a whole file."""
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    aside.write_text(text)
    aside.replace(path)


def lock(folder: pathlib.Path, name: str = "lock", patience: float = 60.0) -> int:
    """A lock that this process and the runs it starts hold. Raises StudyError if another study keeps it."""
    folder.mkdir(parents=True, exist_ok=True)
    held = os.open(folder / f".{name}", os.O_CREAT | os.O_RDWR, 0o666)
    os.set_inheritable(held, True)
    until = time.monotonic() + patience
    while True:
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return held
        except OSError:
            if time.monotonic() > until:
                raise StudyError(f"another study is writing into '{folder}'; wait for it, or choose another folder with -o") from None
            time.sleep(0.2)


def sentence_of(code: int, errors: str) -> str:
    """hfrac's own words."""
    if code < 0:
        return f"ended twice by signal {-code} ({signal.Signals(-code).name}); is there memory for so many runs at a time?"
    lines = [line.removeprefix("hfrac: ") for line in errors.splitlines() if line.startswith("hfrac: ")]
    lines = [line for line in lines if "stay readable" not in line and not line.startswith("warning")]
    lines = [re.sub(r"^\S*asked\.toml(:\d+)?: ", "", line) for line in lines]
    return " ".join(lines)[:600] or errors.strip()[-600:] or f"exit status {code}, without a word"


class Pool:
    """Up to `jobs` runs at a time. `tell` is called whenever something has changed, with the runs under way."""

    def __init__(self, command: str, jobs: int, keep_fields: bool, held: int, tell: Callable[["Pool"], None]) -> None:
        self.command, self.jobs, self.keep_fields, self.held, self.tell = command, jobs, keep_fields, held, tell
        self.busy: Dict[int, "Process"] = {}
        self.waiting: List[Run] = []
        self.results: Dict[int, Result] = {}
        self.fresh = 0  # runs that this process has done
        self.stopped = False

    def stop(self, *_: object) -> None:
        """Asks all runs to leave a checkpoint and end; for a signal's handler."""
        self.stopped = True
        for process in self.busy.values():
            process.popen.terminate()

    def work(self, runs: List[Run], again: bool = False) -> Dict[int, Result]:
        """The results by index; `again`: failed ones are done once more. Fewer than runs only if stopped."""
        self.results = {}
        for run in runs:
            known = result_of(run)
            if known is not None and not (again and known.status == "failed"):
                self.results[run.index] = known
            elif run.refusal:
                self._finish(run, Result("failed", run.refusal, 0.0))
            else:
                self.waiting.append(run)
        self.waiting.reverse()
        while self.busy or (self.waiting and not self.stopped):
            while self.waiting and len(self.busy) < self.jobs and not self.stopped:
                run = self.waiting.pop()
                self.busy[run.index] = Process(self, run)
            self.tell(self)
            time.sleep(0.02)
            for process in [one for one in self.busy.values() if one.popen.poll() is not None]:
                self._ended(process)
        return self.results

    def _ended(self, process: "Process") -> None:
        run, code = process.run, process.popen.returncode
        del self.busy[run.index]
        if self.stopped or code in STOPPED:
            if code in STOPPED and not self.stopped:  # somebody else's signal: as if the whole study had met it
                self.stop()
            if code != 0:
                return
        if code < 0 and process.attempt == 1:
            self.busy[run.index] = Process(self, run, 2)
            return
        errors = (run.folder / "errors.txt").read_text(errors="replace")
        if code != 0:
            self._finish(run, Result("failed", sentence_of(code, errors), process.seconds))
        else:
            self._finish(run, Result("done", "", process.seconds))
        self.fresh += 1
        self.tell(self)

    def _finish(self, run: Run, result: Result) -> None:
        run.folder.mkdir(parents=True, exist_ok=True)
        if not self.keep_fields:
            for pattern in FIELD_FILES:
                for path in run.folder.glob(pattern):
                    path.unlink()
        kept = {"case": key_of(run), **result._asdict()}
        write_whole(run.folder / "result.json", json.dumps(kept, indent=1) + "\n")
        self.results[run.index] = result


class Process:
    """A run under way."""

    def __init__(self, pool: Pool, run: Run, attempt: int = 1) -> None:
        self.run, self.attempt, self.began = run, attempt, time.monotonic()
        run.folder.mkdir(parents=True, exist_ok=True)
        asked = run.folder / "asked.toml"
        goes_on = any((run.folder / "checkpoints").glob("*.checkpoint")) and asked.exists() and asked.read_text() == run.text
        write_whole(asked, run.text)
        (run.folder / "result.json").unlink(missing_ok=True)
        words = ["resume", run.folder] if goes_on else ["run", asked, "-o", run.folder, "--overwrite"]
        parent = os.getpid()

        def end_with_parent() -> None:
            _libc.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
            if os.getppid() != parent:
                os._exit(1)

        with open(run.folder / "errors.txt", "wb") as errors:
            self.popen = subprocess.Popen([pool.command, *map(str, words), "--workers", "1", "-q"], stdin=subprocess.DEVNULL,
                                          stdout=errors, stderr=errors, pass_fds=(pool.held,), preexec_fn=end_with_parent)

    @property
    def seconds(self) -> float:
        return round(time.monotonic() - self.began, 3)
