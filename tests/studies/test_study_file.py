#!/usr/bin/python3
"""A wrong study file is refused in a sentence with the key and what would be right, and nothing is run or written."""
import pathlib
import tempfile
import unittest

import support
from hfrac.study.command import carry_out
from hfrac.study.study_file import StudyError

PARAMETER = '[[parameter]]\noption = "well.pressure"\nlaw = "uniform"\nlow = 1e6\nhigh = 2e6\n'
CASES = (
    ("", "case is missing"),
    ('case = "none.toml"\n' + PARAMETER, "case: there is no file"),
    ('case = "case.toml"\n', r"\[\[parameter\]\] is missing"),
    ('case = "case.toml"\nsampels = 3\n' + PARAMETER, "sampels is not known; "),
    ('case = "case.toml"\nsamplin = "sobol"\n' + PARAMETER, "samplin is not known; did you mean sampling"),
    ('case = "case.toml"\nsampling = "sobl"\n' + PARAMETER, "sampling = 'sobl' must be one of sobol"),
    ('case = "case.toml"\nruns = 0\n' + PARAMETER, "runs = 0 must be a whole number from 1"),
    ('case = "case.toml"\nruns = "many"\n' + PARAMETER, "runs = 'many' must be a whole number"),
    ('case = "case.toml"\nruns = true\n' + PARAMETER, "runs = True must be"),
    ('case = "case.toml"\npackings = [1, 1]\n' + PARAMETER, "packings = .* must be different"),
    ('case = "case.toml"\n' + PARAMETER.replace("uniform", "triangle"), r"parameter\[0\].law = 'triangle' must be one of"),
    ('case = "case.toml"\n' + PARAMETER.replace("high = 2e6", "high = 0.5e6"), r"parameter\[0\].high = .* must be above low"),
    ('case = "case.toml"\n' + PARAMETER.replace("high = 2e6", ""), r"parameter\[0\].high is missing"),
    ('case = "case.toml"\n' + PARAMETER.replace("low = 1e6", "low = nan"), r"parameter\[0\].low = nan must be a number"),
    ('case = "case.toml"\n' + PARAMETER.replace("low = 1e6", "low = 0.0").replace("uniform", "loguniform"), r"parameter\[0\].low = 0.0 must be above 0"),
    ('case = "case.toml"\n' + PARAMETER.replace("well.pressure", "well.presure"), r"parameter\[0\].option 'well.presure': .*well"),
    ('case = "case.toml"\n' + PARAMETER.replace("well.pressure", "joint.friction"), r"joint.friction: the case has no \[\[joint\]\]"),
    ('case = "case.toml"\n' + PARAMETER.replace("well.pressure", "bond.tensile_strenght"), "tensile_strength"),
    ('case = "case.toml"\n[set]\nbond.nothing = 3\n' + PARAMETER, "set.bond.nothing: "),
    ('case = "case.toml"\n[set]\nstepping.steps = -4\n' + PARAMETER, "set.stepping.steps: .*-4"),
    ('case = "case.toml"\n' + PARAMETER + PARAMETER, "parameter.name 'well.pressure' is there twice"),
    ('case = "case.toml"\n' + PARAMETER + '[[quantity]]\nname = "p"\ncolumn = "well_pressure_Pa"\ntake = "at"\n', r"quantity\[0\].time is missing"),
    ('case = "case.toml"\nruns = 3\nsampling = "saltelli"\n' + PARAMETER, "runs = 3 must be at least 6"),
    ('case = "case.toml\n' + PARAMETER, "is not TOML"),
)
MATCHES = (
    ("", r"\[match\] is missing"),
    ("[match]\nmembers = 3\n", "match.members = 3 must be a whole number from 10"),
    ("[match]\nmembers = 20\n", r"\[\[match.data\]\] is missing"),
    ('[match]\n[[match.data]]\nrecord = "none.csv"\nerror = 1.0\n', r"match.data\[0\].record = .*none.csv' cannot be read"),
    ('[match]\n[[match.data]]\nrecord = "r.csv"\n', r"match.data\[0\].error is missing"),
    ('[match]\n[[match.data]]\nrecord = "r.csv"\nerror = 1.0\ncolumn = "tip_distance_m"\n', "no columns time_s and tip_distance_m"),
    ('[match]\n[[match.data]]\nrecord = "r.csv"\nerror = 1.0\nfrom = 90.0\n', r"has 0 rows from 90 s"),
)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.top = tempfile.TemporaryDirectory(prefix="hfrac-studies-")
        self.folder = pathlib.Path(self.top.name)
        (self.folder / "case.toml").write_text(support.CASE)
        (self.folder / "r.csv").write_text("time_s,well_pressure_Pa\n0,1e6\n1,2e6\n")

    def tearDown(self):
        self.top.cleanup()

    def refused(self, command, text, pattern):
        """In this process: to start Python and scipy thirty times takes half a minute."""
        study = self.folder / "study.toml"
        study.write_text(text)
        with self.assertRaisesRegex(StudyError, pattern):
            carry_out([command, str(study), "-o", str(self.folder / "out"), "-q"])
        self.assertFalse((self.folder / "out/runs").exists())

    def test_the_command_says_it(self):
        (self.folder / "study.toml").write_text(CASES[3][0])
        done = support.hfrac("sweep", self.folder / "study.toml", "-o", self.folder / "out")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, r"^hfrac: .*study.toml: sampels is not known; .* \(docs/studies.md#the-study-file\)\n$")
        (self.folder / "study.toml").write_text('case = "case.toml"\n' + PARAMETER)
        done = support.hfrac("match", self.folder / "study.toml", "-o", self.folder / "out")
        self.assertRegex(done.stderr, r"\[match\] is missing; .* \(docs/studies.md#matching-a-record\)\n$")
        self.assertFalse((self.folder / "out").exists())

    def test_bad_studies(self):
        for text, pattern in CASES:
            with self.subTest(pattern):
                self.refused("sweep", text, pattern)

    def test_bad_matches(self):
        for text, pattern in MATCHES:
            with self.subTest(pattern):
                self.refused("match", 'case = "case.toml"\n' + PARAMETER + text, pattern)
        self.refused("match", 'case = "case.toml"\n[[parameter]]\noption = "model.seed"\nlaw = "list"\nvalues = [1, 2]\n'
                     '[match]\n[[match.data]]\nrecord = "r.csv"\nerror = 1.0\n', r"law = 'list' cannot be matched")
        for packings, members in (([1, 2, 3], 20), ([1, 2, 3, 4, 5, 6], 11)):
            self.refused("match", f'case = "case.toml"\npackings = {packings}\n' + PARAMETER + f'[match]\nmembers = {members}\n[[match.data]]\n'
                         'record = "r.csv"\nerror = 1.0\n', rf"packings = \[1, 2, 3.* must be one, or at least 4 .* half of match.members = {members}")

    def test_no_study(self):
        done = support.hfrac("sweep", self.folder / "none.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot be read", done.stderr)
        self.assertEqual(support.hfrac("sweep").returncode, 2)

    def test_no_python_and_no_scipy_are_said(self):
        import os
        missing = support.hfrac("sweep", "s.toml", env={**os.environ, "HFRAC_PYTHON": "/nowhere/python3"})
        self.assertEqual(missing.returncode, 1)
        self.assertRegex(missing.stderr, "^hfrac: hfrac sweep needs Python, and '/nowhere/python3' cannot be started: .*apt-get install")
        (self.folder / "scipy.py").write_text("raise ImportError('not here')\n")
        bare = support.hfrac("match", "s.toml", env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual(bare.returncode, 1, bare.stderr)
        self.assertRegex(bare.stderr, "^hfrac: studies need numpy and scipy .*apt-get install python3-scipy")


if __name__ == "__main__":
    unittest.main()
