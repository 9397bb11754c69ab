# SPDX-License-Identifier: BSD-3-Clause
"""`hfrac match`: parameters that explain a record, as an ensemble before and after it (esmda.py).

Parameters are moved as normal scores, z = Phi^-1(share below the value), so that every prior is normal with deviation 1 and no value leaves
its law. What the record tells of a parameter is the deviation of its scores after over before; above `unconstrained_above`,
which stands in the study file, it tells nothing that counts, and match says so.

With several packings the ensemble is spread over them, and their scatter at the laws' medians belongs to the error (scatter.py, esmda.py).
"""
import pathlib
from typing import Callable, Dict, Iterator, List, NamedTuple, Optional, Tuple

import numpy as np
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

from . import charts
from .cases import Run, runs_of, settled
from .esmda import update
from .match_file import Data, Match
from .measures import column, history
from .pool import Pool
from .progress import Progress
from .scatter import Scatter, scatter_of
from .statistics import percentiles
from .study_file import Study, StudyError
from .tables import write_csv


EXPLAINED = 2.0  # root mean square misfit of a posterior, in errors, above which its spread says nothing of the rock


class Ensemble(NamedTuple):
    """Members and what they predict: rows are members."""

    shares: np.ndarray
    predicted: np.ndarray


class Outcome(NamedTuple):
    """The ensemble before and after; members of which a run failed are in neither."""

    prior: Ensemble
    posterior: Ensemble
    failed: int
    #: standard deviation of each point: that of the data and what packings scatter
    errors: np.ndarray
    scatter: Optional[Scatter]


def predict(folder: pathlib.Path, data: Match) -> np.ndarray:
    """A run's values at the record's times; a run that ended before keeps its last."""
    table = history(folder)
    return np.concatenate([np.interp(one.time, table["time_s"], column(table, one.column)) for one in data.data])


def match(study: Study, task: Match, folder: pathlib.Path, pool: Pool, progress: Progress, again: bool,
          say: Callable[[str], None]) -> Optional[Outcome]:
    """Runs the ensembles; None: interrupted. What is done stays done, and the random numbers are those of the study's seed."""
    settings, random = settled(study), np.random.default_rng(study.seed)
    size = len(study.parameters)
    scores = ndtri(np.clip(qmc.LatinHypercube(size, seed=study.seed).random(task.members), 1e-6, 1.0 - 1e-6))
    values = np.concatenate([one.value for one in task.data])
    errors = np.concatenate([np.full(len(one.value), one.error) for one in task.data])
    count = len(study.packings)
    scatter = packing = None
    if count > 1:
        scatter = _scatter(study, task, runs_of(study, np.full((1, size), 0.5), folder / "packings", settings), pool, again)
        if scatter is None:
            return None
    whole = errors if scatter is None else np.sqrt(errors ** 2 + np.diag(scatter.unseen))
    ensembles: List[Ensemble] = []
    lost, done_before = 0, count if scatter else 0
    for iteration in range(task.iterations + 1):
        shares = ndtr(scores)
        if scatter is not None:
            packing = random.permutation(len(scores)) % count
        runs = runs_of(study, shares, folder / f"iteration_{iteration}", settings, packing)
        progress.offset = done_before
        known = pool.work(runs, again)
        if pool.stopped:
            return None
        done_before += len(runs)
        good = [run.index for run in runs if known[run.index].status == "done"]
        for run in runs[:] if len(good) < max(10, task.members // 2) else []:
            if known[run.index].status == "failed":
                raise StudyError(f"{len(runs) - len(good)} of {len(runs)} members failed, too many to go on; one says: {known[run.index].sentence}")
        lost += len(runs) - len(good)
        scores = scores[good]
        packing = None if packing is None else packing[good]
        predicted = np.array([predict(runs[index].folder, task) for index in good])
        ensembles.append(Ensemble(ndtr(scores), predicted))
        misfit = np.mean(((predicted - values) / whole) ** 2)
        say(f"pass {iteration} of {task.iterations}: mean squared misfit {misfit:.3g} of the errors' variance")
        if iteration < task.iterations:
            scores = update(scores, predicted, values, errors, float(task.iterations), random, scatter, packing)
    return Outcome(ensembles[0], ensembles[-1], lost, whole, scatter)


def _scatter(study: Study, task: Match, runs: List[Run], pool: Pool, again: bool) -> Optional[Scatter]:
    """Of the data over packings, from a run in each; None: interrupted."""
    known = pool.work(runs, again)
    if pool.stopped:
        return None
    for run in runs:
        if known[run.index].status == "failed":
            raise StudyError(f"packing {run.packing} of {list(study.packings)} fails at the laws' medians, leave it out: {known[run.index].sentence}")
    return scatter_of(np.array([predict(run.folder, task) for run in runs]))


def report(study: Study, task: Match, folder: pathlib.Path, outcome: Outcome) -> List[str]:
    """Writes parameters.csv, members.csv, match.png; gives the lines to print."""
    names = [one.name for one in study.parameters]
    before, after = ndtri(outcome.prior.shares), ndtri(outcome.posterior.shares)
    ratios = after.std(axis=0, ddof=1) / before.std(axis=0, ddof=1)
    values = np.concatenate([one.value for one in task.data])
    misfit = float(np.sqrt(np.mean(((outcome.posterior.predicted - values) / outcome.errors) ** 2)))
    rows, lines = [], [f"{'':34} {'P10':>11} {'P50':>11} {'P90':>11}   posterior / prior deviation"]
    for k, one in enumerate(study.parameters):
        told = "record not explained" if misfit > EXPLAINED else "constrained" if ratios[k] <= task.unconstrained_above else "not constrained by the data"
        for word, shares in (("prior", outcome.prior.shares), ("posterior", outcome.posterior.shares)):
            found = percentiles(np.array([one.value(float(share)) for share in shares[:, k]]))
            rows.append([one.name, word, *found, ratios[k] if word == "posterior" else 1.0, told if word == "posterior" else ""])
            tail = f"   {ratios[k]:.2f}, {told}" if word == "posterior" else ""
            lines.append(f"{one.name:24} {word:9} " + " ".join(f"{value:11.4g}" for value in found) + tail)
    write_csv(folder / "parameters.csv", ["parameter", "ensemble", "P10", "P50", "P90", "deviation_ratio", "verdict"], rows)
    write_csv(folder / "members.csv", ["ensemble", *names], [
        [word, *(one.value(float(share)) for one, share in zip(study.parameters, shares))]
        for word, ensemble in (("prior", outcome.prior), ("posterior", outcome.posterior)) for shares in ensemble.shares])
    tied = _tied(names, after)
    loose = [name for name, ratio in zip(names, ratios) if ratio > task.unconstrained_above]
    if loose:
        lines.append(f"the data do not constrain {', '.join(loose)}: the deviation stays above {task.unconstrained_above:g} of the prior's")
    if tied:
        lines.append("told together more than one by one (correlation of the posterior): " + ", ".join(tied))
    if outcome.scatter is not None:
        lines.extend(_scattering(task, outcome))
    if outcome.failed:
        lines.append(f"{outcome.failed} members failed and were left out")
    lines.append(f"root mean square misfit of the posterior: {misfit:.2f} of the errors; 1 to 1.5 is what errors explain")
    if misfit > EXPLAINED:
        lines.append("the record is not explained, so the values above are no estimate, however narrow: model and rock differ by more than the "
                     "data's error" + ("" if outcome.scatter else ", which has to hold the scatter of packings (packings = [...] measures it)") +
                     "; raise error, widen the laws, or leave out what the model does not hold (from, until)")
    if charts.available():
        draw(study, task, folder / "match.png", outcome)
    else:
        lines.append("no chart is drawn: apt-get install python3-matplotlib")
    return [*lines, f"parameters.csv, members.csv and match.png are in '{folder}'"]


def _parts(task: Match) -> Iterator[Tuple[Data, slice]]:
    """Each of the data, and where its points lie among all."""
    first = 0
    for one in task.data:
        yield one, slice(first, first + len(one.time))
        first += len(one.time)


def _scattering(task: Match, outcome: Outcome) -> List[str]:
    """How large the scatter of packings is in each of the data."""
    lines = []
    variance = np.diag(outcome.scatter.covariance)
    for one, part in _parts(task):
        lines.append(f"{one.column}: {outcome.scatter.packings} packings scatter by {np.sqrt(variance[part].mean()):.3g} (rms over the record), "
                     f"beside an error of {one.error:.3g}; both count")
    lines.append(f"correlations of that scatter are shrunk by {outcome.scatter.shrinkage:.2f} (0: enough packings)")
    return lines


def _tied(names: List[str], scores: np.ndarray) -> List[str]:
    if len(names) < 2:
        return []
    table = np.corrcoef(scores.T)
    return [f"{names[i]} and {names[j]} {table[i, j]:.2f}" for i in range(len(names)) for j in range(i) if abs(table[i, j]) > 0.8]


def draw(study: Study, task: Match, path: pathlib.Path, outcome: Outcome) -> None:
    """The record with prior and posterior runs above, the parameters before and after below."""
    plt = charts.pyplot()
    columns = max(len(task.data), len(study.parameters))
    figure = plt.figure(figsize=(max(6.5, 2.7 * columns), 5.4))
    grid = figure.add_gridspec(2, len(task.data) * len(study.parameters), height_ratios=[1.5, 1.0])
    for place, (one, part) in enumerate(_parts(task)):
        axis = figure.add_subplot(grid[0, place * len(study.parameters):(place + 1) * len(study.parameters)])
        _curves(axis, one, outcome.errors[part], {"prior": outcome.prior.predicted[:, part], "posterior": outcome.posterior.predicted[:, part]})
    for place, one in enumerate(study.parameters):
        axis = figure.add_subplot(grid[1, place * len(task.data):(place + 1) * len(task.data)])
        logarithmic = one.law in ("loguniform", "lognormal")
        for shares, colour in ((outcome.prior.shares, charts.GREY), (outcome.posterior.shares, charts.BLUE)):
            values = np.array([one.value(float(share)) for share in shares[:, place]])
            counts, edges = np.histogram(np.log10(values) if logarithmic else values, bins=12)
            axis.bar(edges[:-1], counts / counts.max(), np.diff(edges), align="edge", color=colour, alpha=0.55)
        axis.set_xlabel(f"log10 {one.name}" if logarithmic else one.name)
        axis.set_yticks([])
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)


def _curves(axis: object, one: Data, errors: np.ndarray, predicted: Dict[str, np.ndarray]) -> None:
    label, factor = charts.shown(one.column)
    for word, colour in (("prior", charts.GREY), ("posterior", charts.BLUE)):
        low, middle, high = (np.percentile(predicted[word], level, axis=0) * factor for level in (10.0, 50.0, 90.0))
        axis.fill_between(one.time, low, high, color=colour, alpha=0.3, linewidth=0.0, label=f"{word}, P10 to P90")
        axis.plot(one.time, middle, color=colour, linewidth=1.0)
    axis.errorbar(one.time, one.value * factor, errors * factor, fmt=".", color=charts.RED, markersize=3.0, linewidth=0.6,
                  label="record")
    axis.set_xlabel("time [s]")
    axis.set_ylabel(label)
    axis.legend(frameon=False, fontsize=8.0)
