#!/usr/bin/python3
"""hfrac match from end to end on a tiny case: a record of a well at a held pressure tells that pressure and nothing of the strength."""
import csv
import pathlib
import tempfile
import unittest

import support

MATCH = """|[match]
members = 16
iterations = 2
[[match.data]]
record = "record.csv"
error = 0.2e6
points = 4
"""


class Match(unittest.TestCase):
    def matched(self, folder, pressure):
        """The study, and what `hfrac match` says, of a record of one pressure."""
        study = support.write_study(folder, more=MATCH)
        (folder / "record.csv").write_text("time_s,well_pressure_Pa\n" + "".join(f"{0.1 * k:.1f},{pressure}\n" for k in range(1, 5)))
        done = support.hfrac("match", study, "-o", folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        return study, done

    def test_what_data_tell_and_what_not(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            study, done = self.matched(folder, "21e6")
            with open(folder / "out/parameters.csv", newline="") as file:
                found = {(row["parameter"], row["ensemble"]): row for row in csv.DictReader(file)}
            pressure, strength = found["pressure", "posterior"], found["bond.tensile_strength", "posterior"]
            self.assertAlmostEqual(float(pressure["P50"]) / 21e6, 1.0, delta=0.02)
            self.assertEqual(pressure["verdict"], "constrained")
            self.assertLess(float(pressure["deviation_ratio"]), 0.1)
            self.assertEqual(strength["verdict"], "not constrained by the data")
            self.assertIn("the data do not constrain bond.tensile_strength", done.stdout)
            self.assertTrue((folder / "out/match.png").read_bytes().startswith(b"\x89PNG"))
            text = (folder / "out/members.csv").read_bytes()
            again = support.hfrac("match", study, "-o", folder / "out")
            self.assertEqual(again.stdout, done.stdout)
            self.assertEqual((folder / "out/members.csv").read_bytes(), text)

    def test_a_record_that_no_member_explains_is_told(self):
        """The law of the pressure ends at 30 MPa, and the ensemble stands there, narrow: that is no estimate."""
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            _, done = self.matched(folder, "32e6")
            self.assertIn("the record is not explained", done.stdout)
            with open(folder / "out/parameters.csv", newline="") as file:
                told = {row["verdict"] for row in csv.DictReader(file) if row["ensemble"] == "posterior"}
            self.assertEqual(told, {"record not explained"})


if __name__ == "__main__":
    unittest.main()
