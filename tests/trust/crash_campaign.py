#!/usr/bin/env python3
"""Kills runs, fills their disk and breaks their writes, then resumes them: every end must be that of the undisturbed run.

    crash_campaign.py --count N [--seed S]        needs HFRAC_COMMAND and HFRAC_FAILING_DISK in the environment

Each trial takes one of the cases below through one to three disturbances, chosen by the seed, and then to its end:
  timed  kill -9 at a random moment          kill   kill -9 inside a call of the program (failing_disk.c), half-way
  eio    a call fails once with EIO                 through a write, before or after an open, a sync, a rename
  full   the disk is full from a call on     short  writes take a part of their bytes only
After every disturbance each file that is there must be whole: snapshots equal to the undisturbed run's byte for byte, lists
that name only what is there, checkpoints that agree with their checksum. At the end all files must be the undisturbed
run's, the state hash included. Prints a JSON object with what was done; exit status 0 if nothing was wrong.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

COMMAND = os.environ["HFRAC_COMMAND"]
SHIM = os.environ["HFRAC_FAILING_DISK"]
SERIES = ("discs", "bonds", "cracks", "flow", "fractures")

# A title is no path: whatever it says, nothing is written outside the run's folder.
COMMON = """
title = "../../elsewhere"
[packing]
disc_count = {discs}
[stress]
convention = "effective"
sigma_Hmax = 0.0
sigma_hmin = 0.0
[boundary]
kind = "walls"
[[well]]
radius = 14
pressure = {pressure}
[output]
every = 3
checkpoint_steps = 4
[run]
workers = 1
[stepping]
flow_step = 1.0e-2
"""
# Both solvers, both ways of solving for pressures, both flow schemes; temperature, joints and a schedule.
CASES = {
    "explicit_direct": COMMON.format(discs=300, pressure=60e6) + "steps = 14\n[flow]\nsolver = 'direct'\n",
    "explicit_iterative": COMMON.format(discs=300, pressure=60e6) + "steps = 14\n[flow]\nsolver = 'iterative'\n",
    "explicit_flow": COMMON.format(discs=250, pressure=80e6) + "steps = 10\n[flow]\nscheme = 'explicit'\naperture_limit = 1e-4\n",
    "quasi_static_coupled": COMMON.format(discs=300, pressure=60e6) + "steps = 10\nmode = 'coupled'\n[solver]\nkind = 'quasi-static'\n",
    "quasi_static_substep": COMMON.format(discs=300, pressure=60e6) + "steps = 10\n[solver]\nkind = 'quasi-static'\n[flow]\nsolver = 'iterative'\n",
    "quasi_static_explicit_flow": COMMON.format(discs=250, pressure=80e6) + "steps = 10\n[solver]\nkind = 'quasi-static'\n"
                                  "[flow]\nscheme = 'explicit'\naperture_limit = 1e-4\n",
    "warm_with_joints": COMMON.format(discs=300, pressure=60e6) + "steps = 12\n[thermal]\nmode = 'transport'\nexpansion = 1e-5\n"
                        "[[joint]]\nx1 = 20\ny1 = 70\nx2 = 70\ny2 = 80\ntensile_factor = 0.2\nshear_factor = 0.2\n"
                        "[[well.schedule]]\ntime = 0.055\nrate = 1e-2\n",
}


class Wrong(Exception):
    """The promise was broken."""


def hfrac(*arguments, fault=None, after=None):
    """Runs the program; `fault` = (kind, call, share) of the failing disk, `after` seconds until kill -9."""
    environment = dict(os.environ)
    if fault:
        kind, call, share, folder, log = fault
        environment.update(LD_PRELOAD=SHIM, HFRAC_DISK_FAULT=kind, HFRAC_DISK_AT=str(call), HFRAC_DISK_SHARE=str(share),
                           HFRAC_DISK_FOLDER=str(folder), HFRAC_DISK_LOG=str(log))
    process = subprocess.Popen([COMMAND, *map(str, arguments)], env=environment, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    try:
        text = process.communicate(timeout=after if after else 300)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        text = process.communicate()[1]
    return process.returncode, text


def summary_of(folder):
    """summary.json without what measures wall time."""
    summary = json.loads((folder / "summary.json").read_text())
    del summary["wall_seconds"], summary["setup"]["packing_seconds"], summary["setup"]["setup_seconds"]
    return summary


def check_checkpoint(path):
    data = path.read_bytes()
    if data[:8] != b"hfracchk" or struct.unpack_from("<I", data, 12)[0] != 0x01020304:
        raise Wrong(f"{path.name} has no checkpoint's head")
    course, image, checksum = struct.unpack_from("<QQI", data, 16)
    if 40 + course + image != len(data):
        raise Wrong(f"{path.name} is not as long as it says")
    if zlib.crc32(data[:32] + bytes(4) + data[36:]) != checksum:
        raise Wrong(f"{path.name} is damaged")


def check_table(path):
    text = path.read_text()
    rows = text.split("\n")
    if rows.pop() != "" or len({row.count(",") for row in rows}) != 1:
        raise Wrong(f"{path.name} is not whole")


def check_present(folder, reference):
    """What holds at any moment, whatever was done to the run."""
    for path in sorted(folder.rglob("*")):
        name = path.name
        if path.is_dir() or name.startswith("."):
            continue
        twin = reference / name
        if path.suffix == ".vtu":
            if not twin.exists() or path.read_bytes() != twin.read_bytes():
                raise Wrong(f"{name} is not the undisturbed run's")
        elif path.suffix == ".pvd":
            for file in re.findall(r'file="([^"]+)"', path.read_text()):
                if not (folder / file).exists():
                    raise Wrong(f"{name} names {file}, which is not there")
            if not path.read_text().endswith("</VTKFile>\n"):
                raise Wrong(f"{name} is not whole")
        elif path.suffix == ".checkpoint":
            check_checkpoint(path)
        elif name == "history.csv":
            if not twin.read_bytes().startswith(path.read_bytes()):
                raise Wrong("history.csv is not the beginning of the undisturbed run's")
        elif name == "case.toml":
            if path.read_bytes() != twin.read_bytes():
                raise Wrong("case.toml is not the undisturbed run's")
        elif name == "summary.json":
            summary_of(folder)
        elif path.suffix == ".csv":
            check_table(path)
    if len(list(folder.glob("checkpoints/step_*.checkpoint"))) > 3:  # the third goes right after a new one is there
        raise Wrong("more than the last two checkpoints are kept")


def check_end(folder, reference):
    def names(top):
        return sorted(path.name for path in top.iterdir() if path.name != "checkpoints")
    if names(folder) != names(reference):
        raise Wrong(f"other files: {set(names(folder)) ^ set(names(reference))}")
    for name in names(reference):
        if name != "summary.json" and (folder / name).read_bytes() != (reference / name).read_bytes():
            raise Wrong(f"{name} differs at the end")
    if summary_of(folder) != summary_of(reference):
        raise Wrong("summary.json differs at the end")


class Campaign:
    def __init__(self, top, seed):
        self.top = top
        self.dice = random.Random(seed)
        self.done = {"trials": 0, "disturbances": 0, "resumed": 0, "begun_anew": 0, "kinds": {}, "places": {}, "cases": {}}
        self.references = {}

    def reference(self, name):
        """The undisturbed run, how many calls it makes and how long it takes."""
        if name not in self.references:
            case = self.top / f"{name}.toml"
            case.write_text(CASES[name])
            folder, log = self.top / f"reference-{name}", self.top / "reference.log"
            log.write_text("")
            begin = time.monotonic()
            code, text = hfrac("run", case, "-o", folder, "-q", fault=("none", 0, 0, folder, log))
            if code != 0:
                raise Wrong(f"the undisturbed run of {name} failed: {text}")
            outside = [line for line in log.read_text().splitlines() if line.startswith("outside ")]
            if outside:
                raise Wrong(f"the run wrote outside its folder: {outside}")
            calls = int(re.findall(r"^calls (\d+)$", log.read_text(), re.M)[-1])
            self.references[name] = (case, folder, calls, time.monotonic() - begin)
        return self.references[name]

    def disturb(self, name, folder, arguments):
        """One run or resume that something happens to. Its exit code."""
        _, _, calls, seconds = self.reference(name)
        kind = self.dice.choices(("timed", "kill", "eio", "full", "short"), (30, 40, 15, 10, 5))[0]
        log = self.top / "fault.log"
        log.write_text("")
        if kind == "timed":
            code, text = hfrac(*arguments, after=self.dice.uniform(0.02, seconds))
        else:
            call, share = self.dice.randint(1, calls), self.dice.choice((0, 1, 30, 70, 99))
            code, text = hfrac(*arguments, fault=(kind, call, share, folder, log))
        self.done["disturbances"] += 1
        self.done["kinds"][kind] = self.done["kinds"].get(kind, 0) + 1
        for place in re.findall(r"^fault (.+)$", log.read_text(), re.M):
            self.done["places"][place] = self.done["places"].get(place, 0) + 1
        if code not in (0, 1, 2, -signal.SIGKILL):
            raise Wrong(f"{kind}: exit status {code}: {text}")
        if code == 1 and not text.strip():
            raise Wrong(f"{kind}: failed without a word")
        if code == 0 and kind in ("eio", "full") and "fault" in log.read_text():
            # Only a checkpoint may be lost while the run goes on, and that is said. A folder's sync counts as one.
            if "no checkpoint" not in text:
                raise Wrong(f"{kind}: went wrong and nobody was told")
        return code

    def trial(self, number):
        name = list(CASES)[number % len(CASES)]
        case, reference, _, _ = self.reference(name)
        folder = self.top / "run"
        shutil.rmtree(folder, ignore_errors=True)
        arguments = ("run", case, "-o", folder, "-q")
        code = self.disturb(name, folder, arguments)
        for _ in range(self.dice.choice((0, 0, 1, 2))):
            if folder.exists():
                check_present(folder, reference)
            if not (folder / "summary.json").exists():
                break
            code = self.disturb(name, folder, ("resume", folder, "-q"))
            self.done["resumed"] += 1
        if folder.exists():
            check_present(folder, reference)
        if (folder / "summary.json").exists():
            code, text = hfrac("resume", folder, "-q")
            self.done["resumed"] += 1
        else:
            if folder.exists():
                code, text = hfrac("resume", folder, "-q")
                if code != 2 or "had begun" not in text:
                    raise Wrong(f"resume of what had not begun: {code} {text}")
            code, text = hfrac("run", case, "-o", folder, "-q", "--overwrite")
            self.done["begun_anew"] += 1
        if code != 0:
            raise Wrong(f"the last resume failed: {text}")
        check_end(folder, reference)
        self.done["trials"] += 1
        self.done["cases"][name] = self.done["cases"].get(name, 0) + 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, required=True, help="trials")
    parser.add_argument("--seed", type=int, default=20261121)
    parser.add_argument("--first", type=int, default=0, help="begin at this trial, to see one again")
    request = parser.parse_args()
    begin = shown = time.monotonic()
    wrong = []
    with tempfile.TemporaryDirectory(prefix="hfrac-crash-") as top:
        campaign = Campaign(pathlib.Path(top), f"{request.seed}-{request.first}")
        for number in range(request.first, request.count):
            campaign.dice = random.Random(f"{request.seed}-{number}")  # so that a trial can be had alone
            try:
                campaign.trial(number)
            except Wrong as error:
                wrong.append(f"trial {number}: {error}")
                print(f"WRONG in trial {number} (--first {number} --count {number + 1}): {error}", flush=True)
            if time.monotonic() - shown > 10:
                shown = time.monotonic()
                done = number + 1 - request.first
                left = (shown - begin) / done * (request.count - number - 1)
                print(f"{done} of {request.count - request.first} trials, about {left:.0f} s left", flush=True)
        campaign.done["seconds"] = round(time.monotonic() - begin, 1)
        campaign.done["wrong"] = wrong
        print(json.dumps(campaign.done, indent=1))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
