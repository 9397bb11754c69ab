#!/usr/bin/python3
"""Models nobody thought of (tests/trust/random_models.py) on a device: each takes the course it takes on the processor, to the last bit.

State stays on the device between steps until somebody asks, so what is asked, and when, is drawn, too.

usage: tests/gpu/random_models.py [--models N] [--seed S] [--only K]
(PYTHONPATH=bindings/python, HFRAC_LIBRARY=the libhfrac beside which libhfrac_gpu lies)
"""
import pathlib
import random
import sys
import zlib

import hfrac

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trust"))
from random_models import FAILURES, add_well, chosen_models, do, draw  # noqa: E402

MOMENTS = {
    "nothing": lambda sim: None,
    "hash": lambda sim: sim.state_hash,
    "image": lambda sim: zlib.crc32(sim.save()),
    "speed": lambda sim: zlib.crc32(sim.discs.velocity),
    "balance": lambda sim: (sim.balance.friction, sim.balance.contact_elastic, sim.balance.kinetic),
    "pressure": lambda sim: zlib.crc32(sim.domains.pressure),
}


def drawn(seed, number):
    """As drawn, but for the explicit solver, some of more than one tile of 512, with what only some rock has."""
    model, deeds = draw(seed, number)
    model["solver_kind"] = "explicit"
    if model["stepping_mode"] == "coupled":
        model["stepping_mode"] = "substep"
    model["packing_disc_count"] = (300, 700, 1300)[number % 3]
    model["run_workers"] = 1
    if number % 2 == 0 and model["flow_scheme"] != "off":
        model["flow_scheme"], model["flow_solver"] = "implicit", "iterative"
    if number % 5 == 1:
        model["contact_shape"] = "flat"
    if number % 7 == 2:
        model["bond_fracture_energy"] = 200.0
    return model, deeds


def course(model, deeds, moments, **how):
    """What was asked at each moment, and the state at the end or how it ended."""
    heard = []
    try:
        with hfrac.Simulation(**model, **how) as sim:
            for (deed, share, well), moment in zip(deeds, moments):
                if deed:
                    do(sim, model, deed, share)
                add_well(sim, well)
                sim.step()
                heard.append((moment, MOMENTS[moment](sim)))
            heard.append(sim.state_hash)
    except FAILURES as end:
        heard.append(str(end))
    return heard


def main():
    """Draws, compares, tells."""
    numbers, seed = chosen_models(__doc__, 40)
    bad = steps = on_device = iterative = 0
    for n in numbers:
        model, deeds = drawn(seed, n)
        moments = random.Random(1000 * seed + n).choices(sorted(MOMENTS), k=len(deeds))
        told = []
        alone = course(model, deeds, moments)
        there = course(model, deeds, moments, run_device="gpu", log=lambda _, text, heard=told: heard.append(text))
        runs = any(text.startswith("cycles run on ") for text in told)
        on_device += runs
        iterative += runs and model["flow_solver"] == "iterative" and model["flow_scheme"] == "implicit" and len(alone) > 1
        steps += sum(isinstance(state, tuple) for state in alone)
        if there != alone:
            bad += 1
            print(f"model {n} ({model['boundary_kind']}, {model['stepping_mode']}) differs: {there} for {alone}", flush=True)
    print(f"{len(numbers)} models, {on_device} built on the device, {iterative} with its conjugate gradients, {steps} steps: "
          f"{bad} differ from the processor's", flush=True)
    return 1 if bad or on_device == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
