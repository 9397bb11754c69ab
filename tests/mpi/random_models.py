#!/usr/bin/python3
"""Models nobody thought of (tests/trust/random_models.py), larger, over all ranks: each takes the course it takes alone, to the last bit.

usage: mpirun -n N tests/mpi/random_models.py [--models N] [--seed S] [--only K]    (PYTHONPATH=bindings/python)
"""
import pathlib
import sys

from mpi4py import MPI

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trust"))
from random_models import chosen_models, course, draw  # noqa: E402

COMM = MPI.COMM_WORLD


def main():
    """Draws, compares, tells."""
    numbers, seed = chosen_models(__doc__, 100)
    bad = steps = 0
    for n in numbers:
        model, deeds = draw(seed, n)
        # A rank with discs needs a tile of 512.
        model["packing_disc_count"] = (1500, 2500, 4000)[n % 3]
        model["run_workers"] = 1 + n % 2
        over = course(model, deeds, comm=COMM)
        alone = COMM.bcast(course(model, deeds) if COMM.rank == 0 else None)
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
