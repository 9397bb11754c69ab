# SPDX-License-Identifier: BSD-3-Clause
"""The case of the meeting bench, and the criterion it is compared with.

Renshaw and Pollard (1995): at right angles a fracture crosses an unbonded interface if that does not slip, around the tip that has just come
to it, before the rock beyond breaks:

  s_H / (T + s_h) > (0.35 + 0.35 / mu) / 1.06

s_H, s_h: effective far-field stresses across the interface and along it, T: tensile strength of the rock, mu: friction. Slip and breakage are compared at

  r_c = (K_Ic / (T + s_h))^2 / (2 pi)

from the tip, where the stress K_Ic / sqrt(2 pi r) - s_h is T: discs have to be smaller than that (r_c / R >= 1). T is the strength of the
case's own rock in direct tension, mean of three specimens of 1 500 discs. M = 12 eta E'^3 Q / K'^4, K' = 4 sqrt(2 / pi) K_Ic.
"""
import math
from typing import Any, Dict, List

SIDE, MIDDLE, JOINT, HALF = 100.0, 50.0, 9.0, 10.0  # m: model, well, from the well to a joint, half length of a joint
PORE, SIGMA_MIN = 0.2e6, 1e6  # Pa: pressure of pores; effective smaller stress, along the joints
TOUGHNESS, MODULUS = 5e6, 18.6e9  # Pa m^0.5; Pa, undrained
STIFFNESS = 5e10  # Pa/m, of joints, both ways
RATE, VISCOSITY = 1e-3, 0.01  # m2/s, Pa s
WELL = {"x": MIDDLE, "y": MIDDLE, "radius": 1.65, "control": "rate", "rate": RATE}
ROCK: Dict[str, Any] = dict(
    contact_mode="after-break", contact_normal_stiffness=16e9, contact_shear_stiffness=5.6e9, bond_normal_stiffness=16e9, bond_shear_stiffness=5.6e9,
    bond_tensile_strength=4e6, bond_shear_strength=60e6, solver_kind="quasi-static",
)
TENSILE_STRENGTH = 1.537e6  # Pa: tensile_strength(), of tables that were made before


def scale_by(factor: float) -> None:
    """Stresses and strengths, so that r_c goes with 1 / factor^2 and the criterion stays."""
    global PORE, SIGMA_MIN
    PORE, SIGMA_MIN = PORE * factor, SIGMA_MIN * factor
    for key in ("bond_tensile_strength", "bond_shear_strength"):
        ROCK[key] *= factor


def options(ratio: float, seed: int) -> Dict[str, Any]:
    """Discs are fine along the fracture's way and on either side of it; slots reach to 5 m from the well's middle and more."""
    return dict(
        ROCK, model_width=SIDE, model_height=SIDE, model_seed=seed, packing_disc_count=1200, packing_coarsening=4.0, packing_fine_half_length=11.0,
        packing_fine_half_width=3.5, bond_fracture_toughness=TOUGHNESS, stress_sigma_Hmax=PORE + ratio * SIGMA_MIN, stress_sigma_hmin=PORE + SIGMA_MIN,
        fluid_formation_pressure=PORE, fluid_viscosity=VISCOSITY, fluid_bulk_modulus=2.2e9, flow_permeability=1e-17, flow_aperture_limit=0.1,
        stepping_mode="coupled", stepping_flow_step=1.0, solver_smallest_step=1e-2, solver_pressure_change=0.3, solver_strength_overshoot=0.1,
        run_workers=1, fracture_law="facet", fracture_plane_modulus=MODULUS, fracture_perforation_length=4.0,
    )


def joints(friction: float) -> List[Dict[str, Any]]:
    """One on either side. E' over their stiffness is 0.4 m, less than a disc."""
    return [
        dict(x1=MIDDLE + way * JOINT, y1=MIDDLE - HALF, x2=MIDDLE + way * JOINT, y2=MIDDLE + HALF, state="smooth-broken", friction=friction,
             normal_stiffness=STIFFNESS, shear_stiffness=STIFFNESS, residual_aperture=1e-4)
        for way in (1.0, -1.0)
    ]


def tensile_strength() -> float:
    """Pa, direct tension."""
    import hfrac

    found = [hfrac.lab("tension", hfrac.Definition(**ROCK), disc_count=1500, seed=seed).report.value for seed in (1, 2, 3)]
    return sum(found) / len(found)


def friction_needed(ratio: float, strength: float) -> float:
    """Least friction with which the fracture crosses; infinite where none is enough."""
    left = 1.06 * ratio * SIGMA_MIN / (strength + SIGMA_MIN)
    return 0.35 / (left - 0.35) if left > 0.35 else math.inf


def process_zone(strength: float) -> float:
    """r_c [m]."""
    return (TOUGHNESS / (strength + SIGMA_MIN)) ** 2 / (2.0 * math.pi)


def viscosity_number() -> float:
    """M."""
    return 12.0 * VISCOSITY * MODULUS**3 * RATE / (4.0 * math.sqrt(2.0 / math.pi) * TOUGHNESS) ** 4
