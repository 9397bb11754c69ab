# SPDX-License-Identifier: BSD-3-Clause
"""Seconds of processor time for single steps, as Python takes them.   step.py CASE STEPS"""
import sys
import time

import hfrac

with hfrac.Simulation(sys.argv[1]) as sim:
    start = time.process_time()
    for _ in range(int(sys.argv[2])):
        sim.step()
    print(f"{time.process_time() - start:.6f}")
