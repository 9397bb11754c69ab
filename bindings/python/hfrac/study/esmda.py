# SPDX-License-Identifier: BSD-3-Clause
"""Ensemble smoother with multiple data assimilation (ES-MDA; Emerick and Reynolds 2013, Computers & Geosciences 55, 3-15).

An ensemble of parameters, each member run through the model, is moved towards the data by what the ensemble itself tells of how
data go with parameters:

    m_j <- m_j + C_MD (C_DD + a C_D)^-1 (d + sqrt(a) C_D^(1/2) z_j - g(m_j)),   z_j normal,   sum over passes of 1 / a = 1

with C_MD and C_DD the covariances of parameters and data over the ensemble, C_D that of the data's errors (here independent).
Several passes with errors made larger by a = number of passes follow a model that is not linear better than one pass with the
errors as they are; for a linear model both give the exact posterior as the ensemble grows.

With members dealt anew over k packings in every pass (scatter.py), predictions are g(m_j) + e_j with e_j that packing's. C_MD and C_DD
are then taken about each packing's own mean, so that they hold how data go with parameters and no e; the data's error is that of gauge
and packing, E = C_D + Q (1 + 1/k); and since the residual of a member holds e_j, whose covariance is Q (1 - 1/k), z_j makes up the rest:

    m_j <- m_j + C_MD (C_DD + a E)^-1 (d + (a E - Q (1 - 1/k))^(1/2) z_j - g(m_j) - e_j)

In a linear Gaussian problem that has the posterior of the error E about the mean of the k packings, exactly; e_j drawn anew in every pass
is needed for it: one packing for a member would count its e_j in every pass.
"""
from typing import Optional

import numpy as np
from scipy.linalg import cholesky, solve

from .scatter import Scatter


def about_means(values: np.ndarray, packing: Optional[np.ndarray]) -> np.ndarray:
    """Rows less the mean of those in the same packing."""
    if packing is None:
        return values - values.mean(axis=0)
    left = np.empty_like(values)
    for one in np.unique(packing):
        left[packing == one] = values[packing == one] - values[packing == one].mean(axis=0)
    return left


def update(members: np.ndarray, predicted: np.ndarray, data: np.ndarray, errors: np.ndarray, inflation: float,
           random: np.random.Generator, scatter: Optional[Scatter] = None, packing: Optional[np.ndarray] = None) -> np.ndarray:
    """The members (rows of parameters) after one pass. `predicted`: a row of data per member; `errors`: standard deviations;
    `packing`: which of the scatter's packings each member was run in."""
    freedom = len(members) - (1 if packing is None else len(np.unique(packing)))
    scaled = about_means(predicted, packing) / errors  # by the errors, so that C_D is the unit matrix
    across = about_means(members, packing).T @ scaled / freedom
    inside = scaled.T @ scaled / freedom
    noise = random.standard_normal(predicted.shape)
    noise -= noise.mean(axis=0)  # so that small ensembles do not move by the mean of their own noise
    wanted = inflation * np.eye(len(data))
    if scatter is None:
        noise = np.sqrt(inflation) * noise
    else:
        scale = np.outer(errors, errors)
        wanted += inflation * scatter.unseen / scale
        noise = noise @ cholesky(wanted - scatter.dealt / scale)
    missed = (data - predicted) / errors + noise
    gain = solve(inside + wanted, missed.T, assume_a="pos")
    return members + (across @ gain).T
