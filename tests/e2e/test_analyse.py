"""hfrac analyse on a field's record and on a run folder: what the record was made with comes back, and what it does not hold is said."""
import json
import math
import os
import pathlib
import random
import shutil
import tempfile
import unittest

from hfrac_runs import hfrac, history

SHUT_IN, CLOSURE = 1200.0, 1.2  # s, G


def nolte(since):
    """G of little leak-off (Nolte 1979)."""
    return 16 / (3 * math.pi) * ((1 + since) ** 1.5 - since**1.5 - 1)


def record(length=12000, noise=5e3, seed=1):
    """Rows (time [s], rate [L/s], pressure [MPa]): a peak of 38 MPa, 33 MPa while pumped, ISIP 32 MPa, closure at 29.6 MPa."""
    random.seed(seed)
    rows = []
    for time in range(0, length, 2):
        if time < SHUT_IN:
            pressure = 20e6 + 18e6 * time / 120 if time <= 120 else 33e6 + 5e6 * math.exp(-(time - 120) / 60)
        else:
            g = nolte((time - SHUT_IN) / SHUT_IN)
            pressure = 32e6 - 2e6 * (min(g, CLOSURE) + 0.4 * max(0.0, g - CLOSURE))
        rows.append((time, 12.0 if time < SHUT_IN else 0.0, (pressure + random.gauss(0, noise)) * 1e-6))
    return rows


class Analyse(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.file, self.json = self.top / "record.csv", self.top / "analysis.json"

    def write(self, rows, head="time_s,rate_L_s,pressure_MPa"):
        self.file.write_text(head + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows))

    def analysed(self, *arguments, source=None):
        done = hfrac("analyse", source or self.file, "-o", self.json, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, json.loads(self.json.read_text())

    def test_what_a_record_was_made_with_comes_back(self):
        for seed in (1, 2, 3):
            self.write(record(seed=seed))
            text, found = self.analysed("--thickness", 50)
            print(f"seed {seed}: ISIP {found['isip_Pa']:.4g} Pa, closure {found['closure_by_g']}")
            self.assertEqual(found["shut_in_s"], SHUT_IN)
            self.assertAlmostEqual(found["injected_volume_m2"], 12e-3 / 50 * SHUT_IN, delta=1e-9)
            self.assertAlmostEqual(found["breakdown_pressure_Pa"], 38e6, delta=0.03e6)
            self.assertAlmostEqual(found["propagation_pressure_Pa"], 33e6, delta=0.01e6)
            self.assertAlmostEqual(found["isip_Pa"], 32e6, delta=0.03 * 2.4e6)
            closure = found["closure_by_g"]
            self.assertAlmostEqual(closure["g"], CLOSURE, delta=0.03 * CLOSURE)
            self.assertAlmostEqual(nolte(closure["since_shut_in_s"] / SHUT_IN), CLOSURE, delta=0.03 * CLOSURE)
            self.assertAlmostEqual(closure["pressure_Pa"], 29.6e6, delta=0.03 * 2.4e6)
            self.assertIsNone(found["closure_by_stiffness"])
            self.assertAlmostEqual(found["closure_by_root_of_time"]["pressure_Pa"], 29.6e6, delta=0.03 * 2.4e6)
            self.assertIsNone(found["step_rate"])
            self.assertEqual(found["notes"], [])
            for word in ("breakdown", "ISIP", "closure, G", "closure, root", "Gronseth and Kry 1983", "Nolte 1979"):
                self.assertIn(word, text)

    def test_what_a_short_record_does_not_hold_is_said(self):
        self.write(record(length=1900))
        text, found = self.analysed()
        self.assertIsNone(found["closure_by_g"])
        self.assertIsNone(found["closure_by_root_of_time"])
        self.assertIn("no closure by the G function", text)
        self.write([row for row in record() if row[0] < SHUT_IN + 20])
        text, found = self.analysed()
        self.assertIn("the fall-off has 10 rows; 20 are needed", text)
        self.assertIsNone(found["isip_Pa"])

    def test_without_a_rate_the_shut_in_is_told(self):
        self.write([(time, pressure) for time, _, pressure in record()], "time_s,pressure_MPa")
        done = hfrac("analyse", self.file)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--shut-in SECONDS", done.stderr)
        _, found = self.analysed("--shut-in", SHUT_IN)
        self.assertAlmostEqual(found["closure_by_g"]["g"], CLOSURE, delta=0.03 * CLOSURE)
        self.assertIsNone(found["injected_volume_m2"])

    def test_the_time_of_growth_may_be_told(self):
        self.write(record())
        _, found = self.analysed("--injection-time", SHUT_IN / 2)
        self.assertEqual(found["injection_time_s"], SHUT_IN / 2)
        self.assertAlmostEqual(found["isip_Pa"], 32e6, delta=0.03 * 2.4e6)

    def test_a_step_rate_test(self):
        rows = []
        for time in range(0, 4800):
            rate = [1, 2, 3, 4, 6, 8, 10, 0][time // 600]
            end = 20 + 2 * min(rate, 4.5) + 0.5 * max(0, rate - 4.5)
            rows.append((time, float(rate), end - 0.1 * math.exp(-(time % 600) / 60)))
        self.write(rows)
        text, found = self.analysed()
        self.assertEqual(len(found["step_rate"]["steps"]), 7)
        self.assertAlmostEqual(found["step_rate"]["extension_pressure_Pa"], 29e6, delta=0.03 * 9e6)
        self.assertIn("Earlougher 1977", text)

    def test_a_run_folder(self):
        case = self.top / "case.toml"
        case.write_text("[packing]\ndisc_count = 500\n[stress]\nsigma_Hmax = 30e6\nsigma_hmin = 30e6\n"
                        "[fluid]\nformation_pressure = 10e6\n[stepping]\nmode = \"coupled\"\nflow_step = 1.0\nend_time = 90.0\n"
                        "[solver]\nkind = \"quasi-static\"\n"
                        "[[well]]\nradius = 10.0\ncontrol = \"rate\"\nschedule_file = \"pump.csv\"\nschedule_thickness = 20\n")
        (self.top / "pump.csv").write_text("time_min,rate_L_s\n0,2\n0.25,2\n0.5,0\n")
        checked = hfrac("check", case)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn("the 3 rows of", checked.stdout)
        self.assertIn("gave 2 entries", checked.stdout)
        done = hfrac("run", case, "-o", self.top / "run")
        self.assertEqual(done.returncode, 0, done.stderr)
        _, found = self.analysed(source=self.top / "run")
        rows = history(self.top / "run")
        self.assertEqual((found["injection_begin_s"], found["shut_in_s"]), (0.0, 30.0))
        self.assertAlmostEqual(found["injected_volume_m2"], 2e-3 / 20 * 30, delta=1e-12)
        self.assertEqual(found["fall_off_s"], float(rows[-1]["time_s"]) - 30.0)
        late = [float(row["well_pressure_Pa"]) for row in rows if 15 <= float(row["time_s"]) < 30]
        self.assertTrue(min(late) <= found["propagation_pressure_Pa"] <= max(late) * 1.01)
        first_after = next(float(row["well_pressure_Pa"]) for row in rows if float(row["time_s"]) == 31.0)
        self.assertGreater(found["isip_Pa"], first_after)

    @unittest.skipUnless(os.environ.get("HFRAC_RENDERS"), "built without the renderer")
    def test_pictures(self):
        self.write(record())
        for ending in ("png", "svg"):
            text, _ = self.analysed("--picture", self.top / f"fall.{ending}")
            for part in ("record", "g", "root"):
                file = self.top / f"fall-{part}.{ending}"
                self.assertGreater(file.stat().st_size, 5000)
                self.assertIn(str(file), text)
        done = hfrac("analyse", self.file, "--picture", self.top / "fall.gif")
        self.assertEqual(done.returncode, 2)
        self.assertIn("pictures are .png, .svg or .pdf", done.stderr)

    @unittest.skipUnless(os.environ.get("HFRAC_RENDERS"), "built without the renderer")
    def test_a_record_beside_a_run(self):
        """The run's own history, half a MPa higher, as a record: that is how far apart they are told to be."""
        case = self.top / "case.toml"
        case.write_text("[packing]\ndisc_count = 500\n[stress]\nsigma_Hmax = 30e6\nsigma_hmin = 30e6\n[fluid]\nformation_pressure = 10e6\n"
                        "[stepping]\nmode = \"coupled\"\nflow_step = 1.0\nend_time = 20.0\n[solver]\nkind = \"quasi-static\"\n"
                        "[[well]]\nradius = 10.0\nrate = 1e-4\n")
        run = self.top / "run"
        done = hfrac("run", case, "-o", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = history(run)
        self.write([(float(row["time_s"]), 1e-6 * float(row["well_pressure_Pa"]) + 0.5) for row in rows], "time_s,pressure_MPa")
        done = hfrac("plot", run, "--record", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"computed less measured: -0.5 MPa in the mean, 0.5 MPa rms, over {len(rows)} rows", done.stdout)
        done = hfrac("plot", run, "--record", self.file, "--record-offset", -5e5)
        self.assertRegex(done.stdout, r"computed less measured: (0|-?\d.*e-\d+) MPa in the mean")
        for ending in ("png", "svg", "csv"):
            self.assertGreater((run / f"pictures/record.{ending}").stat().st_size, 500)
        done = hfrac("report", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("beside the computed one", (run / "report.html").read_text())
        self.write([(1e6, 20.0), (2e6, 20.0)], "time_s,pressure_MPa")
        done = hfrac("plot", run, "--record", self.file)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no row between 0 and 20 s", done.stderr)

    def test_a_las_file(self):
        self.write(record())
        self.assertIn("1 m is taken", hfrac("analyse", self.file).stdout)
        self.assertNotIn("1 m is taken", hfrac("analyse", self.file, "--thickness", 50).stdout)
        _, of_table = self.analysed("--thickness", 50)
        las = self.top / "record.las"
        las.write_text("~V\nVERS. 2.0 :\nWRAP. NO :\n~W\nNULL. -999.25 :\n~C\nTIME.S :\nRATE.L/S :\nPRES.MPA :\n~A\n"
                       + "".join(" ".join(map(repr, row)) + "\n" for row in record()))
        _, of_las = self.analysed("--thickness", 50, source=las)
        self.assertEqual({**of_las, "source": 0}, {**of_table, "source": 0})

    def test_bad_input_is_refused_in_a_sentence(self):
        head = "time_s,rate_L_s,pressure_MPa\n"
        table = (
            ("", (), "record.csv:1: the record is empty"),
            (head + "0,1,nan\n", (), "record.csv:2: pressure_MPa = nan is not a number"),
            (head + "0,1,20\n5,1,21\n4,0,22\n", (), "record.csv:4: time_s = 4 is not after 5"),
            (head + "0,1,20\n5,,21\n", (), "record.csv:3: the row has no rate_L_s"),
            ("time_s,rate_L_s\n0,1\n5,0\n", (), "no column of pressure"),
            ("time_s,pressure_psig\n0,1\n5,0\n", (), "record.csv:1: the name pressure_psig ends with no known unit"),
            ("a,b\n0,1\n", (), "record.csv:1: no column of time"),
            (head + "0,1,20\n", (), "has 1 rows; an injection has two at least"),
            (head + "0,1,20\n5,1,21\n", (), "the record has no shut-in"),
            (head + "0,1,20\n5,0,21\n9,0,20\n", ("--shut-in", 50), "--shut-in 50 s is not inside the record, 0 to 9 s"),
            (head + "0,1,20\n5,0,21\n9,0,20\n", ("--thickness", 0), "--thickness"),
            (head + "0,1,20\n5,0,21\n9,0,20\n", ("--leak-off", "some"), "--leak-off"),
        )
        for text, arguments, words in table:
            self.file.write_text(text)
            done = hfrac("analyse", self.file, *arguments)
            self.assertEqual(done.returncode, 2, (text, done.stdout, done.stderr))
            self.assertIn(words, done.stderr)
            if words.startswith("record.csv:"):
                self.assertIn("docs/records.md#the-table", done.stderr)
        self.assertIn("none.csv: cannot be opened", hfrac("analyse", self.top / "none.csv").stderr)
        done = hfrac("analyse", self.top)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not a run folder: it has no history.csv", done.stderr)


if __name__ == "__main__":
    unittest.main()
