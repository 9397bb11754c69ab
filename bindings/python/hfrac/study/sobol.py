# SPDX-License-Identifier: BSD-3-Clause
"""Sobol indices: which share of a result's variance a parameter explains alone (first order), and with all it acts together
with (total order).

On the saltelli design by the estimators that Saltelli et al. recommend (2010, Comput. Phys. Commun. 181, 259-270, table 2):

    first order  S_i  = 1/N sum_j f(B)_j (f(A_B^i)_j - f(A)_j) / V
    total order  ST_i = 1/(2N) sum_j (f(A)_j - f(A_B^i)_j)^2 / V        (Jansen 1999)

with V the variance over A and B. f is taken about its mean, which leaves the expectation as it is and lessens the scatter.
From any other sample only the first order can be had, as the variance of the mean of f over classes of the parameter
(Plischke, Borgonovo and Smith 2013, Eur. J. Oper. Res. 226, 536-550), less what classes of so few runs vary by themselves.
"""
from typing import Optional, Tuple

import numpy as np


def saltelli_indices(results: np.ndarray, size: int) -> Tuple[np.ndarray, np.ndarray]:
    """First and total order of `size` parameters from the results in the order of designs.py: saltelli. Points of which a
    run failed (nan) are left out, for each parameter those it needs."""
    blocks = results.reshape(size + 2, -1)
    a, b = blocks[0], blocks[1]
    sound = np.isfinite(a) & np.isfinite(b)
    both = np.concatenate([a[sound], b[sound]])
    variance = both.var() if sound.any() else 0.0
    first, total = np.full(size, np.nan), np.full(size, np.nan)
    for i in range(size):
        mixed = blocks[2 + i]
        good = sound & np.isfinite(mixed)
        if good.sum() < 2 or not variance > 0.0:
            continue
        first[i] = np.mean((b[good] - both.mean()) * (mixed[good] - a[good])) / variance
        total[i] = 0.5 * np.mean((a[good] - mixed[good]) ** 2) / variance
    return first, total


def sample_index(shares: np.ndarray, results: np.ndarray, classes: Optional[int] = None) -> float:
    """First order of one parameter from a plain sample: between-class variance, corrected for the scatter inside."""
    good = np.isfinite(results)
    x, y = shares[good], results[good]
    count = len(y)
    if count < 10 or not y.var() > 0.0:
        return float("nan")
    classes = classes or max(3, min(20, round(count ** 0.5)))
    parts = [part for part in np.array_split(np.argsort(x, kind="stable"), classes) if len(part)]
    between = sum(len(part) * (y[part].mean() - y.mean()) ** 2 for part in parts)
    within = sum(((y[part] - y[part].mean()) ** 2).sum() for part in parts)
    noise = within / (count - len(parts)) * (len(parts) - 1)
    return float(max(0.0, (between - noise) / (between + within)))
