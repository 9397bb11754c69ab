#!/usr/bin/python3
"""Models nobody thought of (tests/trust/random_models.py) on a device: each takes the course it takes on the processor, to the last bit.

usage: tests/gpu/random_models.py [--models N] [--seed S] [--only K]
(PYTHONPATH=bindings/python, HFRAC_LIBRARY=the libhfrac beside which libhfrac_gpu lies)
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trust"))
from random_models import chosen_models, course, draw  # noqa: E402


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


def main():
    """Draws, compares, tells."""
    numbers, seed = chosen_models(__doc__, 40)
    bad = steps = on_device = 0
    for n in numbers:
        model, deeds = drawn(seed, n)
        heard = []
        alone = course(model, deeds)
        there = course(model, deeds, run_device="gpu", log=lambda _, text, told=heard: told.append(text))
        on_device += any(text.startswith("cycles run on ") for text in heard)
        steps += sum(isinstance(state, int) for state in alone)
        if there != alone:
            bad += 1
            print(f"model {n} ({model['boundary_kind']}, {model['stepping_mode']}) differs: {there} for {alone}", flush=True)
    print(f"{len(numbers)} models, {on_device} built on the device, {steps} steps: {bad} differ from the processor's", flush=True)
    return 1 if bad or on_device == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
