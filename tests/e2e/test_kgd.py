"""A fracture of facets: its profile beside KGD as `hfrac plot --kgd` draws it, and its meeting with a natural fracture."""
import csv
import pathlib
import shutil
import sys
import tempfile
import unittest

from hfrac_runs import CASE, hfrac

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "verification" / "kgd_random"))
import self_similar  # noqa: E402

MODULUS, TOUGHNESS, VISCOSITY, RATE = 18.6e9, 5e6, 0.1, 3e-2
CASE_TEXT = f"""
[packing]
disc_count = 600
[contact]
mode = "after-break"
normal_stiffness = 16e9
shear_stiffness = 5.6e9
[bond]
normal_stiffness = 16e9
shear_stiffness = 5.6e9
tensile_strength = 20e6
shear_strength = 60e6
fracture_toughness = {TOUGHNESS}
[fracture]
law = "facet"
plane_modulus = {MODULUS}
perforation_length = 4.0
[stress]
sigma_Hmax = 20e6
sigma_hmin = 20e6
[fluid]
formation_pressure = 2e6
viscosity = {VISCOSITY}
[solver]
kind = "quasi-static"
[stepping]
mode = "coupled"
flow_step = 2.0
steps = 40
[output]
every = 5
[[well]]
radius = 6.0
control = "rate"
rate = {RATE}
"""


class BesideKgd(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)

    def test_run_and_solution(self):
        case = self.top / "case.toml"
        case.write_text(CASE_TEXT)
        folder = self.top / "run"
        done = hfrac("run", case, "-o", folder, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = hfrac("plot", folder, "--kgd", "--svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        pictures = folder / "pictures"
        self.assertEqual((pictures / "kgd.png").read_bytes()[:4], b"\x89PNG")
        self.assertIn("<svg", (pictures / "kgd.svg").read_text())
        with open(pictures / "kgd.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        run = [row for row in rows if row["series"].startswith("this run")]
        solution = [row for row in rows if row["series"].startswith("KGD")]
        with open(folder / "fracture_lines.csv", newline="") as file:  # of the same state, the last
            line = [row for row in csv.DictReader(file) if row["fracture"] == "0"]
        self.assertEqual(len(run), len(line))
        for one, same in zip(run, line):
            self.assertAlmostEqual(float(one["aperture_m"]), float(same["aperture_m"]), delta=1e-6 * 1e-3 + 1e-6 * float(same["aperture_m"]))
        # The volume of the line with the hole as open as its mouths.
        place, part, opening = ([float(row[name]) for row in line] for name in ("distance_m", "length_m", "aperture_m"))
        volume = sum(w * d for w, d in zip(opening, part))
        for k in range(1, len(line)):
            if place[k - 1] < 0.0 < place[k]:
                volume += 0.5 * (opening[k] + opening[k - 1]) * max(0.0, place[k] - place[k - 1] - 0.5 * (part[k] + part[k - 1]))
        m = 12.0 * VISCOSITY * MODULUS**3 * RATE / (4.0 * (2.0 / 3.141592653589793) ** 0.5 * TOUGHNESS) ** 4
        a, b, c = self_similar.prefactors(m)
        half = a * (MODULUS * RATE**3 / (12.0 * VISCOSITY)) ** (1 / 6) * (volume / RATE) ** (2 / 3)
        width = (b * (12.0 * VISCOSITY * RATE / MODULUS) ** 0.5 * half) ** 0.5
        pressure = c * (12.0 * VISCOSITY * RATE * MODULUS) ** 0.5 / width
        widest = max(float(row["aperture_m"]) for row in solution)
        highest = max(float(row["net_pressure_Pa"]) for row in solution if row["net_pressure_Pa"])
        ends = [float(row["distance_m"]) for row in solution]
        self.assertAlmostEqual(max(ends) - min(ends), 2 * 0.99 * half, delta=0.01 * half)
        self.assertAlmostEqual(widest, width, delta=0.005 * width)
        self.assertAlmostEqual(highest, pressure, delta=0.005 * pressure)
        self.assertEqual(len(solution), 2 * len(self_similar.PLACES) - 1)

    def test_what_it_lacks_is_told(self):
        folder = self.top / "smoke"
        done = hfrac("run", CASE, "-o", folder, "--steps", 2, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = hfrac("plot", folder, "--kgd")
        self.assertEqual(done.returncode, 2)
        self.assertIn("bond.fracture_toughness", done.stderr)

    def test_the_table_is_that_of_the_solution(self):
        table = pathlib.Path(__file__).resolve().parents[2] / "viz" / "command" / "kgd_table.inc"
        made = self_similar.table().splitlines()
        for mine, its in zip(made, table.read_text().splitlines()):
            numbers = [[float(n) for n in text.replace("KGD_ROW(", "").replace("KGD_LIST(", "").replace(")", "").split(",")]
                       for text in (mine, its)] if mine.startswith("KGD_ROW") else []
            for one, other in zip(*numbers):
                self.assertAlmostEqual(one, other, delta=2e-3 * max(1.0, abs(other)))


JOINT = """
[[joint]]
x1 = 66.0
y1 = 35.0
x2 = 72.0
y2 = 65.0
state = "smooth-broken"
friction = 0.6
normal_stiffness = 1e11
shear_stiffness = 5e10
aperture = 2e-4
residual_aperture = 1e-4
"""


class MeetsAJoint(unittest.TestCase):
    """A fracture of facets runs into a natural fracture that conducts: fluid is kept, the joint slips."""

    def test_fluid_is_kept_and_the_joint_slips(self):
        top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, top)
        (top / "case.toml").write_text(CASE_TEXT.replace("steps = 40", "steps = 80") + JOINT)
        done = hfrac("run", top / "case.toml", "-o", top / "run", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(top / "run" / "history.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(file)]
        for row in rows:
            self.assertLessEqual(abs(row["fluid_error_m2"]), 1e-12 * max(1.0, row["injected_volume_m2"]))
        before, after = rows[0], rows[-1]
        self.assertEqual(before["tip_distance_m"], 0.0)
        self.assertGreater(after["tip_distance_m"], 17.0, "the joint is 17 m from the well")
        self.assertGreater(after["joint_largest_slip_m"], 1e-3)


if __name__ == "__main__":
    unittest.main()
