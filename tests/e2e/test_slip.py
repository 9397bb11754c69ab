"""A run with a smooth joint: its slips are logged, are events, survive a resumed run, and go with the run."""
import csv
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import hfrac, names, run_case, summary

CASE_TEXT = """[packing]
disc_count = 600
[contact]
mode = "after-break"
[bond]
tensile_strength = 1e12
shear_strength = 1e12
[stress]
sigma_Hmax = 35e6
sigma_hmin = 25e6
[fluid]
formation_pressure = 10e6
viscosity = 1.0
[flow]
permeability = 1e-18
aperture_limit = 0.1
[solver]
kind = "quasi-static"
[stepping]
mode = "coupled"
flow_step = 1.0
steps = 6
[output]
every = 2
[[well]]
radius = 8.0
pressure = 20e6
[[joint]]
x1 = 20.0
y1 = 35.0
x2 = 80.0
y2 = 65.0
state = "smooth-broken"
friction = 0.4
normal_stiffness = 1e10
shear_stiffness = 5e9
aperture = 5e-3
"""


def rows(file):
    with open(file, newline="") as table:
        return list(csv.DictReader(table))


class Slip(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        cls.case, cls.folder = cls.top / "joint.toml", cls.top / "run"
        cls.case.write_text(CASE_TEXT)
        done = hfrac("run", cls.case, "-o", cls.folder)
        assert done.returncode == 0, done.stderr

    def test_events_hold_the_moment_of_the_slips(self):
        slips = [row for row in rows(self.folder / "slips.csv") if int(row["step"]) > 0]
        events = [row for row in rows(self.folder / "events.csv") if row["kind"] == "slip"]
        self.assertGreater(len(slips), 10)
        self.assertEqual(sum(int(event["slip_count"]) for event in events), len(slips))
        # All of one straight joint: what goes one way has a moment of the same sign, whichever disc is the first.
        moment = sum(float(row["shear_modulus_Pa"]) * float(row["length_m"]) * float(row["slip_m"]) for row in slips)
        tensor = [sum(float(event[f"moment_{part}_N_m"]) for event in events) for part in ("xx", "yy", "xy")]
        self.assertAlmostEqual((0.5 * (tensor[0]**2 + tensor[1]**2) + tensor[2]**2)**0.5 / abs(moment), 1.0, delta=1e-9)
        times = [float(event["time_s"]) for event in rows(self.folder / "events.csv")]
        self.assertEqual(times, sorted(times))

    def test_the_catalogue_is_made_anew(self):
        copy = self.top / "copy"
        shutil.copytree(self.folder, copy)
        done = hfrac("catalogue", copy)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("slow slip included", done.stdout)
        self.assertEqual((copy / "events.csv").read_bytes(), (self.folder / "events.csv").read_bytes())
        self.assertEqual(hfrac("catalogue", copy, "--slip-rate", 1e6).returncode, 0)
        self.assertFalse([row for row in rows(copy / "events.csv") if row["kind"] == "slip"])
        (copy / "slips.csv").write_text((copy / "slips.csv").read_text().replace("\n1,", "\n?,", 1))
        self.assertEqual(hfrac("catalogue", copy).returncode, 2)

    def test_a_resumed_run_has_the_same(self):
        half = self.top / "half"
        self.assertEqual(hfrac("run", self.case, "-o", half, "--steps", 3, "--checkpoint-steps", 1).returncode, 0)
        done = hfrac("resume", half, "--steps", 6)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(summary(half)["state_hash"], summary(self.folder)["state_hash"])
        self.assertEqual((half / "slips.csv").read_bytes(), (self.folder / "slips.csv").read_bytes())

    def test_a_run_without_joints_has_no_slips(self):
        over = self.top / "over"
        shutil.copytree(self.folder, over)
        self.assertEqual(run_case(over, "--overwrite", "--steps", 1).returncode, 0)
        self.assertNotIn("slips.csv", names(over))


unittest.main()
