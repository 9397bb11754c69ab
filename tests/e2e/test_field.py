"""The field cases, small: examples/field/judge runs each, reads every figure of it, and says hit or miss; its page and its table agree."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from hfrac_runs import COMMAND, history

ROOT = pathlib.Path(__file__).resolve().parents[2]


def judge(*arguments):
    environment = dict(os.environ, HFRAC_COMMAND=COMMAND)
    return subprocess.run([sys.executable, ROOT / "examples/field/judge", *map(str, arguments)], capture_output=True, text=True, timeout=600, env=environment)


def recorded(end):
    """m3 of examples/field/basel-record.csv up to one of its rows."""
    lines = [line for line in (ROOT / "examples/field/basel-record.csv").read_text().splitlines() if not line.startswith("#")]
    rows = [(float(row["time_s"]), float(row["rate_L_s"])) for row in csv.DictReader(lines)]
    return sum(1e-3 * rate * (later - time) for (time, rate), (later, _) in zip(rows, rows[1:]) if later <= end)


class Field(unittest.TestCase):
    def test_small_versions_run_and_are_judged(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
            done = judge("--run", "--small", "--seeds", "1", "-o", top)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("| hits of 13 | | | ", done.stdout)
            self.assertIn("| hits of 6 | | | ", done.stdout)
            largest = next(line for line in done.stdout.splitlines() if line.startswith("| largest pressure, MPa"))
            self.assertAlmostEqual(float(largest.split("|")[4].strip(" *")), 29.4, delta=0.15 * 29.4)
            pressure = next(line for line in done.stdout.splitlines() if line.startswith("| pressure at 7.8 L/s"))
            self.assertEqual(pressure.split("|")[4].strip(), "*-*")  # ended before: a miss
            # What the record says flowed until 64 800 s, its own rows added up.
            last = [row for row in history(pathlib.Path(top, "basel-1")) if float(row["time_s"]) <= 64801.0][-1]
            self.assertAlmostEqual(371.0 * float(last["injected_volume_m2"]), recorded(64800.0), delta=0.005 * recorded(64800.0))

    def test_page_is_the_table(self):
        done = judge("--check")
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
