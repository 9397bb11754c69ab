# SPDX-License-Identifier: BSD-3-Clause
"""The KGD fracture between the regimes of toughness and viscosity: one self-similar profile for every M.

Without leak-off and with an even far stress the profile depends on M = 12 eta E'^3 Q / K'^4 alone, K' = 4 sqrt(2 / pi) K_Ic
(Detournay 2004; Garagash 2006). With E' = Q = 12 eta = 1: l = g t^(2/3), w = W(xi) t^(1/3), p = P(xi) t^(-1/3), xi = x / l, and

  elasticity     W(x) = 4 g / pi int_0^(pi/2) P(f) ln |(cos h + cos f) / (cos f - cos h)| cos f df,  x = sin h, s = sin f
  lubrication    -W^3 P' / g = g (2/3 xi W + int_xi^1 W)
  tip            2 sqrt(g / pi) int_0^(pi/2) P df = K_Ic,  K' = M^(-1/4)              (weight function of a centre crack)
  volume         2 g int_0^1 W = 1

(both integrals: Tada, Paris and Irwin 1985). P is constant on pieces of f; Newton's method finds the pressures and g.
"""
import functools
import math
from typing import Tuple

import numpy

PIECES = 80


@functools.lru_cache(maxsize=None)
def _influence() -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Places xi of the pieces' middles, and W there over g per unit pressure on each piece."""
    step = 0.5 * math.pi / PIECES
    middle = step * (numpy.arange(PIECES) + 0.5)
    fine = 40  # even: no point falls on a middle, where the logarithm is singular
    inside = (numpy.arange(fine) + 0.5) / fine - 0.5
    other = middle[:, None] + step * inside[None, :]
    h, f = middle[:, None, None], other[None, :, :]
    kernel = numpy.log(numpy.abs((numpy.cos(h) + numpy.cos(f)) / (numpy.cos(f) - numpy.cos(h)))) * numpy.cos(f)
    return numpy.sin(middle), 4.0 / math.pi * step * kernel.mean(axis=2)


def _residual(pressure: numpy.ndarray, g: float, toughness: float) -> numpy.ndarray:
    xi, influence = _influence()
    width = g * influence @ pressure
    step = 0.5 * math.pi / PIECES
    share = width * numpy.cos(numpy.arcsin(xi)) * step  # of int W dxi
    beyond = numpy.append(numpy.cumsum(share[::-1])[::-1][1:], 0.0)
    # Between two middles: mean width, flux there, pressure drop.
    w, x = 0.5 * (width[1:] + width[:-1]), 0.5 * (xi[1:] + xi[:-1])
    flux = g * (2.0 / 3.0 * x * w + beyond[:-1])
    lubrication = w**3 * (pressure[1:] - pressure[:-1]) / (xi[1:] - xi[:-1]) / g + flux
    tip = 2.0 * math.sqrt(g / math.pi) * step * pressure.sum() - toughness
    return numpy.concatenate([lubrication, [tip, 2.0 * g * share.sum() - 1.0]])


@functools.lru_cache(maxsize=None)
def _solution(m: float) -> Tuple[float, numpy.ndarray, numpy.ndarray]:
    """g, W and P on the pieces."""
    # From tough rock, where pressure is even, down to the toughness asked for.
    target = m ** -0.25 * math.sqrt(math.pi / 2.0) / 4.0
    tough = max(target, 1.0)
    g = (1.0 / (2.0 * math.sqrt(math.pi) * tough)) ** (2.0 / 3.0)
    unknown = numpy.append(numpy.full(PIECES, tough / math.sqrt(math.pi * g)), g)
    for toughness in numpy.geomspace(tough, target, 1 if tough == target else 12):
        for _ in range(60):
            r = _residual(unknown[:-1], unknown[-1], toughness)
            if numpy.abs(r).max() < 1e-10:
                break
            jacobian = numpy.empty((PIECES + 1, PIECES + 1))
            for k in range(PIECES + 1):
                moved = unknown.copy()
                moved[k] += 1e-7
                jacobian[:, k] = (_residual(moved[:-1], moved[-1], toughness) - r) / 1e-7
            step = numpy.linalg.solve(jacobian, -r)
            unknown += min(1.0, 0.3 * unknown[-1] / abs(step[-1]), 0.5 / numpy.abs(step[:-1]).max() + 0.1) * step
    pressure, g = unknown[:-1], unknown[-1]
    return g, g * _influence()[1] @ pressure, pressure


def prefactors(m: float) -> Tuple[float, float, float]:
    """l over (E' Q^3 / (12 eta))^(1/6) t^(2/3); w0^2 over (12 eta Q / E')^(1/2) l; w0 p0 over (12 eta Q E')^(1/2)."""
    g, width, pressure = _solution(m)
    return g, width[0] ** 2 / g, width[0] * pressure[0]


def pressure_shape(m: float, xi: numpy.ndarray) -> numpy.ndarray:
    """Net pressure at x = xi l over that in the middle."""
    pressure = _solution(m)[2]
    return numpy.interp(xi, _influence()[0], pressure / pressure[0])


def shape(m: float, xi: numpy.ndarray) -> numpy.ndarray:
    """Opening at x = xi l over that in the middle."""
    width = _solution(m)[1]
    return numpy.interp(xi, _influence()[0], width / width[0])


PLACES = tuple(k / 10 for k in range(10)) + (0.95, 0.99)


def table() -> str:
    """viz/command/kgd_table.inc: log10 M, the three prefactors, opening and net pressure at PLACES over those in the middle."""
    lines = ["// Made by tests/verification/kgd_random/self_similar.py: KGD_ROW(log10 M, a, b, c, openings, net pressures)."]
    for half in range(-8, 13):
        m = 10.0 ** (0.5 * half)
        places = numpy.array(PLACES)
        lists = [", ".join(f"{value:.5f}" for value in of(m, places)) for of in (shape, pressure_shape)]
        lines.append(f"KGD_ROW({0.5 * half:g}, " + ", ".join(f"{value:.5f}" for value in prefactors(m)) + ", KGD_LIST(" + "), KGD_LIST(".join(lists) + "))")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table())
