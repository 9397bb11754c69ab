#!/usr/bin/python3
"""Models nobody thought of (tests/trust/random_models.py), larger, over all ranks: each takes the course it takes alone, to the last bit.

usage: mpirun -n N tests/mpi/random_models.py [--models N] [--seed S] [--only K]    (PYTHONPATH=bindings/python)
"""
import argparse
import pathlib
import sys

from mpi4py import MPI

import hfrac

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trust"))
from random_models import add_well, do, draw  # noqa: E402

COMM = MPI.COMM_WORLD
FAILURES = (hfrac.ModelError, hfrac.ArgumentError, hfrac.DivergedError, hfrac.CollapsedError)


def course(model, deeds, comm):
    """State after each step, or how it ended."""
    states = []
    try:
        with hfrac.Simulation(**model, comm=comm) as sim:
            for deed, share, well in deeds[:3]:
                do(sim, model, deed, share)
                add_well(sim, well)
                sim.step()
                states.append(sim.state_hash)
    except FAILURES as end:
        states.append(str(end))
    return states


def main():
    """Draws, compares, tells."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", type=int, default=100)
    parser.add_argument("--seed", type=int, default=20261125)
    parser.add_argument("--only", type=int)
    chosen = parser.parse_args()
    numbers = range(chosen.models) if chosen.only is None else (chosen.only,)
    bad = steps = 0
    for n in numbers:
        model, deeds = draw(chosen.seed, n)
        # A rank with discs needs a tile of 512.
        model["packing_disc_count"] = (1500, 2500, 4000)[n % 3]
        model["run_workers"] = 1 + n % 2
        over = course(model, deeds, COMM)
        alone = course(model, deeds, None) if COMM.rank == 0 else None
        alone = COMM.bcast(alone)
        steps += sum(isinstance(state, int) for state in alone)
        differ = COMM.allreduce(int(over != alone))
        bad += differ > 0
        if differ and COMM.rank == 0:
            print(f"model {n} ({model['solver_kind']}, {model['stepping_mode']}) differs on {differ} of {COMM.size} ranks", flush=True)
    if COMM.rank == 0:
        print(f"{len(numbers)} models, {steps} steps, {COMM.size} ranks: {bad} differ from one alone", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
