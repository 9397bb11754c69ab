#!/usr/bin/python3
"""From a record to percentiles by the commands of docs/studies.md, and no others: the first day of Basel's record, three runs."""
import csv
import pathlib
import tempfile
import unittest

import support

END = 64800.0  # s, a row of the record


class RecordPath(unittest.TestCase):
    def done(self, *words):
        done = support.hfrac(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_from_a_record_to_percentiles(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            case, record = folder / "case.toml", folder / "record.csv"
            lines = [line for line in (support.ROOT / "examples/field/basel-record.csv").read_text().splitlines() if not line.startswith("#")]
            record.write_text("\n".join([lines[0], *(line for line in lines[1:] if float(line.split(",")[0]) <= END)]) + "\n")
            self.done("analyse", record, "--thickness", 371, "--shut-in", 61860, "-q")
            self.done("new", "record", "-o", case)
            # As its comment says: the rate's line out, the record's two in.
            lines = [line.removeprefix("# ") if "schedule_" in line else line for line in case.read_text().splitlines() if not line.startswith("rate = ")]
            case.write_text("\n".join(lines).replace("end_time = 516000.0", "end_time = 30000.0") + "\n")
            text = self.done("check", case)
            self.assertIn("radius 18 m, a schedule of 7 entries, the last at 64800 s", text)
            self.assertIn("until 30000 s of model time, before the schedule's last entry at 64800 s", text)
            case.write_text(case.read_text().replace("end_time = 30000.0", f"end_time = {END}"))
            self.assertNotIn("before the schedule's last entry", self.done("check", case))
            study = (support.ROOT / "examples/field/record-study.toml").read_text()
            self.assertIn('case = "record.toml"\nruns = 60', study)
            (folder / "study.toml").write_text(study.replace('case = "record.toml"\nruns = 60', 'case = "case.toml"\nruns = 3'))
            self.done("sweep", folder / "study.toml", "-o", folder / "out", "--jobs", 1)
            with open(folder / "out/percentiles.csv", newline="") as file:
                rows = {row["result"]: row for row in csv.DictReader(file)}
            for name in ("largest_pressure_Pa", "injectivity_m2_per_Pa_s", "joint_slipped_length_m"):
                self.assertEqual(rows[name]["runs"], "3", name)
            self.assertEqual(float(rows["event_count"]["P90"]), 0.0)  # nothing slips yet, and a zone that was broken from the start is no event
            self.assertTrue(46e6 < float(rows["largest_pressure_Pa"]["P10"]) <= float(rows["largest_pressure_Pa"]["P90"]) < 75e6)
            self.assertGreater(float(rows["injectivity_m2_per_Pa_s"]["P10"]), 0.0)


if __name__ == "__main__":
    unittest.main()
