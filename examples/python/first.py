#!/usr/bin/env python3
"""The shortest useful program: build a case, run it, ask for the fracture.

usage: first.py CASE.toml
"""
import sys

import hfrac

with hfrac.Simulation(sys.argv[1]) as sim:
    sim.step(20)
    if sim.fractures:
        f = sim.fractures[0]
        print(f"fracture of {f.length:.1f} m, {1e3 * f.largest_aperture:.1f} mm wide, {f.crack_count} cracks")
    else:
        print("no fracture")
