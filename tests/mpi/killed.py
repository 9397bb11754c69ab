#!/usr/bin/python3
"""Runs on four processes, one of which is killed at a random moment: all end within 30 s, and the run, gone on with on another number of
processes and killed again and again, ends with the files of one that nobody disturbed.

usage: tests/mpi/killed.py [--times N] [--seed S]
"""
import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from over_ranks import CASE, ENVIRONMENT, HFRAC, over, run


def processes_of(launcher):
    return [int(line) for line in subprocess.run(["pgrep", "-P", str(launcher)], capture_output=True, text=True).stdout.split()]


def disturbed(command, wait, chance):
    """Seconds from the kill to the end of all, or None where the run was over first."""
    launcher = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(wait)
    ranks = processes_of(launcher.pid)
    if launcher.poll() is not None or not ranks:
        launcher.wait()
        return None
    try:
        os.kill(chance.choice(ranks), signal.SIGKILL)
    except ProcessLookupError:  # it was over while its processes were listed
        launcher.wait()
        return None
    began = time.monotonic()
    launcher.wait(timeout=30)
    return time.monotonic() - began


def results(folder):
    return {p.name: p.read_bytes() for p in sorted(folder.iterdir()) if p.suffix in (".csv", ".vtu", ".pvd")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    chance = random.Random(chosen.seed)
    longest, kills, courses = 0.0, 0, 0
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        case = place / "case.toml"
        case.write_text(CASE.replace("checkpoint_steps = 2", "checkpoint_steps = 1"))
        began = time.monotonic()
        done = run([HFRAC, "run", case, "-o", place / "alone", "-q"])
        assert done.returncode == 0, done.stderr
        whole = time.monotonic() - began
        wanted = results(place / "alone")
        while kills < chosen.times:
            folder = place / f"course-{courses}"
            courses += 1
            seconds = disturbed(over(4, HFRAC, "run", case, "-o", folder, "-q"), chance.uniform(0.3, 3.0 * whole), chance)
            while seconds is not None and kills < chosen.times:
                kills += 1
                longest = max(longest, seconds)
                if not (folder / "summary.json").exists():  # killed before it began
                    break
                seconds = disturbed(over(chance.choice((1, 2, 3, 5)), HFRAC, "resume", folder, "-q"),
                                    chance.uniform(0.3, 3.0 * whole), chance)
            if not (folder / "summary.json").exists():
                continue
            done = run(over(chance.choice((1, 2, 3)), HFRAC, "resume", folder, "-q"))
            assert done.returncode == 0, done.stderr
            got = results(folder)
            assert got.keys() == wanted.keys(), f"{folder.name} has other files: {sorted(got.keys() ^ wanted.keys())}"
            for name, content in wanted.items():
                assert got[name] == content, f"{name} of {folder.name} differs"
    print(f"{kills} kills in {courses} runs: all processes gone after {longest:.1f} s at most, ends as if undisturbed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
