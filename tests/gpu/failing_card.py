#!/usr/bin/python3
"""A card that fails at one launch: the call says so in words, the state from before it stands, and the simulation goes on. A card that is dead
from then on: state that it alone had is lost, which every call says until a saved state is restored; what the host had stands.

usage: tests/gpu/failing_card.py --launches N ... [--iterative] [--dead]
(the emulated driver on LD_LIBRARY_PATH, PYTHONPATH, HFRAC_LIBRARY)
"""
import argparse
import os
import subprocess
import sys

SMALL = {"packing_disc_count": 300, "stress_convention": "effective", "boundary_kind": "walls", "stress_sigma_Hmax": 0.0,
         "stress_sigma_hmin": 0.0, "wells": [{"x": 50.0, "y": 50.0, "radius": 15.0, "pressure": 30e6}]}


def fail(sim, told):
    """A step that fails, and says `told`."""
    import hfrac  # pylint: disable=import-outside-toplevel

    try:
        sim.step()
    except hfrac.DeviceError as error:
        assert told in str(error), error
    else:
        raise AssertionError("no launch failed")


def one(launches_more, model, dead):
    """In a process of its own: fails so many launches after the set-up. Nobody asks for the state before, so it is on the card."""
    import hfrac  # pylint: disable=import-outside-toplevel

    with hfrac.Simulation(**model, run_device="gpu") as sim, hfrac.Simulation(**model) as alone:
        sim.step()
        alone.step()
        if dead:
            saved = sim.save()
            os.environ["HFRAC_EMULATED_DEATH"] = "1"
            sim.step()
        # Launches are counted from here on.
        os.environ["HFRAC_EMULATED_LAUNCHES"] = str(launches_more)
        fail(sim, "restore a saved state" if dead else "unspecified launch failure")
        if dead:
            fail(sim, "restore a saved state")
            try:
                raise AssertionError(f"a hash of what is lost: {sim.state_hash}")
            except hfrac.DeviceError:
                pass
            sim.restore(saved)
            assert sim.state_hash == alone.state_hash, "not the state that was saved"
            fail(sim, "the state before the step stands")
            assert sim.state_hash == alone.state_hash, "the state is another one"
            return
        assert sim.state_hash == alone.state_hash, "the state is another one"
        del os.environ["HFRAC_EMULATED_LAUNCHES"]
        sim.step()  # the emulated card works again
        alone.step()
        assert sim.state_hash == alone.state_hash


def main():
    """Each number of launches in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--launches", type=int, nargs="+", default=[0])
    parser.add_argument("--iterative", action="store_true", help="the flow step by conjugate gradients, where the first launches are")
    parser.add_argument("--dead", action="store_true")
    parser.add_argument("--one", type=int)
    chosen = parser.parse_args()
    if chosen.one is not None:
        one(chosen.one, {**SMALL, "flow_solver": "iterative"} if chosen.iterative else SMALL, chosen.dead)
        return 0
    command = [sys.executable, "-B", *sys.argv]
    bad = [n for n in chosen.launches if subprocess.run([*command, "--one", str(n)], check=False).returncode != 0]
    print(f"{len(chosen.launches)} failures of a card, {len(bad)} handled wrongly {bad or ''}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
