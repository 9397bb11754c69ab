#!/usr/bin/env python3
"""Pore pressure and cracks after a few steps, as a picture. Needs numpy and matplotlib (python3-matplotlib).

usage: pressure_plot.py CASE.toml PICTURE.png [STEPS]
"""
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.collections import EllipseCollection, LineCollection
except ImportError as missing:
    print(f"skipped: {missing.name} is not installed (Debian: python3-matplotlib)")
    sys.exit(77)
import numpy as np

import hfrac


def draw(sim, axes):
    position, radius = sim.discs.position, sim.discs.radius
    size = 2 * radius
    axes.add_collection(
        EllipseCollection(size, size, 0 * size, units="xy", offsets=position, transOffset=axes.transData, color="0.9")
    )

    inside = sim.domains.kind != 2  # 2: the outside, which has no place of its own
    centre = sim.domains.centre[inside]
    dots = axes.scatter(*centre.T, c=sim.domains.pressure[inside] / 1e6, s=6, cmap="viridis", zorder=2)
    plt.colorbar(dots, ax=axes, label="pressure [MPa]")

    cracks = sim.cracks
    along = np.column_stack([-cracks.normal[:, 1], cracks.normal[:, 0]]) * cracks.length[:, None] / 2
    ends = np.stack([cracks.position - along, cracks.position + along], axis=1)
    axes.add_collection(LineCollection(ends, color="red"))

    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title=f"t = {sim.time:g} s, {len(cracks)} cracks")
    axes.autoscale_view()


def main(case, picture, steps="20"):
    with hfrac.Simulation(case) as sim:
        sim.step(int(steps))
        figure, axes = plt.subplots(figsize=(7, 6))
        draw(sim, axes)
        figure.savefig(picture, dpi=120, bbox_inches="tight")


if __name__ == "__main__":
    main(*sys.argv[1:])
