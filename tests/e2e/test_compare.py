"""Several runs against each other: the table holds what the runs say, and its picture is drawn."""
import csv
import pathlib
import re
import shutil
import tempfile
import unittest

from hfrac_runs import CASE, hfrac, history, summary

RUNS = [(40, 1), (40, 2), (60, 1), (60, 2)]  # pressure in MPa, seed
STEPS = 3


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        text = re.sub(r"disc_count = \d+", "disc_count = 600", pathlib.Path(CASE).read_text())
        cls.folders = []
        for pressure, seed in RUNS:
            folder = cls.top / f"p{pressure}-s{seed}"
            case = cls.top / "case.toml"
            changed = re.sub(r"(?m)^pressure = .*", f"pressure = {pressure}e6", text)
            case.write_text(re.sub(r"(?m)^seed = .*", f"seed = {seed}", changed))
            done = hfrac("run", case, "-o", folder, "--steps", STEPS, "-q")
            assert done.returncode == 0, done.stderr
            cls.folders.append(folder)

    def compare(self, *arguments):
        picture = self.top / "compared.png"
        done = hfrac("plot", "--compare", *self.folders, *arguments, "-o", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        with open(picture.with_suffix(".csv"), newline="") as file:
            return list(csv.DictReader(file))

    def test_ends_of_runs_against_an_option(self):
        rows = self.compare("--x", "well[0].pressure", "--y", "cracks,length,wings,initiation-pressure")
        self.assertEqual(len(rows), len(RUNS))
        for row, (pressure, _), folder in zip(rows, RUNS, self.folders):
            told = summary(folder)
            self.assertEqual(float(row["well[0].pressure_Pa"]), pressure * 1e6)
            self.assertEqual(int(row["crack_count"]), told["state"]["crack_count"])
            self.assertEqual(float(row["fracture_length_m"]), told["longest_fracture"]["length_m"])
            self.assertEqual(float(row["fracture_wings"]), max((f["wings"] for f in told["fractures"]), default=0))
            first = [line for line in history(folder) if int(line["crack_count"]) > told["state"]["equilibration_cracks"]]
            expected = first[0]["well_pressure_Pa"] if first else ""
            self.assertEqual(row["initiation_pressure_Pa"], expected)

    def test_courses_of_runs_by_series(self):
        rows = self.compare("--x", "step", "--y", "cracks", "--series", "well[0].pressure")
        self.assertEqual(len(rows), len(RUNS) * (STEPS + 1))
        expected = [line["crack_count"] for folder in self.folders for line in history(folder)]
        self.assertEqual([row["crack_count"] for row in rows], expected)

    def test_a_table_is_drawn_again(self):
        self.compare("--x", "model.seed", "--y", "cracks")
        picture = self.top / "again.svg"
        done = hfrac("plot", "--compare", self.top / "compared.csv", "-o", picture, "--title", "Again")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("</svg>", picture.read_text())

    def test_what_is_unknown_is_refused_by_name(self):
        for arguments, word in (
            (["--x", "bond.strenght", "--y", "cracks"], "bond.strenght"),
            (["--x", "model.seed", "--y", "lenght"], "lenght"),
            (["--x", "model.seed"], "--y"),
        ):
            done = hfrac("plot", "--compare", *self.folders, *arguments, "-o", self.top / "no.png")
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(word, done.stderr)
        self.assertFalse((self.top / "no.png").exists())
        self.assertEqual(hfrac("plot").returncode, 2)


if __name__ == "__main__":
    unittest.main()
