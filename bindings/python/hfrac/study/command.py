# SPDX-License-Identifier: BSD-3-Clause
"""The two commands: their arguments, the pool behind them, and what is said at the end."""
import argparse
import os
import pathlib
import re
import resource
import shutil
import signal
import sys
from typing import Dict, Iterable, List

from . import match, slurm, statistics, sweep
from .match_file import read_match
from .measures import read_table
from .pool import Pool, Result, lock, result_of
from .progress import Progress, duration
from .study_file import Study, StudyError, read_study

GOOD, FAILED, INTERRUPTED = 0, 1, 130


def hfrac_command() -> str:
    """The program that runs the cases: the one that started this, that of the build tree, or the one on the PATH."""
    named = os.environ.get("HFRAC_COMMAND")
    built = pathlib.Path(__file__).resolve().parents[4] / "build/bin/hfrac"
    found = named or (str(built) if built.exists() else shutil.which("hfrac"))
    if not found:
        raise StudyError("the command hfrac was not found; name it in HFRAC_COMMAND")
    return found


def parser() -> argparse.ArgumentParser:
    cores = len(os.sched_getaffinity(0))
    top = argparse.ArgumentParser(prog="hfrac", description="Studies of many runs; docs/studies.md has the study file.")
    commands = top.add_subparsers(dest="command", required=True)
    for name, text in (("sweep", "Run a case with many values and packings: table, percentiles, tornado chart, Sobol indices"),
                       ("match", "Find the parameters of a case that explain a record, and how far it tells them")):
        one = commands.add_parser(name, help=text, description=text)
        one.add_argument("study", metavar="STUDY", type=pathlib.Path, help="study file (TOML)")
        one.add_argument("-o", "--output", metavar="DIR", type=pathlib.Path, help="folder to write; out/STUDY otherwise")
        one.add_argument("--jobs", type=int, default=cores, metavar="N", help="runs at a time; all cores otherwise")
        one.add_argument("--retry", action="store_true", help="run once more what failed")
        one.add_argument("-q", "--quiet", action="store_true", help="no progress")
        if name == "sweep":
            one.add_argument("--collect", action="store_true", help="run nothing: table and charts of what is there")
            one.add_argument("--only", metavar="LIST", help="only these runs (0-19,25), and no table")
            slurm.add_arguments(one)
    return top


def carry_out(words: List[str]) -> int:
    asked = parser().parse_args(words)
    if asked.jobs < 1:
        raise StudyError(f"--jobs {asked.jobs} must be at least 1")
    study = read_study(asked.study)
    folder = asked.output or pathlib.Path("out", asked.study.stem)
    return run_sweep(asked, study, folder) if asked.command == "sweep" else run_match(asked, study, folder)


def _pool(asked: argparse.Namespace, study: Study, held: int, progress: Progress) -> Pool:
    pool = Pool(hfrac_command(), asked.jobs, study.keep_fields, held, progress)
    for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(one, pool.stop)
    return pool


def _say(asked: argparse.Namespace, text: str) -> None:
    if not asked.quiet:
        print(text, file=sys.stderr)


def _cost(pool: Pool) -> str:
    """Processor time, which says more than the clock where others use the machine."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return f"{pool.fresh} runs took {duration(used.ru_utime + used.ru_stime)} of a processor"


def _interrupted(folder: pathlib.Path) -> int:
    print(f"hfrac: interrupted; what is done stays in '{folder}', and the same command goes on", file=sys.stderr)
    return INTERRUPTED


def run_sweep(asked: argparse.Namespace, study: Study, folder: pathlib.Path) -> int:
    plan = sweep.plan(study, folder)
    if asked.slurm:
        return slurm.submit(asked, plan, hfrac_command())
    runs = plan.runs
    if asked.only is not None:
        runs = [plan.runs[index] for index in slurm.indices(asked.only, len(plan.runs))]
    if not asked.collect:
        held = lock(folder, "lock" if asked.only is None else f"lock-{runs[0].index}")
        known = sum(result_of(run) is not None for run in runs)
        _say(asked, f"{len(runs)} runs into '{folder}', {asked.jobs} at a time" + (f"; {known} are there already" if known else ""))
        progress = Progress(len(runs), asked.quiet)
        pool = _pool(asked, study, held, progress)
        pool.work(runs, asked.retry)
        progress.end()
        if pool.stopped:
            return _interrupted(folder)
        _say(asked, _cost(pool))
    if asked.only is not None:
        return GOOD
    folder.mkdir(parents=True, exist_ok=True)
    known_results = sweep.results(plan)
    for sentence in sweep.report(plan, known_results):
        _say(asked, f"hfrac: {sentence}")
    _tell_failures(known_results, len(plan.runs), folder)
    if any(one.status == "done" for one in known_results.values()):
        _print_percentiles(folder)
        return GOOD
    return FAILED


def _tell_failures(known: Dict[int, Result], total: int, folder: pathlib.Path) -> None:
    failed = {index: one for index, one in known.items() if one.status == "failed"}
    alike: Dict[str, List[int]] = {}
    for index, one in failed.items():
        alike.setdefault(re.sub(r"[-+.\d]+(e[-+]?\d+)?", "#", one.sentence), []).append(index)
    for indices in sorted(alike.values(), key=len, reverse=True)[:10]:
        print(f"hfrac: {len(indices)} of {total} runs failed, as run {indices[0]} ('{folder}/runs/{indices[0]:05d}'): "
              f"{failed[indices[0]].sentence}", file=sys.stderr)
    if failed:
        print("hfrac: --retry runs once more what failed", file=sys.stderr)
    if len(known) < total:
        print(f"hfrac: {total - len(known)} of {total} runs are missing; the same command without --collect does them", file=sys.stderr)


def _print_percentiles(folder: pathlib.Path) -> None:
    table = read_table(folder / "percentiles.csv")
    names = [line.partition(",")[0] for line in (folder / "percentiles.csv").read_text().splitlines()[1:]]
    print(f"{'':28} {'runs':>5} " + " ".join(f"{'P%g' % level:>12}" for level in statistics.LEVELS))
    for row, name in enumerate(names):
        values: Iterable[float] = (table[f"P{level:g}"][row] for level in statistics.LEVELS)
        print(f"{name:28} {table['runs'][row]:5.0f} " + " ".join(f"{value:12.5g}" for value in values))
    print(f"table, percentiles, sensitivity and charts are in '{folder}'")


def run_match(asked: argparse.Namespace, study: Study, folder: pathlib.Path) -> int:
    task = read_match(study)
    held = lock(folder)
    medians = len(study.packings) if len(study.packings) > 1 else 0
    progress = Progress(medians + task.members * (task.iterations + 1), asked.quiet, "runs of the ensembles")
    pool = _pool(asked, study, held, progress)
    outcome = match.match(study, task, folder, pool, progress, asked.retry, lambda text: _say(asked, text))
    progress.end()
    if outcome is None:
        return _interrupted(folder)
    print("\n".join(match.report(study, task, folder, outcome)))
    return GOOD
