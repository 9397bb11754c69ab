# SPDX-License-Identifier: BSD-3-Clause
"""How far packings are apart: the covariance Q of the data over packings, from one run in each at the laws' medians.

A record comes from a packing that the ensemble has not, so no member can explain it better than packings explain each other. Of k
packings Q is the sample covariance with its correlations shrunk towards none by the share that makes the expected squared error least,

    lambda = sum Var(r_ij) / sum r_ij^2 over i != j,   r*_ij = (1 - lambda) r_ij

(Schaefer and Strimmer 2005, Stat. Appl. Genet. Mol. Biol. 4, 32): k - 1 directions are all that a sample of k tells, and lambda Q_ii
stands for the others. A new packing differs from the mean of these k by Q (1 + 1/k); predictions of members dealt evenly over them differ
from that mean by Q (1 - 1/k).
"""
from typing import NamedTuple, Tuple

import numpy as np


class Scatter(NamedTuple):
    """Of the data over packings."""

    covariance: np.ndarray
    packings: int
    #: lambda
    shrinkage: float = 0.0

    @property
    def unseen(self) -> np.ndarray:
        """Of a new packing about the mean of these."""
        return self.covariance * (1.0 + 1.0 / self.packings)

    @property
    def dealt(self) -> np.ndarray:
        """Of members dealt evenly over these, about their mean."""
        return self.covariance * (1.0 - 1.0 / self.packings)


def shrunk(samples: np.ndarray) -> Tuple[np.ndarray, float]:
    """Covariance of rows of samples with its correlations shrunk, and lambda."""
    count = len(samples)
    deviation = samples.std(axis=0, ddof=1)
    scaled = (samples - samples.mean(axis=0)) / np.where(deviation > 0.0, deviation, 1.0)
    products = scaled[:, :, None] * scaled[:, None, :]
    mean = products.mean(axis=0)
    correlation = count / (count - 1) * mean
    variance = count / (count - 1) ** 3 * ((products - mean) ** 2).sum(axis=0)
    beside = ~np.eye(len(deviation), dtype=bool)
    whole = (correlation[beside] ** 2).sum()
    share = float(np.clip(variance[beside].sum() / whole, 0.0, 1.0)) if whole > 0.0 else 1.0
    correlation[beside] *= 1.0 - share
    return correlation * np.outer(deviation, deviation), share


def scatter_of(predicted: np.ndarray) -> Scatter:
    """From predictions of one set of values, a row per packing."""
    covariance, share = shrunk(predicted)
    return Scatter(covariance, len(predicted), share)
