# SPDX-License-Identifier: BSD-3-Clause
"""Designs: which points of the unit cube are run.

Low-discrepancy points and Latin hypercubes are those of scipy.stats.qmc (scrambled Sobol points, Owen 1998; Joe and Kuo 2008
directions). *saltelli* is the design of Saltelli et al. (2010) for first and total order indices: matrices A and B of N points
and, for every parameter i, A with the column i of B: N (k + 2) runs. *one-at-a-time* is the tornado chart's: the medians, and
each parameter alone at its P10 and P90.
"""
import itertools
import warnings

import numpy as np
from scipy.stats import qmc

from .study_file import Study, StudyError

MOST = 10_000_000


def saltelli(sobol: np.ndarray) -> np.ndarray:
    """A, B, then A with one column of B for each column: rows (k + 2) N of N points in 2 k dimensions."""
    size = sobol.shape[1] // 2
    a, b = sobol[:, :size], sobol[:, size:]
    blocks = [a, b]
    for column in range(size):
        mixed = a.copy()
        mixed[:, column] = b[:, column]
        blocks.append(mixed)
    return np.concatenate(blocks)


def _sobol(dimension: int, count: int, seed: int) -> np.ndarray:
    with warnings.catch_warnings():  # counts that are no power of two are the user's; docs/studies.md says what they lose
        warnings.simplefilter("ignore")
        return qmc.Sobol(dimension, scramble=True, seed=seed).random(count)


def design(study: Study) -> np.ndarray:
    """The points, a row each, a column per parameter, between 0 and 1."""
    size, count, seed = len(study.parameters), study.runs, study.seed
    if study.sampling == "sobol":
        return _sobol(size, count, seed)
    if study.sampling == "latin-hypercube":
        return qmc.LatinHypercube(size, seed=seed).random(count)
    if study.sampling == "random":
        return np.random.default_rng(seed).random((count, size))
    if study.sampling == "saltelli":
        each = count // (size + 2)
        if each < 2:
            raise StudyError(f"runs = {count} must be at least {2 * (size + 2)}, twice the parameters and two, for saltelli")
        return saltelli(_sobol(2 * size, each, seed))
    if study.sampling == "one-at-a-time":
        points = np.full((1 + 2 * size, size), 0.5)
        for column in range(size):
            points[1 + 2 * column, column], points[2 + 2 * column, column] = 0.1, 0.9
        return points
    axes = [parameter.grid() for parameter in study.parameters]
    total = 1
    for axis in axes:
        total *= len(axis)
    if total > MOST:
        raise StudyError(f"the grid has {total} points; lower levels so that there are at most {MOST}")
    return np.array(list(itertools.product(*axes)))
