# SPDX-License-Identifier: BSD-3-Clause
"""K of two cracks that start from opposite sides of a round hole, by displacement discontinuities (Crouch and Starfield 1983).

Hole and cracks are lines of elements on which the displacement jumps by a constant; what the far field and the fluid put on them gives the
jumps. Inside the hole lies rock that nothing holds, and the smallest jumps are taken (least squares), which fixes it. K follows from the opening
of a tip's element by the ratio that a straight crack of the same elements has, for which K = p sqrt(pi c) is exact. Plane problem, E' = 1:
K does not depend on the moduli. Known limits: 1.1215 times the wall's hoop stress (3 and 2 times the far stress: Kirsch 1898) for cracks short against
the hole, and a straight crack from tip to tip for long ones. Run by itself, it prints both.
"""
import functools
import math
from typing import NamedTuple, Sequence, Tuple

import numpy as np

HOLE, CRACK = 80, 24  # elements of the hole, of a crack
PART = 0.25  # m that a tip goes on at a time


class _Lines(NamedTuple):
    middle: np.ndarray
    angle: np.ndarray
    half: np.ndarray


def _influence(lines: _Lines) -> np.ndarray:
    """Shear and normal stress on each element, tension positive, by unit jumps (shear, normal; one that closes is positive) of each."""
    rows = []
    factor = 0.25 / math.pi  # E' / (4 pi)
    for i in range(len(lines.half)):
        c, s = np.cos(lines.angle), np.sin(lines.angle)
        dx, dy = (lines.middle[i] - lines.middle).T
        x, y, a = dx * c + dy * s, -dx * s + dy * c, lines.half
        y = np.where(np.abs(y) < 1e-12, 0.0, y)
        left, right = (x - a) ** 2 + y**2, (x + a) ** 2 + y**2
        f_xy = factor * (y / left - y / right)
        f_yy = -factor * ((x - a) / left - (x + a) / right)
        f_xyy = factor * (((x - a) ** 2 - y**2) / left**2 - ((x + a) ** 2 - y**2) / right**2)
        f_yyy = factor * 2.0 * y * ((x - a) / left**2 - (x + a) / right**2)
        # Stresses in the element's own axes by jumps (shear, normal).
        xx = [2.0 * f_xy + y * f_xyy, f_yy + y * f_yyy]
        yy = [-y * f_xyy, f_yy - y * f_yyy]
        xy = [f_yy + y * f_yyy, -y * f_xyy]
        turn = lines.angle[i] - lines.angle
        ct, st = np.cos(turn), np.sin(turn)
        row = []
        for k in (0, 1):
            normal = xx[k] * st**2 + yy[k] * ct**2 - 2.0 * xy[k] * st * ct
            shear = (yy[k] - xx[k]) * st * ct + xy[k] * (ct**2 - st**2)
            row.append((shear, normal))
        rows.append(row)
    return np.array(rows)  # of element, jump, stress, by element


def _matrix(lines: _Lines) -> np.ndarray:
    array = _influence(lines)
    n = len(lines.half)
    matrix = np.empty((2 * n, 2 * n))
    for jump in (0, 1):
        for stress in (0, 1):
            matrix[stress * n:(stress + 1) * n, jump * n:(jump + 1) * n] = array[:, jump, stress, :]
    return matrix


def _cracks(radius: float, lengths: Sequence[float]) -> _Lines:
    middle, angle, half = [], [], []
    for side, length in ((1.0, lengths[0]), (-1.0, lengths[1])):
        # Short at the tip and at the hole's wall.
        ends = radius + length * 0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, CRACK + 1)))
        for first, last in zip(ends[:-1], ends[1:]):
            middle.append((side * 0.5 * (first + last), 0.0))
            angle.append(0.0)
            half.append(0.5 * (last - first))
    if radius > 0.0:
        turns = np.linspace(0.0, 2.0 * math.pi, HOLE + 1)
        points = radius * np.stack([np.cos(turns), np.sin(turns)], axis=1)
        for first, last in zip(points[:-1], points[1:]):
            middle.append(tuple(0.5 * (first + last)))
            angle.append(math.atan2(*(last - first)[::-1]))
            half.append(0.5 * float(np.hypot(*(last - first))))
    return _Lines(np.array(middle), np.array(angle), np.array(half))


def _tip_openings(lines: _Lines, push: np.ndarray, drag: np.ndarray) -> np.ndarray:
    """Openings of both tips' elements over the root of their length, under pressures and shear stresses on the elements: a column a load."""
    jumps = np.linalg.lstsq(_matrix(lines), -np.concatenate([drag, push]), rcond=1e-10)[0]
    tips = [CRACK - 1, 2 * CRACK - 1]
    return -jumps[len(lines.half):][tips] / np.sqrt(2.0 * lines.half[tips])[:, None]


@functools.lru_cache(maxsize=None)
def _tip_ratio() -> float:
    """K over that, of a straight crack."""
    lines = _cracks(0.0, (1.0, 1.0))
    one = np.ones((len(lines.half), 1))
    return math.sqrt(math.pi) / _tip_openings(lines, one, 0.0 * one)[0, 0]


@functools.lru_cache(maxsize=None)
def _unit(radius: float, lengths: Tuple[float, float]) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """K at both tips [m^0.5] by unit pressure in hole and cracks, and by unit far-field compression along x and along y."""
    lines = _cracks(radius, lengths)
    c, s = np.cos(lines.angle), np.sin(lines.angle)
    push, drag = np.stack([np.ones_like(c), -(s**2), -(c**2)], axis=1), np.stack([0.0 * c, s * c, -s * c], axis=1)
    by_pressure, by_x, by_y = _tip_ratio() * _tip_openings(lines, push, drag).T
    return by_pressure, by_x, by_y


def intensities(radius: float, lengths: Tuple[float, float], pressure: float, sigma_x: float, sigma_y: float) -> np.ndarray:
    """K [Pa m^0.5] at the two tips; `lengths` [m] from the hole's wall, along x."""
    by_pressure, by_x, by_y = _unit(radius, lengths)
    return pressure * by_pressure + sigma_x * by_x + sigma_y * by_y


def breakdown_pressure(radius: float, lengths: Tuple[float, float], sigma_x: float, sigma_y: float, toughness: float, grown: float) -> Tuple[float, float]:
    """Pressure in hole and cracks [Pa] at which the first tip goes on, and the largest needed until either crack is `grown` longer [m]."""
    now, needed = list(lengths), []
    while max(now[0] - lengths[0], now[1] - lengths[1]) < grown:
        by_pressure, by_x, by_y = _unit(radius, (now[0], now[1]))
        at_tips = (toughness - sigma_x * by_x - sigma_y * by_y) / by_pressure
        needed.append(float(at_tips.min()))
        now[int(at_tips.argmin())] += PART
    return needed[0], max(needed)


def main() -> None:
    root = math.sqrt(math.pi)
    for share in (0.1, 0.2, 0.5, 1.0, 2.0, 5.0):
        by_pressure, by_x, by_y = (each[0] / (root * math.sqrt(share)) for each in _unit(1.0, (share, share)))
        print(f"L/R {share:4g}: K / sqrt(pi L) by pressure {by_pressure:.3f}, tension across {-by_y:.3f}, all round {-(by_x + by_y):.3f}; "
              f"a straight crack of L + R {math.sqrt(1.0 + 1.0 / share):.3f}")


if __name__ == "__main__":
    main()
