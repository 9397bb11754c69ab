# SPDX-License-Identifier: BSD-3-Clause
"""A study on a cluster with Slurm: one array job, several runs a task, and a job after it that makes the table.

A scheduler does not like jobs of seconds, so --runs-per-job runs go into one task of the array, --cpus of them at a time. Tasks
are submitted with --requeue: what a lost node leaves undone is begun again, and what was done stays done (pool.py). Two minutes
before its time is over a task has its runs write checkpoints and puts itself back into the queue. The same command once more
submits only what is missing, with --retry also what failed.
"""
import argparse
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
from typing import List

from .pool import result_of, write_whole
from .study_file import StudyError
from .sweep import Plan

TASK = """#!/bin/bash
#SBATCH --job-name=hfrac-study
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:USR1@120
part=$(sed -n "$((SLURM_ARRAY_TASK_ID + 1))p" {parts})
export HFRAC_COMMAND={command} PYTHONPATH={path}${{PYTHONPATH:+:$PYTHONPATH}}
{python} -m hfrac.study sweep {study} -o {folder} --only "$part" --jobs "${{SLURM_CPUS_PER_TASK:-1}}"{retry} -q &
work=$!
again() {{
  kill -TERM "$work"
  wait "$work"
  scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
}}
trap again USR1
wait "$work"
"""
TABLE = """#!/bin/bash
#SBATCH --job-name=hfrac-table
#SBATCH --requeue
export HFRAC_COMMAND={command} PYTHONPATH={path}${{PYTHONPATH:+:$PYTHONPATH}}
exec {python} -m hfrac.study sweep {study} -o {folder} --collect -q
"""


def add_arguments(one: argparse.ArgumentParser) -> None:
    part = one.add_argument_group("on a cluster")
    part.add_argument("--slurm", action="store_true", help="submit an array job by sbatch, and a job that makes the table")
    part.add_argument("--runs-per-job", type=int, default=20, metavar="N", help="runs a task of the array does (20)")
    part.add_argument("--cpus", type=int, default=1, metavar="N", help="of them at a time (1)")
    part.add_argument("--minutes", type=int, default=60, metavar="N", help="time of a task (60)")
    part.add_argument("--memory", type=int, default=1000, metavar="MB", help="memory of a task per cpu (1000)")
    part.add_argument("--sbatch", default="", metavar="WORDS", help="further words for sbatch: --sbatch=\"--account=mine --partition=short\"")


def indices(text: str, total: int) -> List[int]:
    """0-19,25 as numbers. Raises StudyError."""
    found: List[int] = []
    for piece in text.split(","):
        first, dash, last = piece.partition("-")
        try:
            found += range(int(first), int(last if dash else first) + 1)
        except ValueError:
            raise StudyError(f"--only {text!r} must be numbers of runs as in 0-19,25") from None
    if not found or min(found) < 0 or max(found) >= total:
        raise StudyError(f"--only {text!r} must name runs from 0 to {total - 1}")
    return found


def ranges(numbers: List[int]) -> str:
    """The inverse of `indices`."""
    pieces: List[List[int]] = []
    for number in numbers:
        if pieces and number == pieces[-1][1] + 1:
            pieces[-1][1] = number
        else:
            pieces.append([number, number])
    return ",".join(f"{first}" if first == last else f"{first}-{last}" for first, last in pieces)


def submit(asked: argparse.Namespace, plan: Plan, command: str) -> int:
    """Writes the job scripts into DIR/slurm and submits them."""
    if shutil.which("sbatch") is None:
        raise StudyError("--slurm: there is no sbatch on the PATH; submit from a node of the cluster, or leave --slurm out")
    if asked.minutes < 5:
        raise StudyError(f"--minutes {asked.minutes} must be at least 5: a task puts itself back into the queue 2 minutes before its end")
    missing = []
    for run in plan.runs:
        known = result_of(run)
        if known is None or (asked.retry and known.status == "failed"):
            missing.append(run.index)
    size = max(1, asked.runs_per_job)
    parts = [missing[first:first + size] for first in range(0, len(missing), size)]
    if len(parts) > 1000:
        raise StudyError(f"--runs-per-job {size} makes {len(parts)} tasks, and Slurm allows an array some 1000; "
                         f"take at least {-(-len(missing) // 1000)}")
    folder = (plan.folder / "slurm").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    fill = {"command": command, "path": str(pathlib.Path(__file__).resolve().parents[2]), "python": sys.executable,
            "study": str(plan.study.path.resolve()), "folder": str(plan.folder.resolve()), "parts": str(folder / "parts.txt")}
    fill = {name: shlex.quote(value) for name, value in fill.items()}
    write_whole(folder / "parts.txt", "".join(ranges(part) + "\n" for part in parts))
    write_whole(folder / "task.sh", TASK.format(**fill, retry=" --retry" if asked.retry else ""))
    write_whole(folder / "table.sh", TABLE.format(**fill))
    more = shlex.split(asked.sbatch)
    after: List[str] = []
    if parts:
        array = _sbatch([f"--array=0-{len(parts) - 1}", f"--cpus-per-task={asked.cpus}", f"--mem-per-cpu={asked.memory}",
                         f"--time={asked.minutes}", f"--output={folder}/task-%a.log", *more, str(folder / "task.sh")])
        after = [f"--dependency=afterany:{array}"]
        print(f"job {array}: {len(missing)} runs in {len(parts)} tasks of up to {size}")
    table = _sbatch([*after, "--time=60", f"--output={folder}/table.log", *more, str(folder / "table.sh")])
    print(f"job {table}: the table in '{plan.folder}', when they are over")
    return 0


def _sbatch(words: List[str]) -> str:
    done = subprocess.run(["sbatch", "--parsable", *words], capture_output=True, text=True, env=os.environ)
    if done.returncode != 0:
        raise StudyError(f"--slurm: sbatch refused: {done.stderr.strip()}")
    return done.stdout.strip().partition(";")[0]
