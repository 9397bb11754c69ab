#!/usr/bin/python3
"""Models nobody thought of (tests/trust/random_models.py) on a device: each takes the course it takes on the processor, to the last bit.

usage: tests/gpu/random_models.py [--models N] [--seed S] [--only K]
(PYTHONPATH=bindings/python, HFRAC_LIBRARY=the libhfrac beside which libhfrac_gpu lies)
"""
import argparse
import pathlib
import sys

import hfrac

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trust"))
from random_models import add_well, do, draw  # noqa: E402

FAILURES = (hfrac.ModelError, hfrac.ArgumentError, hfrac.DivergedError, hfrac.CollapsedError)


def drawn(seed, number):
    """As drawn, but for the explicit solver, some of more than one tile of 512, with what only some rock has."""
    model, deeds = draw(seed, number)
    model["solver_kind"] = "explicit"
    if model["stepping_mode"] == "coupled":
        model["stepping_mode"] = "substep"
    model["packing_disc_count"] = (300, 700, 1300)[number % 3]
    model["run_workers"] = 1
    if number % 5 == 1:
        model["contact_shape"] = "flat"
    if number % 7 == 2:
        model["bond_fracture_energy"] = 200.0
    return model, deeds


def course(model, deeds, device):
    """On what it ran, the state after each step, or how it ended."""
    heard, states = [], []
    try:
        with hfrac.Simulation(**model, run_device=device, log=lambda _, text: heard.append(text)) as sim:
            for deed, share, well in deeds[:3]:
                do(sim, model, deed, share)
                add_well(sim, well)
                sim.step()
                states.append(sim.state_hash)
    except FAILURES as end:
        states.append(str(end))
    return [text for text in heard if text.startswith("cycles run on ")], states


def main():
    """Draws, compares, tells."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", type=int, default=40)
    parser.add_argument("--seed", type=int, default=20261125)
    parser.add_argument("--only", type=int)
    chosen = parser.parse_args()
    numbers = range(chosen.models) if chosen.only is None else (chosen.only,)
    bad = steps = on_device = 0
    for n in numbers:
        model, deeds = drawn(chosen.seed, n)
        _, alone = course(model, deeds, "cpu")
        where, there = course(model, deeds, "gpu")
        on_device += bool(where)
        steps += sum(isinstance(state, int) for state in alone)
        if there != alone:
            bad += 1
            print(f"model {n} ({model['boundary_kind']}, {model['stepping_mode']}) differs: {there} for {alone}", flush=True)
    print(f"{len(numbers)} models, {on_device} built on the device, {steps} steps: {bad} differ from the processor's", flush=True)
    return 1 if bad or on_device == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
