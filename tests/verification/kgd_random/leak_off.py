# SPDX-License-Identifier: BSD-3-Clause
"""A tough fracture that leaks off: half length, pressure and leaked volume from what went into it, without anything fitted.

The fluid is thin, so that the net pressure is even: p = K_Ic / sqrt(pi l), and the fracture holds what an impermeable one of its length
does (cases.volume_of). Fluid diffuses straight into the rock from either face since the tip passed at t0(x), as in Carter's law, but
under the excess D(t) of the fracture's pressure over the formation's, whatever it was then (Carslaw and Jaeger, Conduction of Heat in
Solids, section 2.5):

  u(x, t) = 2 k / (eta sqrt(pi c)) int_t0(x)^t D(s) / sqrt(t - s) ds          per length, both faces;  4 C_L sqrt(t - t0) for even D
  C_L = k D / (eta sqrt(pi c)),  c = k / (eta S),  S = phi / K_f + (alpha - phi) / K_s + alpha^2 / (K + G)

with S the storage of rock that cannot widen along the fracture (Detournay and Cheng 1993; K and G plane moduli), and

  V_in(t) = V(l) + int u dx  over both wings, from the hole to the tips

gives l(t). V_in is the injected volume less what the hole stores and what leaks through its own wall, both measured: the formula has no hole.

Rock that takes up fluid swells and presses on the fracture. Thin against l, a layer with int P dy = u / S along the fracture is a line of
dilation centres; with eta_p = alpha G / (K + G) it presses with (eta_p / pi) d/dx int P / (x - s) ds, which for u as of an ellipse
(so it is where l grows as sqrt(t)) is even (derived here):

  backstress = 2 eta_p V_leaked / (pi l^2 S)

It adds to the pressure at the well and to D, and changes neither opening nor growth. Carter's law as the limit of diffusion straight into the rock,
and backstress beside it: Liu, Zhang and Detournay 2026 (Journal of Fluid Mechanics), who treat what this leaves out, diffusion in the plane.
"""
import math
from typing import List, NamedTuple, Tuple

import cases
import measure

WHOLE = cases.DRAINED * (1.0 - cases.POISSON**2)
SHEAR = WHOLE / (2.0 * (1.0 + cases.POISSON))  # Pa, G
BULK = cases.DRAINED * SHEAR / (4.0 * SHEAR - cases.DRAINED)  # Pa, plane K


class Found(NamedTuple):
    """One state against the reference."""

    length: float  # m, the reference's half length
    backstress: float  # Pa, the reference's
    share: float  # of what went into the fracture, leaked
    leak: float  # leaked volume over the reference's
    by_law: float  # and over what the law says of the length and pressure as they were measured
    pressure: float  # net pressure over the reference's without backstress


class History:
    """Half length and excess pressure in time, and what leaks by them."""

    def __init__(self, factor: float, hole: float) -> None:
        self.factor = factor  # 2 k / (eta sqrt(pi c))
        self.times: List[float] = []
        self.excess: List[float] = []
        self.parts: List[Tuple[float, float]] = []  # of both wings: length [m] that the tip passed, when
        self.length = hole  # m; what the hole's own wall leaks is no part of this

    def leaked(self, time: float, excess: float, length: float) -> float:
        """Volume leaked by now [m2] if length and excess pressure are these now."""
        more = max(0.0, length - self.length)
        parts = self.parts + ([(2.0 * more, 0.5 * (time + (self.times[-1] if self.times else 0.0)))] if more > 0.0 else [])
        total = 0.0
        for share, since in parts:
            # int D / sqrt(t - s) ds, D constant between two times.
            integral, begin = 0.0, since
            for at, value in zip(self.times + [time], self.excess + [excess]):
                if at <= begin:
                    continue
                integral += 2.0 * value * (math.sqrt(time - begin) - math.sqrt(max(0.0, time - at)))
                begin = at
            total += share * self.factor * integral
        return total

    def keep(self, time: float, excess: float, length: float) -> None:
        if length > self.length:
            self.parts.append((2.0 * (length - self.length), 0.5 * (time + (self.times[-1] if self.times else 0.0))))
            self.length = length
        self.times.append(time)
        self.excess.append(excess)


class Reference:
    """Steps in time beside a simulation."""

    def __init__(self, case: cases.Case, modulus: float, porosity: float, permeability: float, hole: float) -> None:
        self.case, self.modulus = case, modulus
        self.storage = porosity / cases.BULK + 1.0 / (BULK + SHEAR)
        self.diffusivity = permeability / (case.viscosity * self.storage)
        factor = 2.0 * permeability / (case.viscosity * math.sqrt(math.pi * self.diffusivity))
        self.reference, self.measured = History(factor, hole), History(factor, hole)
        self.time = self.wall = self.inflow = 0.0
        self.by_law = self.expected = self.length = 0.0
        self.wall_rate = 0.0

    def backstress(self, leaked: float, length: float) -> float:
        return 2.0 * SHEAR / (BULK + SHEAR) * leaked / (math.pi * length**2 * self.storage)

    def step(self, time: float, found: "measure.Fracture") -> None:
        base = self.case.sigma_min - self.case.formation
        self.wall += 0.5 * (self.wall_rate + found.wall_leak) * (time - self.time)
        self.wall_rate = found.wall_leak
        # Hole and slots, too, are a part of the length; what the hole alone took is not the fracture's.
        self.inflow = found.injected - (found.pores - found.volume) - self.wall
        self.by_law = self.measured.leaked(time, base + found.pressure, found.length)
        self.measured.keep(time, base + found.pressure, found.length)
        if found.cracks > 0:
            low, high = 1.0, 100.0
            excess = 0.0
            for _ in range(40):
                length = 0.5 * (low + high)
                held = cases.volume_of(self.case, self.modulus, length)
                excess = base + self.case.toughness / math.sqrt(math.pi * length) + self.backstress(max(0.0, self.inflow - held), length)
                if held + self.reference.leaked(time, excess, length) > self.inflow:
                    high = length
                else:
                    low = length
            self.expected = self.reference.leaked(time, excess, length)
            self.reference.keep(time, excess, length)
            self.length = length
        self.time = time

    def compare(self, found: "measure.Fracture") -> Found:
        leaked = self.inflow - found.volume
        length = self.length
        return Found(
            length, self.backstress(self.expected, length), leaked / self.inflow, leaked / self.expected, leaked / self.by_law,
            found.pressure * math.sqrt(math.pi * found.length) / self.case.toughness,
        )
