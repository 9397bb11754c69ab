#!/usr/bin/python3
"""A card that fails at one launch: the call says so in words, the state from before it stands, and a new simulation goes on.

usage: tests/gpu/failing_card.py --launches N ...    (the emulated driver on LD_LIBRARY_PATH, PYTHONPATH, HFRAC_LIBRARY)
"""
import argparse
import os
import subprocess
import sys

SMALL = {"packing_disc_count": 300, "stress_convention": "effective", "boundary_kind": "walls", "stress_sigma_Hmax": 0.0,
         "stress_sigma_hmin": 0.0, "wells": [{"x": 50.0, "y": 50.0, "radius": 15.0, "pressure": 30e6}]}


def one(launches_more):
    """In a process of its own: fails so many launches after the set-up."""
    import hfrac  # pylint: disable=import-outside-toplevel

    with hfrac.Simulation(**SMALL, run_device="gpu") as sim, hfrac.Simulation(**SMALL) as alone:
        sim.step()
        alone.step()
        before = sim.state_hash
        assert before == alone.state_hash
        # Launches are counted from here on.
        os.environ["HFRAC_EMULATED_LAUNCHES"] = str(launches_more)
        try:
            sim.step()
        except hfrac.DeviceError as error:
            assert "unspecified launch failure" in str(error) and "emulated card" in str(error), error
        else:
            raise AssertionError("no launch failed")
        assert sim.state_hash == before, "the state is another one"
        del os.environ["HFRAC_EMULATED_LAUNCHES"]
        sim.step()  # the emulated card works again
        alone.step()
        assert sim.state_hash == alone.state_hash


def main():
    """Each number of launches in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--launches", type=int, nargs="+", default=[0])
    parser.add_argument("--one", type=int)
    chosen = parser.parse_args()
    if chosen.one is not None:
        one(chosen.one)
        return 0
    bad = [n for n in chosen.launches if subprocess.run([sys.executable, "-B", __file__, "--one", str(n)], check=False).returncode != 0]
    print(f"{len(chosen.launches)} failures of a card, {len(bad)} handled wrongly {bad or ''}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
