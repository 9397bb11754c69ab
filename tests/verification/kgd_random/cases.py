# SPDX-License-Identifier: BSD-3-Clause
"""Cases of the KGD bench in random packings, and the analytic solutions they are compared with.

A straight hydraulic fracture in plane strain, driven at constant rate (Khristianovic, Geertsma and de Klerk: KGD). With
M = 12 eta E'^3 Q / K'^4, K' = 4 sqrt(2 / pi) K_Ic (Detournay 2004) and the volume V the fracture holds,

  l = a(M) (E' Q^3 / (12 eta))^(1/6) (V / Q)^(2/3),  w0^2 = b(M) (12 eta Q / E')^(1/2) l,  w0 p0 = c(M) (12 eta Q E')^(1/2)

with a, b, c from self_similar.py. For M large they are 0.6152, 2.1, 0.62 (Adachi and Detournay 2002), for M small those of an
evenly pressurised crack at K_Ic (Bunger, Detournay and Garagash 2005); at M = 0.01 (cases T) the fluid's share of p0 is 7 %.

E' is that of the undrained rock where pores cannot drain in time: E'_u = 4 G K_u / (K_u + G), K_u = K + alpha^2 M with
1 / M = porosity / K_f + (alpha - porosity) / K_s (Detournay and Cheng 1993; K and G plane-strain moduli of the drained packing).
"""
import math
from typing import Any, Dict, NamedTuple

from self_similar import prefactors, pressure_shape, shape

SIDE = 100.0  # m
RATE = 1e-3  # m2/s, both wings
BULK = 2.2e9  # Pa, of the fluid
DRAINED, POISSON = 14.14e9, 0.224  # Pa: E' and plane-strain nu' of the packing (hfrac lab elastic)


class Case(NamedTuple):
    """One row of the bench."""

    toughness: float  # Pa m^0.5
    viscosity: float  # Pa s
    sigma_max: float  # Pa, along x
    sigma_min: float  # Pa
    formation: float  # Pa
    permeability: float = 1e-17  # m2
    leaks: bool = False  # so much that it takes part in the comparison (leak_off.py)


CASES = {
    "T1": Case(5e6, 0.01, 3e6, 1e6, 1e6),
    "T10": Case(5e6, 0.01, 15e6, 10e6, 5e6),
    "T35": Case(5e6, 0.01, 35e6, 30e6, 10e6),
    "V10": Case(2e6, 1.0, 12e6, 10e6, 5e6),
    "M1": Case(5e6, 1.0, 12e6, 10e6, 5e6),
    "L10": Case(5e6, 0.001, 12e6, 10e6, 8e6, 8e-15, True),
}


def options(case: Case, seed: int, discs: int, **more: Any) -> Dict[str, Any]:
    """The case as a user writes it."""
    given = dict(
        model_width=SIDE, model_height=SIDE, model_seed=seed, packing_disc_count=discs,
        contact_mode="after-break", contact_normal_stiffness=16e9, contact_shear_stiffness=5.6e9,
        bond_normal_stiffness=16e9, bond_shear_stiffness=5.6e9,
        bond_tensile_strength=10e6, bond_shear_strength=40e6, bond_fracture_toughness=case.toughness,
        stress_sigma_Hmax=case.sigma_max, stress_sigma_hmin=case.sigma_min, fluid_formation_pressure=case.formation,
        fluid_viscosity=case.viscosity, fluid_bulk_modulus=BULK, flow_permeability=case.permeability, flow_aperture_limit=0.1,
        solver_kind="quasi-static", stepping_mode="coupled", stepping_flow_step=1.0,
        fracture_law="bond",  # until --set says otherwise: the tables of contacts were made when that was the default
        solver_smallest_step=1e-2, solver_pressure_change=0.3, solver_strength_overshoot=0.1, run_workers=1,
    )
    if case.leaks:
        given["flow_half_aperture_force"] = 1e15  # no closing of the rock's pipes: one permeability
    given.update(more)
    return given


def undrained(porosity: float, biot: float = 1.0, grains: float = 0.0) -> float:
    """E'_u [Pa] of the packing whose pores the fluid cannot leave; `grains`: their bulk modulus [Pa], 0: stiff."""
    storage = porosity / BULK + ((biot - porosity) / grains if grains > 0.0 else 0.0)
    young = DRAINED * (1.0 - POISSON**2)
    shear = young / (2.0 * (1.0 + POISSON))
    bulk = DRAINED * shear / (4.0 * shear - DRAINED) + biot**2 / storage
    return 4.0 * shear * bulk / (bulk + shear)


def volume_of(case: Case, modulus: float, length: float) -> float:
    """What a fracture of this half length holds [m2]: the inverse of `analytic`."""
    thick = 12.0 * case.viscosity
    by_length = prefactors(_regime(case, modulus))[0]
    return RATE * (length / (by_length * (modulus * RATE**3 / thick) ** (1.0 / 6.0))) ** 1.5


class Analytic(NamedTuple):
    """Half length [m], largest width [m], net pressure at the well [Pa]."""

    length: float
    width: float
    pressure: float


def _regime(case: Case, modulus: float) -> float:
    return 12.0 * case.viscosity * modulus**3 * RATE / (4.0 * math.sqrt(2.0 / math.pi) * case.toughness) ** 4


def opening(case: Case, modulus: float, xi: Any) -> Any:
    """Opening at x = xi l over that in the middle."""
    return shape(_regime(case, modulus), xi)


def net_pressure(case: Case, modulus: float, xi: Any) -> Any:
    """Net pressure at x = xi l over that in the middle."""
    return pressure_shape(_regime(case, modulus), xi)


def analytic(case: Case, modulus: float, volume: float, length: float) -> Analytic:
    """Half length of a fracture that holds `volume`; width and pressure of one that is `length` long."""
    thick = 12.0 * case.viscosity
    by_length, by_width, by_product = prefactors(_regime(case, modulus))
    width = math.sqrt(by_width * math.sqrt(thick * RATE / modulus) * length)
    return Analytic(
        by_length * (modulus * RATE**3 / thick) ** (1.0 / 6.0) * (volume / RATE) ** (2.0 / 3.0),
        width,
        by_product * math.sqrt(thick * RATE * modulus) / width,
    )


def limit(case: Case, modulus: float, volume: float, length: float) -> Analytic:
    """The same by the formula of the regime's limit, M = 0 or infinite: for comparison with older tables."""
    if case.toughness > 4e6:
        return Analytic(
            (modulus * volume / (2.0 * math.sqrt(math.pi) * case.toughness)) ** (2.0 / 3.0),
            4.0 * case.toughness / modulus * math.sqrt(length / math.pi),
            case.toughness / math.sqrt(math.pi * length),
        )
    thick = 12.0 * case.viscosity
    width = math.sqrt(2.1 * math.sqrt(thick * RATE / modulus) * length)
    return Analytic(
        0.6152 * (modulus * RATE**3 / thick) ** (1.0 / 6.0) * (volume / RATE) ** (2.0 / 3.0),
        width,
        0.62 * math.sqrt(thick * RATE * modulus) / width,
    )
