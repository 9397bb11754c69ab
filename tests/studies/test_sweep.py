#!/usr/bin/python3
"""hfrac sweep from end to end on a tiny case: its files, a kill in the middle, runs that fail."""
import csv
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import tempfile
import time
import tomllib
import types
import unittest

import support
from hfrac.study.pool import Result
from hfrac.study.progress import Progress


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Cost(unittest.TestCase):
    def test_what_a_run_takes_and_what_is_left(self):
        """Five of ten runs were there, this process did three in 60 s by the clock, two at a time, one of which failed."""
        done = [Result("done", "", 40.0)] * 5 + [Result("done", "", 30.0), Result("failed", "no rest", 20.0), Result("done", "", 30.0)]
        progress = Progress(10, True)
        progress.began = time.monotonic() - 60.0
        text = progress.text(types.SimpleNamespace(results=dict(enumerate(done)), fresh=3, jobs=2))
        self.assertEqual(text, "8 of 10 runs, 1 failed; 35 s a run, 40 s left with 2 at a time")


class Sweep(unittest.TestCase):
    def setUp(self):
        self.top = tempfile.TemporaryDirectory(prefix="hfrac-studies-")
        self.folder = pathlib.Path(self.top.name)

    def tearDown(self):
        self.top.cleanup()

    def sweep(self, study, out, *words):
        return support.hfrac("sweep", study, "-o", self.folder / out, "--jobs", 2, *words)

    def test_what_a_study_leaves(self):
        study = support.write_study(self.folder, 6, "saltelli", 'packings = [1, 2]\n|[[quantity]]\nname = "late_Pa"\n'
                                    'column = "well_pressure_Pa"\ntake = "at"\ntime = 0.3\n')
        study.write_text(study.read_text().replace("runs = 6", "runs = 8"))
        done = self.sweep(study, "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("largest_pressure_Pa", done.stdout)
        self.assertRegex(done.stderr, r"(?m)^16 runs took \d+ s of a processor$")
        out = self.folder / "out"
        table = rows(out / "table.csv")
        self.assertEqual(len(table), 16)
        names = list(table[0])
        numbers = [[int(row["run"]), *(float(row[name]) for name in names[1:4])] for row in table]
        self.assertIn(b"".join(struct.pack("<d", row[1]) for row in numbers), (out / "table.parquet").read_bytes())
        self.assertEqual([row["packing"] for row in table[:2]], ["1", "2"])
        self.assertTrue(all(row["status"] == "done" for row in table))
        for row in table:  # a well at a held pressure has it
            self.assertAlmostEqual(float(row["late_Pa"]) / float(row["pressure"]), 1.0, 6)
            self.assertTrue(40e6 <= float(row["bond.tensile_strength"]) <= 60e6)
        asked = tomllib.loads((out / "runs/00003/asked.toml").read_text())
        self.assertAlmostEqual(asked["well"][0]["pressure"], float(table[3]["pressure"]), 1)
        self.assertEqual(asked["model"]["seed"], 2)
        sensitivity = {(row["result"], row["parameter"]): row for row in rows(out / "sensitivity.csv")}
        total = float(sensitivity["late_Pa", "pressure"]["total_order"])
        self.assertLess(float(sensitivity["late_Pa", "bond.tensile_strength"]["total_order"]), 1e-9)
        self.assertGreater(total, 0.1)
        percentiles = {row["result"]: row for row in rows(out / "percentiles.csv")}
        late = percentiles["late_Pa"]
        self.assertTrue(10e6 <= float(late["P10"]) <= float(late["P50"]) <= float(late["P90"]) <= 30e6)
        self.assertEqual(late["runs"], "16")
        self.assertTrue(rows(out / "bands.csv"))
        for name in ("tornado.png", "sobol.png", "bands.png"):
            self.assertTrue((out / name).read_bytes().startswith(b"\x89PNG"), name)
        self.assertFalse(list(out.glob("runs/*/*.vtu")))
        self.assertFalse([path for path in out.rglob(".*.tmp")])
        text = (out / "table.csv").read_bytes()
        again = self.sweep(study, "out")
        self.assertIn("16 are there already", again.stderr)
        self.assertEqual((out / "table.csv").read_bytes(), text)

    def test_after_a_kill_the_table_is_the_same(self):
        study = support.write_study(self.folder, 12)
        self.assertEqual(self.sweep(study, "whole").returncode, 0)
        out = self.folder / "killed"
        process = subprocess.Popen([support.COMMAND, "sweep", study, "-o", out, "--jobs", "2", "-q"])
        until = time.monotonic() + 120.0
        while len(list(out.glob("runs/*/result.json"))) < 4 and time.monotonic() < until:
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        done = {path: path.stat().st_mtime_ns for path in out.glob("runs/*/result.json")}
        self.assertTrue(4 <= len(done) < 12, len(done))
        self.assertFalse((out / "table.csv").exists())
        resumed = self.sweep(study, "killed")
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        for path, moment in done.items():
            self.assertEqual(path.stat().st_mtime_ns, moment, f"{path} was done again")
        for name in ("table.csv", "percentiles.csv", "sensitivity.csv", "bands.csv"):
            self.assertEqual((out / name).read_bytes(), (self.folder / "whole" / name).read_bytes(), name)

    def test_an_interrupted_study_says_how_to_go_on(self):
        study = support.write_study(self.folder, 12)
        out = self.folder / "out"
        process = subprocess.Popen([support.COMMAND, "sweep", study, "-o", out, "--jobs", "2"], stderr=subprocess.PIPE, text=True)
        until = time.monotonic() + 120.0
        while not list(out.glob("runs/*/result.json")) and time.monotonic() < until:
            time.sleep(0.01)
        process.terminate()
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("the same command goes on", errors)
        self.assertFalse([path for path in out.glob("runs/*/result.json") if "failed" in path.read_text()])

    def test_failed_runs_are_told_and_can_be_rerun(self):
        study = support.write_study(self.folder, 4, "one-at-a-time")
        # A hole that leaves no rock, which hfrac run refuses, and a viscosity below 0, which is refused before.
        study.write_text(study.read_text() + '[[parameter]]\nname = "radius"\noption = "well.radius"\nlaw = "list"\nvalues = [9.0, 9.0, 60.0]\n'
                         '[[parameter]]\noption = "fluid.viscosity"\nlaw = "normal"\nmean = 1e-3\ndeviation = 1e-3\n')
        done = self.sweep(study, "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "(?m)^run 7 failed: .*fluid.viscosity")  # refused before anything ran
        self.assertEqual(len(re.findall("(?m)^run [0-9]+ failed", done.stderr)), 1)
        self.assertRegex(done.stderr, "1 of 9 runs failed, as run 6 .*well.*60")
        self.assertRegex(done.stderr, "1 of 9 runs failed, as run 7 .*fluid.viscosity")
        self.assertIn("--retry", done.stderr)
        table = rows(self.folder / "out/table.csv")
        self.assertEqual([row["run"] for row in table if row["status"] == "failed"], ["6", "7"])
        self.assertTrue("radius" in table[6]["sentence"] and table[6]["length_m"] == "")
        self.assertIn("fluid.viscosity", table[7]["sentence"])
        self.assertEqual(rows(self.folder / "out/percentiles.csv")[0]["runs"], "7")
        moments = [(self.folder / f"out/runs/0000{index}/result.json").stat().st_mtime_ns for index in (5, 6)]
        self.assertEqual(self.sweep(study, "out", "--retry").returncode, 0)
        again = [(self.folder / f"out/runs/0000{index}/result.json").stat().st_mtime_ns for index in (5, 6)]
        self.assertEqual(again[0], moments[0])
        self.assertNotEqual(again[1], moments[1])

    def test_a_run_that_a_signal_kills_is_tried_twice(self):
        study = support.write_study(self.folder, 2)
        stand_in = self.folder / "hfrac"
        stand_in.write_text("#!/bin/sh\nmkdir -p tries\necho x >> tries/n\nkill -9 $$\n")
        stand_in.chmod(0o755)
        done = subprocess.run(["/usr/bin/python3", "-B", "-m", "hfrac.study", "sweep", study, "-o", "out", "--jobs", "1"], cwd=self.folder,
                              env={**os.environ, "HFRAC_COMMAND": str(stand_in)}, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("ended twice by signal 9 (SIGKILL)", done.stderr)
        self.assertEqual((self.folder / "tries/n").read_text().count("x"), 4)
        self.assertEqual(json.loads((self.folder / "out/runs/00000/result.json").read_text())["status"], "failed")


if __name__ == "__main__":
    unittest.main()
