#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""UCS over tensile strength of variants of the bond and its contact, every seed, and a calibrated granite: the tables of docs/laboratory.md.

usage: hard_rock.py [DISCS]                   with bindings/python on PYTHONPATH; 5 minutes of one core with 1000 discs
       hard_rock.py granite [SEED ...]        calibrates Lac du Bonnet's granite from these first packings (1), and tests what is found
                                              on packings 1 to 4: Brazilian strength, strength under confinement; 7 minutes a seed
"""
import math
import sys

import hfrac

SEEDS = 1, 2, 3, 4
STRONG = dict(moment_contribution=0.0, shear_strength=170e6)
FLAT = dict(shape="flat")
AFTER = dict(mode="after-break", shear_stiffness=5.6e9, normal_stiffness=16e9)
LINEAR = dict(shear_stiffness=5.6e9, normal_stiffness=16e9)
VARIANTS = [  # name, options of contact, options of bond
    ("default", {}, {}),
    ("beta 0, tau_c = 4 sigma_c", {}, STRONG),
    ("the same, friction 0.85", dict(friction=0.85), STRONG),
    ("flat", FLAT, STRONG),
    ("flat, friction 0.85", dict(FLAT, friction=0.85), STRONG),
    ("flat, after-break, friction 0.6", dict(FLAT, **AFTER, friction=0.6), dict(STRONG, **LINEAR)),
    ("round, open 0.3, friction 0.85", dict(friction=0.85), dict(STRONG, open_share=0.3)),
    ("flat, open 0.15, friction 0.85", dict(FLAT, friction=0.85), dict(STRONG, open_share=0.15)),
    ("flat, open 0.3", FLAT, dict(STRONG, open_share=0.3)),
    ("flat, open 0.3, friction 0.85", dict(FLAT, friction=0.85), dict(STRONG, open_share=0.3)),
    ("flat, open 0.3, friction 1.2", dict(FLAT, friction=1.2), dict(STRONG, open_share=0.3)),
    ("the same, tau_c = sigma_c", dict(FLAT, friction=1.2), dict(STRONG, open_share=0.3, shear_strength=42.5e6)),
    ("flat, open 0.3, friction 1.2, G_c 200 kJ/m2", dict(FLAT, friction=1.2), dict(STRONG, open_share=0.3, fracture_energy=200e3)),
]


def granite(first):
    asked = dict(modulus=69e9, poisson=0.26, compressive_strength=200e6, tensile_strength=9.3e6)
    rock, found = hfrac.calibrate(strength_disc_count=1000, seed=first, **asked)
    print(f"calibrated from packing {first}: reached {found.reached}, {found.test_count} tests in {found.seconds:.0f} s, friction {rock.get('contact.friction')}")
    for (name, target), mean, spread in zip(asked.items(), found.achieved, found.spread):
        print(f"  {name:22} {mean:.4g} +- {spread:.2g}, {100 * (mean / target - 1):+.1f} %")
    tests = {"tension": {}, "brazilian": {}, "uniaxial": {}, "biaxial, 10 MPa": {"confining": 10e6}, "biaxial, 30 MPa": {"confining": 30e6}}
    mean = {}
    for test, more in tests.items():
        values = [hfrac.lab(test.split(",")[0], rock, disc_count=1000, seed=seed, **more).report.value for seed in SEEDS]
        mean[test] = sum(values) / len(values)
        print(f"  {test:22} {', '.join(f'{value * 1e-6:.4g}' for value in values)} MPa, packings 1 to 4", flush=True)
    for test, more in tests.items():
        if not more:
            continue
        rise = (mean[test] - mean["uniaxial"]) / more["confining"]  # (1 + sin phi) / (1 - sin phi)
        print(f"  friction angle from 0 to {more['confining'] * 1e-6:.0f} MPa: {math.degrees(math.asin((rise - 1) / (rise + 1))):.0f} degrees")


def main():
    if sys.argv[1:2] == ["granite"]:
        for first in [int(word) for word in sys.argv[2:]] or [1]:
            granite(first)
        return
    discs = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    print("| variant | tension, MPa, seeds 1 to 4 | UCS, MPa | ratio of means | E, GPa | nu |\n|---|---|---|---|---|---|")
    for name, contact, bond in VARIANTS:
        rock = hfrac.Definition(contact=contact, bond=bond)
        tension, press = ([hfrac.lab(test, rock, disc_count=discs, seed=seed).report for seed in SEEDS] for test in ("tension", "uniaxial"))
        mean = {key: sum(getattr(report, key) for report in press) / len(SEEDS) for key in ("value", "modulus", "poisson")}
        ratio = sum(report.value for report in press) / sum(report.value for report in tension)
        values = (", ".join(f"{report.value * 1e-6:.{digits}f}" for report in reports) for reports, digits in ((tension, 1), (press, 0)))
        print(f"| {name} | {' | '.join(values)} | {ratio:.1f} | {mean['modulus'] * 1e-9:.1f} | {mean['poisson']:.2f} |", flush=True)


main()
