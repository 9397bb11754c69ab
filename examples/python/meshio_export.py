#!/usr/bin/env python3
"""Discs and bonds after a few steps as a mesh for anything that meshio writes. Needs numpy and meshio (python3-meshio).

The format is the file's ending: .vtu, .vtk, .msh (Gmsh), .inp (Abaqus), .xdmf ...

usage: meshio_export.py CASE.toml MESH.vtu [STEPS]
"""
import sys

try:
    import meshio
except ImportError as missing:
    print(f"skipped: {missing.name} is not installed (Debian: python3-meshio)")
    sys.exit(77)
import numpy as np

import hfrac


def mesh_of(sim):
    """Points are disc centres, lines bonds; fields keep the names and units of the library's table."""
    discs, bonds = sim.discs, sim.bonds
    flat = np.zeros(len(discs.radius))
    return meshio.Mesh(
        np.column_stack([discs.position, flat]),
        [("line", bonds.discs)],
        point_data={
            "radius_m": np.array(discs.radius),
            "displacement_m": np.column_stack([discs.displacement, flat]),
            "stress_xx_yy_xy_Pa": np.array(discs.stress),
        },
        cell_data={
            "state": [np.array(bonds.state)],
            "normal_force_N": [np.array(bonds.normal_force)],
            "aperture_m": [np.array(sim.pipes.aperture)],
        },
    )


def main(case, file, steps="20"):
    with hfrac.Simulation(case) as sim:
        sim.step(int(steps))
        mesh_of(sim).write(file)
        cracks, discs = sim.state.crack_count, sim.state.disc_count
    again = meshio.read(file)
    found = len(again.points), np.count_nonzero(again.cell_data["state"][0])
    print(f"{file}: {found[0]} discs, {found[1]} cracks")
    if found != (discs, cracks):
        sys.exit(f"read back from {file}: not the {discs} discs and {cracks} cracks that were written")


if __name__ == "__main__":
    main(*sys.argv[1:])
