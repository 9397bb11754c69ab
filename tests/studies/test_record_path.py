#!/usr/bin/python3
"""From a record to percentiles by the commands of docs/studies.md, and no others: the first day of Basel's record and four runs, or, with
HFRAC_WHOLE_RECORD=1 (labelled long), all of it and the study as `hfrac new` writes it, which is to take no more than 20 minutes of two processors."""
import csv
import os
import pathlib
import resource
import tempfile
import unittest

import support

WHOLE = "HFRAC_WHOLE_RECORD" in os.environ
END = 516000.0 if WHOLE else 64800.0  # s, a row of the record


class RecordPath(unittest.TestCase):
    def done(self, *words, limit=500):
        done = support.hfrac(*words, limit=limit)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_from_a_record_to_percentiles(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            case, record, study = folder / "record.toml", folder / "record.csv", folder / "record-study.toml"
            lines = [line for line in (support.ROOT / "examples/field/basel-record.csv").read_text().splitlines() if not line.startswith("#")]
            record.write_text("\n".join([lines[0], *(line for line in lines[1:] if float(line.split(",")[0]) <= END)]) + "\n")
            self.done("analyse", record, "--thickness", 371, "--shut-in", 495480 if WHOLE else 61860, "-q")
            self.done("new", "record", "-o", case)
            self.done("new", "record-study", "-o", study)
            # As its comment says: the rate's line out, the record's two in.
            lines = [line.removeprefix("# ") if "schedule_" in line else line for line in case.read_text().splitlines() if not line.startswith("rate = ")]
            case.write_text("\n".join(lines).replace("end_time = 516000.0", "end_time = 30000.0") + "\n")
            text = self.done("check", case)
            self.assertIn("radius 18 m, fluid in 1.75 m2, a schedule of ", text)
            self.assertIn(f"until 30000 s of model time, before the schedule's last entry at {495480 if WHOLE else 64800} s", text)
            case.write_text(case.read_text().replace("end_time = 30000.0", f"end_time = {END}"))
            self.assertNotIn("before the schedule's last entry", self.done("check", case))
            runs = 32 if WHOLE else 4
            study.write_text(study.read_text().replace("runs = 32", f"runs = {runs}"))
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            print(self.done("sweep", study, "-o", folder / "out", "--jobs", os.environ.get("HFRAC_JOBS", "1"), limit=20000))
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            print(f"{runs} runs took {used / 60:.1f} minutes of a processor")
            with open(folder / "out/percentiles.csv", newline="") as file:
                rows = {row["result"]: {name: float(value or "nan") for name, value in row.items() if name != "result"} for row in csv.DictReader(file)}
            for name in ("largest_pressure_Pa", "injectivity_m2_per_Pa_s", "joint_slipped_length_m"):
                self.assertEqual(rows[name]["runs"], runs, name)
            for name in ("tornado", "bands"):
                self.assertTrue((folder / f"out/{name}.png").exists(), name)
            pressure = rows["largest_pressure_Pa"]
            self.assertLess(46e6, pressure["P10"])
            self.assertLess(pressure["P10"], pressure["P90"])
            self.assertGreater(rows["injectivity_m2_per_Pa_s"]["P10"], 0.0)
            if WHOLE:
                self.assertGreater(rows["joint_slipped_length_m"]["P50"], 0.0)
                self.assertLess(used, 2 * 20 * 60.0)
            else:
                self.assertLess(pressure["P90"], 75e6)


if __name__ == "__main__":
    unittest.main()
