# SPDX-License-Identifier: BSD-3-Clause
"""Ensemble smoother with multiple data assimilation (ES-MDA; Emerick and Reynolds 2013, Computers & Geosciences 55, 3-15).

An ensemble of parameters, each member run through the model, is moved towards the data by what the ensemble itself tells of how
data go with parameters:

    m_j <- m_j + C_MD (C_DD + a C_D)^-1 (d + sqrt(a) C_D^(1/2) z_j - g(m_j)),   z_j normal,   sum over passes of 1 / a = 1

with C_MD and C_DD the covariances of parameters and data over the ensemble, C_D that of the data's errors (here independent).
Several passes with errors made larger by a = number of passes follow a model that is not linear better than one pass with the
errors as they are; for a linear model both give the exact posterior as the ensemble grows.
"""
import numpy as np
from scipy.linalg import solve


def update(members: np.ndarray, predicted: np.ndarray, data: np.ndarray, errors: np.ndarray, inflation: float,
           random: np.random.Generator) -> np.ndarray:
    """The members (rows of parameters) after one pass. `predicted`: a row of data per member; `errors`: standard deviations."""
    count = len(members)
    scaled = (predicted - predicted.mean(axis=0)) / errors  # by the errors, so that C_D is the unit matrix
    spread = members - members.mean(axis=0)
    across = spread.T @ scaled / (count - 1)
    inside = scaled.T @ scaled / (count - 1)
    noise = random.standard_normal(predicted.shape)
    noise -= noise.mean(axis=0)  # so that small ensembles do not move by the mean of their own noise
    missed = (data - predicted) / errors + np.sqrt(inflation) * noise
    gain = solve(inside + inflation * np.eye(len(data)), missed.T, assume_a="pos")
    return members + (across @ gain).T
