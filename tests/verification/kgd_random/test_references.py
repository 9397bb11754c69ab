#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the benches compare with, in cases where the answer is known: two cracks from a hole, leak-off, and the exactness of both."""
import math
import pathlib
import sys
import types
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "bindings" / "python")]

import cases  # noqa: E402
import holed_crack  # noqa: E402
import leak_off  # noqa: E402


class HoledCrack(unittest.TestCase):
    def test_long_cracks_are_straight_ones(self) -> None:
        for lengths, half in (((10.0, 10.0), 11.0), ((6.0, 14.0), 11.0)):
            found = holed_crack.intensities(1.0, lengths, 2e6, 0.0, 0.0)
            for k in found:
                self.assertAlmostEqual(k / (2e6 * math.sqrt(math.pi * half)), 1.0, delta=0.01)

    def test_pressure_is_tension_all_round(self) -> None:
        # A pressure in hole and cracks and the same stress all round are no load.
        for k in holed_crack.intensities(2.7, (1.7, 2.3), 5e6, 5e6, 5e6):
            self.assertAlmostEqual(k, 0.0, delta=1e-6 * 5e6)

    def test_short_cracks_feel_the_wall(self) -> None:
        # 1.12 times the mean of Kirsch's hoop stress over the crack, by its weight for an edge crack, to some per cent.
        length = 0.1
        hoop = 1.0 + 0.5 * (1.0 + length / 2.0) ** -2 + 1.5 * (1.0 + length / 2.0) ** -4
        found = holed_crack.intensities(1.0, (length, length), 0.0, 0.0, -1e6)[0]
        self.assertAlmostEqual(found / (1.12 * hoop * 1e6 * math.sqrt(math.pi * length)), 1.0, delta=0.07)

    def test_the_weakest_tip_goes_first(self) -> None:
        first, most = holed_crack.breakdown_pressure(2.7, (1.7, 2.3), 3e6, 1e6, 5e6, 3.0)
        self.assertGreaterEqual(most, first)
        longer, _ = holed_crack.breakdown_pressure(2.7, (1.7, 3.3), 3e6, 1e6, 5e6, 3.0)
        self.assertLess(longer, first)


class LeakOff(unittest.TestCase):
    def test_even_pressure_is_carters_law(self) -> None:
        history = leak_off.History(2e-10, 0.0)
        history.keep(0.0, 3e6, 10.0)
        for k in range(1, 50):
            history.keep(2.0 * k, 3e6, 10.0)
        self.assertAlmostEqual(history.leaked(100.0, 3e6, 10.0) / (20.0 * 2e-10 * 3e6 * 2.0 * math.sqrt(100.0)), 1.0, delta=1e-9)

    def test_tight_rock_gives_the_fracture_all(self) -> None:
        case = cases.CASES["L10"]
        reference = leak_off.Reference(case, 18.6e9, 0.117, 1e-30, 2.7)
        for second in range(1, 60):
            state = types.SimpleNamespace(injected=1e-3 * second, pores=0.0, volume=0.0, wall_leak=0.0, length=5.0, pressure=1e6, cracks=1)
            reference.step(float(second), state)
        self.assertAlmostEqual(cases.volume_of(case, 18.6e9, reference.length), 0.059, delta=1e-6)
        self.assertLess(reference.backstress(reference.expected, reference.length), 1.0)

    def test_leaks_more_the_more_permeable(self) -> None:
        case = cases.CASES["L10"]
        lengths = []
        for permeability in (1e-16, 1e-15, 1e-14):
            reference = leak_off.Reference(case, 18.6e9, 0.117, permeability, 2.7)
            for second in range(1, 60):
                state = types.SimpleNamespace(injected=1e-3 * second, pores=0.0, volume=0.0, wall_leak=0.0, length=5.0, pressure=1e6, cracks=1)
                reference.step(float(second), state)
            held = cases.volume_of(case, 18.6e9, reference.length)
            self.assertAlmostEqual(held + reference.expected, 0.059, delta=1e-6)
            lengths.append(reference.length)
        self.assertEqual(lengths, sorted(lengths, reverse=True))


if __name__ == "__main__":
    unittest.main()
