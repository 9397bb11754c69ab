"""A reservoir simulator's grid: reading cells, putting pressure and stress in, the include file."""
import pathlib
import tempfile
import unittest

import hfrac
from hfrac import _arrays
from support import small

STRESSED = {"boundary_kind": "stress", "stress": {"sigma_Hmax": 10e6, "sigma_hmin": 10e6}, "stepping_force_ratio": 1e-2}


def flat(cells):
    """Cells one after the other, with numpy or without."""
    return list(cells.ravel()) if _arrays.numpy is not None else list(cells)


class Grid(unittest.TestCase):
    def test_cells(self):
        with small() as sim:
            sim.step(3)
            grid = sim.set_grid(3, 2, size=(40.0, 50.0))
            cells = grid.cells()
            self.assertEqual(grid.shape, (2, 3))
            self.assertIn("3 x 2", repr(grid))
            if _arrays.numpy is not None:
                self.assertEqual(cells.shape, (2, 3))
                self.assertEqual(cells.permeability.shape, (2, 3, 3))
                self.assertLess(cells.coverage[0, 2], cells.coverage[0, 0])
            crack_length = sum(cell.crack_length for cell in flat(cells))
            self.assertAlmostEqual(crack_length, sum(crack.length for crack in sim.cracks))
            oda = flat(grid.cells(hfrac.Upscaling.ODA))
            self.assertGreater(max(cell.permeability[0] for cell in oda), 0.0)

    def test_corners_are_the_same_grid(self):
        with small() as sim:
            sim.step(2)
            by_size = flat(sim.set_grid(2, 1, size=(50.0, 100.0)).cells())
            corners = [[[[50.0 * i, 0.0], [50.0 * i + 50.0, 0.0], [50.0 * i + 50.0, 100.0], [50.0 * i, 100.0]]
                        for i in range(2)]]
            by_corners = flat(sim.set_grid(2, 1, corners=corners).cells())
            for one, other in zip(by_size, by_corners):
                self.assertAlmostEqual(one.coverage, other.coverage)
                self.assertEqual(one.crack_count, other.crack_count)

    def test_pressure_and_stress_go_in(self):
        with small(**STRESSED) as sim:
            grid = sim.set_grid(2, 2, size=(50.0, 50.0))
            added = flat(grid.set_cell_pressure([[1e5, 1e5], [2e5, 2e5]]))
            self.assertAlmostEqual(sum(added), sim.balance.host_volume)
            self.assertGreater(added[2], added[0])
            grid.set_boundary_pressure(None)
            grid.set_boundary_pressure([[1e5, 1e5], [2e5, 2e5]])
            grid.set_cell_stress([[[1e6, 0.0, 0.0]] * 2] * 2)
            self.assertGreaterEqual(sim.step(), 0)
            self.assertLess(abs(sim.balance.fluid_error), 1e-9 * sim.balance.injected_volume)

    def test_include_file(self):
        with small() as sim, tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "cells.grdecl"
            grid = sim.set_grid(4, 3, size=(25.0, 40.0))
            grid.write_grdecl(path, porosity=0.1, layers=2)
            text = path.read_text()
            for keyword in ("PERMX", "PERMY", "PORO"):
                self.assertIn(f"\n{keyword}\n", text)
            grid.write_grdecl(path, kind=hfrac.GrdeclKind.MULT, method=hfrac.Upscaling.ODA)
            self.assertIn("\nMULTX\n", path.read_text())
            with self.assertRaises(hfrac.FileError):
                grid.write_grdecl(path / "below.grdecl")

    def test_misuse(self):
        with small() as sim:
            with self.assertRaises(TypeError):
                sim.set_grid(2, 2)
            with self.assertRaises(TypeError):
                sim.set_grid(2, 2, corners=[1.0, 2.0])
            with self.assertRaises(hfrac.ArgumentError):
                sim.set_grid(0, 2, size=(1.0, 1.0))
            grid = sim.set_grid(2, 2, size=(50.0, 50.0))
            with self.assertRaises(hfrac.ArgumentError):
                grid.set_boundary_pressure([1.0, 2.0])
            with self.assertRaises(TypeError):
                grid.set_cell_pressure(["much", None])
