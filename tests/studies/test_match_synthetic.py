#!/usr/bin/python3
"""examples/field/match.toml, whose record is made with known values, gives K_Ic, sigma_hmin and permeability back within 10 % (300 runs)."""
import csv
import pathlib
import tempfile
import unittest

import support

TRUTH = {"K_Ic": 4.2e6, "sigma_hmin": 10.8e6, "permeability": 1e-14}


class Synthetic(unittest.TestCase):
    def test_the_truth_is_recovered(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            done = support.hfrac("match", support.ROOT / "examples/field/match.toml", "-o", top, limit=3500)
            self.assertEqual(done.returncode, 0, done.stderr)
            print(done.stdout)
            with open(pathlib.Path(top, "parameters.csv"), newline="") as file:
                found = {row["parameter"]: row for row in csv.DictReader(file) if row["ensemble"] == "posterior"}
            for name, value in TRUTH.items():
                self.assertAlmostEqual(float(found[name]["P50"]) / value, 1.0, delta=0.1, msg=name)
                self.assertEqual(found[name]["verdict"], "constrained", name)


if __name__ == "__main__":
    unittest.main()
