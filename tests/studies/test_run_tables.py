#!/usr/bin/python3
"""hfrac.Run: tables as pandas has them, fields as xarray has them, and words where something is missing."""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import support

try:
    import pandas  # noqa: F401
    import xarray  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import numpy as np

import hfrac


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = tempfile.TemporaryDirectory(prefix="hfrac-studies-")
        cls.folder = pathlib.Path(cls.top.name)
        (cls.folder / "case.toml").write_text(support.CASE)
        for name, packed in (("run", "zlib"), ("plain", "none"), ("lz4", "lz4")):
            (cls.folder / f"{name}.toml").write_text(support.CASE.replace("every = 2", f'every = 2\ncompression = "{packed}"'))
            done = support.hfrac("run", cls.folder / f"{name}.toml", "-o", cls.folder / name, "-q")
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.top.cleanup()

    def test_history_is_the_table(self):
        run = hfrac.Run(self.folder / "run")
        with open(self.folder / "run/history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(run.history.columns), list(rows[0]))
        self.assertEqual(run.history["well_pressure_Pa"].tolist(), [float(row["well_pressure_Pa"]) for row in rows])
        self.assertEqual(len(run.cracks), run.summary["state"]["crack_count"])
        self.assertEqual(len(run.fractures), len(run.summary["fractures"]))
        self.assertEqual(len(run.events), len(pandas.read_csv(self.folder / "run/events.csv")))

    def test_fields_are_those_of_the_engine(self):
        run = hfrac.Run(self.folder / "run")
        self.assertEqual(run.times(), [0.0, 0.2, 0.4])
        last, early = run.fields(), run.fields(0.19)
        self.assertAlmostEqual(float(last["time"]), 0.4)
        self.assertAlmostEqual(float(early["time"]), 0.2)
        with hfrac.Simulation(self.folder / "run/case.toml") as sim:
            sim.step(4)
            self.assertTrue(np.allclose(last["radius_m"], np.asarray(sim.discs.radius), rtol=1e-6))
            self.assertTrue(np.allclose(last["x"], np.asarray(sim.discs.position)[:, 0], atol=1e-4))
            flow = run.fields(series="flow")
            self.assertEqual(flow["pressure_Pa"].attrs["units"], "Pa")
            self.assertEqual(len(flow["pressure_Pa"]), len(np.asarray(sim.domains.pressure)) - 1)  # a well is no cell
            bonds = run.fields(series="bonds")
            self.assertEqual(bonds.sizes["point"], sim.state.disc_count)
            self.assertEqual(bonds.sizes["item"], sim.state.bond_count)

    def test_packed_or_not_is_the_same(self):
        first, second = hfrac.Run(self.folder / "run").fields(), hfrac.Run(self.folder / "plain").fields()
        for name in first:
            self.assertTrue((first[name].values == second[name].values).all(), name)
        with self.assertRaisesRegex(hfrac.FileError, "packed by vtkLZ4DataCompressor"):
            hfrac.Run(self.folder / "lz4").fields()

    def test_what_is_missing_is_said(self):
        with self.assertRaisesRegex(hfrac.FileError, "is no run folder"):
            hfrac.Run(self.folder)
        with self.assertRaisesRegex(hfrac.FileError, "series 'disc' must be one of"):
            hfrac.Run(self.folder / "run").fields(series="disc")
        done = subprocess.run([sys.executable, "-B", "-c", "import sys; sys.modules['pandas'] = None\nimport hfrac\n"
                               f"hfrac.Run({str(self.folder / 'run')!r}).history"], capture_output=True, text=True)
        self.assertIn("this needs pandas: apt-get install python3-pandas", done.stderr)


if __name__ == "__main__":
    unittest.main()
