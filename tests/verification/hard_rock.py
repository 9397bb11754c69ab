#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""UCS over tensile strength of variants of the bond and its contact, every seed: the table of docs/laboratory.md.

usage: hard_rock.py [DISCS]                   with bindings/python on PYTHONPATH; 2 minutes of one core with 1000 discs
"""
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
]


def main():
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
