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
    def matched(self, folder, pressure, more=MATCH):
        """The study, and what `hfrac match` says, of a record of one pressure."""
        study = support.write_study(folder, more=more)
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

    def test_members_are_spread_over_packings(self):
        """Each packing has its share of members in every pass, dealt anew; what packings scatter at a held pressure is nothing, and said."""
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            study, done = self.matched(folder, "21e6", "packings = [5, 6, 7, 8]\n" + MATCH)
            dealt = [[next(line.split("=")[1] for line in (folder / f"out/iteration_{k}/{member:05d}/asked.toml").read_text().splitlines()
                           if line.split("=")[0].strip() == "seed") for member in range(16)] for k in range(3)]
            for one in dealt:
                self.assertEqual(sorted(map(int, one)), sorted(4 * [5, 6, 7, 8]))
            self.assertNotEqual(dealt[0], dealt[1])
            self.assertEqual(len(list((folder / "out/packings").iterdir())), 4)
            self.assertIn("well_pressure_Pa: 4 packings scatter by ", done.stdout)
            with open(folder / "out/parameters.csv", newline="") as file:
                found = {(row["parameter"], row["ensemble"]): row for row in csv.DictReader(file)}
            self.assertAlmostEqual(float(found["pressure", "posterior"]["P50"]) / 21e6, 1.0, delta=0.02)
            self.assertEqual(found["bond.tensile_strength", "posterior"]["verdict"], "not constrained by the data")
            again = support.hfrac("match", study, "-o", folder / "out")
            self.assertEqual(again.stdout, done.stdout)

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
