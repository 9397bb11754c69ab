"""Temperature: setting it while running, by disc and by cell, and the heat balance."""
import unittest

import hfrac
from support import plain, small

HOT = {"thermal": {"mode": "transport", "rock_temperature": 573.15, "expansion": 1e-5}}


class Heat(unittest.TestCase):
    def test_none_unless_asked_for(self):
        with small() as sim:
            with self.assertRaisesRegex(hfrac.ArgumentError, "thermal.mode"):
                sim.set_temperature(600.0)

    def test_uniform(self):
        with small(thermal={"mode": "uniform"}) as sim:
            sim.set_temperature(600.0)
            sim.step()
            self.assertEqual((sim.heat.mode, sim.heat.lowest, sim.heat.highest), (1, 600.0, 600.0))

    def test_by_disc_and_by_cell(self):
        with small(**HOT) as sim:
            discs = plain(sim.discs.temperature)
            self.assertEqual(set(discs), {573.15})
            discs[0] += 5.0
            sim.set_disc_temperature(discs)
            sim.hold_disc_temperature([1] + [0] * (len(discs) - 1))
            self.assertEqual(plain(sim.discs.temperature), discs)
            grid = sim.set_grid(2, 1, size=(50.0, 100.0))
            grid.set_temperature([[560.0, 570.0]])
            cells = [cell for row in plain(grid.temperature) for cell in (row if hasattr(row, "__len__") else [row])]
            self.assertAlmostEqual(cells[0], 560.0)
            self.assertAlmostEqual(cells[1], 570.0)

    def test_cold_well(self):
        with small(**HOT) as sim:
            well = sim.wells[0]
            well.set_temperature(300.0)
            sim.step(2)
            self.assertEqual(well.temperature, 300.0)
            heat = sim.heat
            self.assertLess(heat.wells, 0.0)
            self.assertLess(abs(heat.error), 1e-6 * abs(heat.wells))
            self.assertEqual(min(plain(sim.domains.temperature)), 300.0)


if __name__ == "__main__":
    unittest.main()
