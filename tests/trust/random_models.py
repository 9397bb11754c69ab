#!/usr/bin/python3
"""Models nobody thought of: options, wells (added ones, too), joints, temperatures drawn by a stated seed, and what must hold of every one.

usage: tests/trust/random_models.py [--models N] [--seed S] [--only K] [--times N] [--strict]    (PYTHONPATH=bindings/python)

Whatever is drawn,
  - it is built and steps, or is refused, or a step fails, in words; a failed step leaves the state as it was;
  - the fluid balance closes to 1e-10 of what was moved (1e-7 if pressures are found by iteration);
  - the energy balance closes to 2 % of its largest entry, in real motion of n cycles a step to 1 / n more, since speeds are known
    half a cycle before places (quasi-static counts as damping what does not close); not asked of rock that a step leaves in flight, whose
    pieces meet others within a step; nor of servo walls, whose own damping is in no balance (--strict asks it of all);
  - a restored image goes on bit for bit, in another simulation, on another number of workers;
  - all that a host can read is finite.
A model is told by its number: `--only K` builds number K alone and prints it.
"""
import argparse
import math
import random
import sys
import time

import hfrac

SIZE = 100.0  # m, side of every model


def draw(seed, number):
    """Options of one model, and what is done to it between steps: (what, how much, a well to be added or None)."""
    r = random.Random(seed * 1000003 + number)
    discs = r.choice((60, 100, 200, 400))
    radius = math.sqrt(0.85 * SIZE * SIZE / math.pi / discs)
    o = {
        "model_seed": r.randrange(1000),
        "stress_convention": r.choice(("total", "effective")),
        "packing_disc_count": discs,
        "packing_residual": 1e-3,
        "packing_method": r.choice(("relaxed", "relaxed", "growth", "square")),
        "contact_mode": r.choice(("parallel", "after-break")),
        "contact_friction": r.choice((0.0, 0.22, 1.0)),
        "boundary_kind": r.choice(("stress", "walls")),
        "boundary_walls_after_equilibration": r.choice(("fixed", "servo")),
        "stress_sigma_hmin": r.choice((0.0, 10e6, 30e6)),
        "fluid_viscosity": 10.0 ** r.uniform(-3, 0),
        "flow_permeability": 10.0 ** r.uniform(-16, -12),
        "flow_scheme": r.choice(("implicit", "implicit", "implicit", "explicit", "off")),
        "flow_outer": r.choice(("formation", "formation", "closed")),
        "flow_solver": r.choice(("direct", "iterative")),
        "flow_aperture_limit": r.choice((1e-4, 1e-3, 1e-2)),
        "stepping_flow_step": 10.0 ** r.uniform(-3, 2),
        "stepping_max_cycles": 3000,
        "bond_tensile_strength": r.choice((5e6, 20e6, 42.5e6, 42.5e6)),
        # The first draw is that of an option that is gone: a seed gives the model it always gave.
        "run_workers": (r.choice(range(3)), r.choice((1, 2)))[1],
    }
    least = o["stress_sigma_hmin"] if o["stress_convention"] == "total" else 25e6  # the rock is not to be pulled apart
    o["fluid_formation_pressure"] = r.choice([p for p in (0.0, 5e6, 25e6) if p <= least])
    o["stress_sigma_Hmax"] = o["stress_sigma_hmin"] + r.choice((0.0, 5e6, 10e6))
    o["bond_shear_strength"] = o["bond_tensile_strength"] * r.choice((0.5, 1.0, 3.0))
    if r.random() < 0.2:
        o["fluid_consistency"], o["fluid_power_index"] = r.choice((0.5, 2.0)), r.choice((0.4, 0.7))
    o["solver_kind"] = r.choice(("explicit", "quasi-static"))
    o["stepping_mode"] = r.choice(("substep", "coupled" if o["solver_kind"] == "quasi-static" else "dynamic"))
    if o["stepping_mode"] == "dynamic":
        o["stepping_flow_step"] = 10.0 ** r.uniform(-4, -2)
    if o["stepping_mode"] == "coupled":
        o["flow_scheme"] = "implicit"
    if r.random() < 0.35:
        o["thermal_mode"] = r.choice(("uniform", "transport"))
        o["thermal_expansion"] = r.choice((0.0, 1e-5))
        o["thermal_parameters"] = r.choice(("constant", "table"))
        o["thermal_film_coefficient"] = r.choice((0.0, 100.0))
        o["thermal_outer"] = r.choice(("insulated", "held"))
        o["thermal_fluid_temperature"] = r.choice((523.15, 573.15))
    wells = []
    for k in range(r.choice((0, 1, 1, 1, 2))):
        base = o["fluid_formation_pressure"] if o["stress_convention"] == "total" else 0.0
        well = {"radius": r.uniform(2.05, 2.6) * radius, "pressure": base + r.choice((-base / 4, 5e6, 20e6, 45e6))}
        well["x"], well["y"] = (50.0, 50.0) if k == 0 else (r.choice((25.0, 75.0)), r.choice((25.0, 75.0)))
        kind = r.random()
        if kind < 0.25:
            well["control"], well["ramp_per_step"] = "ramp", 3e6
        elif kind < 0.5:
            well["control"], well["rate"] = "rate", r.choice((-0.1, 0.5, 5.0)) / o["stepping_flow_step"]
        wells.append(well)
    joints = []
    for _ in range(r.choice((0, 0, 1, 2))):
        angle, x, y = r.uniform(0, math.pi), r.uniform(30, 70), r.uniform(30, 70)
        half = r.uniform(15, 40)
        joints.append(
            {
                "x1": x - half * math.cos(angle),
                "y1": y - half * math.sin(angle),
                "x2": x + half * math.cos(angle),
                "y2": y + half * math.sin(angle),
                "friction": r.choice((-1.0, 0.1, 0.8)),
                "tensile_factor": r.choice((0.1, 1.0)),
                "state": r.choice(("bonded", "broken", "smooth-bonded", "smooth-broken")),
            }
        )
    deeds = []
    for _ in range(5):
        deed = r.choice(("", "", "", "far field", "pressure", "formation", "temperature"))
        deeds.append((deed, r.uniform(0.8, 1.2), None))
    # Drawn last, so that the rest of a seed stays as it was: a well added before one of the steps.
    if r.random() < 0.4:
        k = r.randrange(4)
        place = r.uniform(10, 90), r.uniform(10, 90)
        base = o["fluid_formation_pressure"] if o["stress_convention"] == "total" else 0.0
        drive = r.choice((("pressure", base + r.choice((-base / 4, 5e6, 20e6))),
                          ("rate", r.choice((-0.01, 0.01, 0.1)) / o["stepping_flow_step"])))
        deeds[k] = (*deeds[k][:2], (place, drive))
    # Water of 250 degrees C, as the rock is, is liquid from 4 MPa on.
    if "thermal_mode" in o and o["fluid_formation_pressure"] >= 5e6 and "fluid_consistency" not in o:
        o["fluid_kind"] = "water"
    return {**o, "wells": wells, "joints": joints}, deeds


def do(sim, model, deed, share):
    """What a host may do between steps. Where the model has no part for it, it is refused and nothing changes."""
    before = sim.state_hash
    try:
        if deed == "far field":
            sim.set_far_field(model["stress_sigma_Hmax"] * share + 1e6, model["stress_sigma_hmin"] * share)
        elif deed == "pressure" and model["wells"]:
            sim.wells[0].set_pressure(20e6 * share)
        elif deed == "formation":
            sim.set_formation_pressure(5e6 * share)
        elif deed == "temperature":
            sim.set_temperature(523.15 + 40.0 * share)
    except hfrac.ArgumentError:
        return sim.state_hash == before
    return True


FAILURES = (hfrac.ModelError, hfrac.ArgumentError, hfrac.DivergedError, hfrac.CollapsedError)


def course(model, deeds, **how):
    """State after each of three steps, or how it ended."""
    states = []
    try:
        with hfrac.Simulation(**model, **how) as sim:
            for deed, share, well in deeds[:3]:
                do(sim, model, deed, share)
                add_well(sim, well)
                sim.step()
                states.append(sim.state_hash)
    except FAILURES as end:
        states.append(str(end))
    return states


def chosen_models(description, models):
    """The numbers of models and the seed that a command line asks for."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", type=int, default=models)
    parser.add_argument("--seed", type=int, default=20261125)
    parser.add_argument("--only", type=int)
    chosen = parser.parse_args()
    return (range(chosen.models) if chosen.only is None else (chosen.only,)), chosen.seed


def add_well(sim, well):
    """Adds it, or is refused and changes nothing."""
    if well is None:
        return True
    before = sim.state_hash
    place, (control, value) = well
    try:
        new = sim.add_well(*place)
    except hfrac.ArgumentError:
        return sim.state_hash == before
    (new.set_pressure if control == "pressure" else new.set_rate)(value)
    return True


def check_balance(sim, model, energy):
    """What is wrong with the balance, or nothing."""
    b = sim.balance
    moved = max(abs(b.injected_volume), abs(b.stored_volume), abs(b.leaked_volume), abs(b.host_volume), 1e-4)
    if not abs(b.fluid_error) <= (1e-7 if model["flow_solver"] == "iterative" else 1e-10) * moved:
        return f"fluid missing: {b.fluid_error:.2e} of {moved:.2e} m2"
    largest = max(
        *(abs(e) for e in (b.fluid_work, b.boundary_work, b.damping, b.fracture, b.friction)),
        b.bond_elastic + b.contact_elastic,
        b.kinetic,
    )
    share = 0.02
    if model["stepping_mode"] == "dynamic":
        share += sim.state.mechanical_step / model["stepping_flow_step"]
    if energy and b.energy_checked and not abs(b.energy_error) <= share * largest:
        return f"energy missing: {b.energy_error:.2e} of {largest:.2e} J/m"
    for name, group in (("disc displacement", sim.discs.displacement), ("aperture", sim.pipes.aperture)):
        if not all(math.isfinite(v) for v in _flat(group)):
            return f"{name} is not finite"
    return ""


def _flat(values):
    for value in values:
        try:
            yield from value
        except TypeError:
            yield value


def try_model(model, deeds, strict):
    """(outcome, what is wrong): outcome is "refused", "failed" or "done"."""
    try:
        sim = hfrac.Simulation(**model)
    except (hfrac.ModelError, hfrac.ArgumentError) as refusal:
        return f"refused: {refusal}", ""
    except (hfrac.DivergedError, hfrac.CollapsedError) as end:
        return f"no rest in set-up: {end}", ""
    with sim:
        if not sim.state.at_rest:
            return "no rest in set-up: told by a warning", ""
        servo = model["boundary_kind"] == "walls" and model["boundary_walls_after_equilibration"] == "servo"
        twin, torn = None, servo
        try:
            for k, (deed, share, well) in enumerate(deeds):
                both = [each for each in (sim, twin) if each is not None]
                if not all(do(each, model, deed, share) for each in both):
                    return "done", f"step {k}: a refused {deed} changed the state"
                if not all(add_well(each, well) for each in both):
                    return "done", f"step {k}: a refused well changed the state"
                before = sim.state_hash
                try:
                    sim.step()
                except (hfrac.DivergedError, hfrac.CollapsedError) as end:
                    if sim.state_hash != before:
                        return "failed", f"step {k}: a failed step changed the state ({end})"
                    if twin is not None:
                        try:
                            twin.step()
                            return "failed", f"step {k}: fails, but not in the restored one"
                        except (hfrac.DivergedError, hfrac.CollapsedError):
                            pass
                    return f"failed: {end}", ""
                torn = torn or not sim.state.at_rest and model["stepping_mode"] != "dynamic"
                wrong = check_balance(sim, model, strict or not torn)
                if wrong:
                    return "done", f"step {k}: {wrong}"
                if twin is not None:
                    twin.step()
                    if twin.state_hash != sim.state_hash:
                        return "done", f"step {k}: the restored one went another way"
                if k == 1:
                    twin = hfrac.Simulation(**{**model, "run_workers": model["run_workers"] + 1})
                    twin.restore(sim.save())
                    if twin.state_hash != sim.state_hash:
                        return "done", "restored is not what was saved"
        finally:
            if twin is not None:
                twin.close()
    return "done", ""


def main():
    """Draws, tries, tells."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", type=int, default=100)
    parser.add_argument("--seed", type=int, default=20261122)
    parser.add_argument("--only", type=int)
    parser.add_argument("--times", type=int, default=1, help="so many times the discs")
    parser.add_argument("--strict", action="store_true")
    chosen = parser.parse_args()
    numbers = range(chosen.models) if chosen.only is None else (chosen.only,)
    count, bad, last = {}, 0, time.monotonic()
    for n in numbers:
        model, deeds = draw(chosen.seed, n)
        model["packing_disc_count"] *= chosen.times
        for well in model["wells"]:
            well["radius"] /= math.sqrt(chosen.times)
        if chosen.only is not None:
            print(model, deeds, sep="\n")
        outcome, wrong = try_model(model, deeds, chosen.strict)
        kind = outcome.split(":")[0]
        count[kind] = count.get(kind, 0) + 1
        if chosen.only is not None:
            print(outcome)
        if wrong:
            bad += 1
            print(f"model {n} ({model['solver_kind']}, {model['stepping_mode']}): {wrong}", flush=True)
        if time.monotonic() - last > 60.0:
            last = time.monotonic()
            print(f"{n + 1} of {chosen.models} models", file=sys.stderr, flush=True)
    print(", ".join(f"{kind} {n}" for kind, n in sorted(count.items())) + f"; wrong {bad} of {len(numbers)} models")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
