"""A whole run: every file is there, complete, consistent with the others and the same each time."""
import csv
import math
import os
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import CASE, SERIES, check_whole, entries, hfrac, history, names, run_case, summary

STEPS = 12
CASE_TEXT = pathlib.Path(CASE).read_text()
HISTORY = """step time_s well_pressure_Pa well_rate_m2_per_s injected_volume_m2 crack_count tensile_cracks shear_cracks
tip_distance_m fracture_length_m fracture_width_m fracture_volume_m2 force_ratio cycles at_rest energy_error_J_per_m
stored_volume_m2 leaked_volume_m2 fluid_error_m2""".split()


class WholeRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        cls.folder = cls.top / "new" / "run"
        cls.done = run_case(cls.folder, "--workers", 1)
        assert cls.done.returncode == 0, cls.done.stderr

    def test_prints_a_table_of_what_came_out(self):
        for word in ("longest fracture", "cracks", "well 0", "fluid", "energy", "state hash", "discs.pvd"):
            self.assertIn(word, self.done.stdout)

    def test_every_file_is_there_and_readable(self):
        expected = {"case.toml", "history.csv", "cracks.csv", "fractures.csv", "fracture_lines.csv", "events.csv", "summary.json", "state.hfrac"}
        expected |= {f"{series}.pvd" for series in SERIES}
        expected |= {file for series in SERIES for _, file in entries(self.folder, series)}
        self.assertEqual(set(names(self.folder)), expected)
        check_whole(self, self.folder)

    def test_series_begin_at_zero_and_end_with_the_run(self):
        last = float(history(self.folder)[-1]["time_s"])
        for series in SERIES:
            times = [time for time, _ in entries(self.folder, series)]
            self.assertEqual(times[0], 0.0)
            self.assertEqual(times, sorted(set(times)))
            self.assertEqual(times[-1], last)

    def test_history_has_a_line_per_step(self):
        rows = history(self.folder)
        for column in HISTORY:
            self.assertIn(column, rows[0])
        self.assertEqual([int(row["step"]) for row in rows], list(range(len(rows))))
        for row in rows:
            self.assertTrue(all(math.isfinite(float(value)) for value in row.values()), row)
            self.assertEqual(int(row["tensile_cracks"]) + int(row["shear_cracks"]), int(row["crack_count"]))

    def test_smooth_joints_have_a_series_and_columns_of_their_own(self):
        self.assertNotIn("joint_largest_slip_m", history(self.folder)[0])
        self.assertNotIn("joints", summary(self.folder))
        case, folder, out = (self.top / name for name in ("jointed.toml", "jointed", "jointed-tables"))
        case.write_text(CASE_TEXT + "[[joint]]\nx1 = 15\ny1 = 65\nx2 = 85\ny2 = 80\nstate = 'smooth-broken'\nfriction = 0.1\n")
        self.assertEqual(hfrac("run", case, "-o", folder, "--steps", 2, "--quiet").returncode, 0)
        check_whole(self, folder)
        done = hfrac("resume", folder, "--steps", 3, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        check_whole(self, folder)
        self.assertEqual([time for time, _ in entries(folder, "joints")], [time for time, _ in entries(folder, "discs")])
        self.assertEqual(hfrac("export", folder, "-o", out).returncode, 0)
        with open(out / "joints.csv", newline="") as file:
            contacts = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        pieces = [math.hypot(c["end_x_m"] - c["begin_x_m"], c["end_y_m"] - c["begin_y_m"]) for c in contacts]
        last, joints = history(folder)[-1], summary(folder)["joints"]
        slipped = sum(piece for piece, c in zip(pieces, contacts) if abs(c["slip_m"]) > joints["slip_counted_m"])
        for name, value in (("slipped_length_m", slipped), ("largest_slip_m", max(abs(c["slip_m"]) for c in contacts)),
                            ("open_length_m", sum(piece for piece, c in zip(pieces, contacts) if c["state"] == 3))):
            self.assertAlmostEqual(joints[name], value, delta=1e-9 * (value + 1), msg=name)
            self.assertEqual(float(last[f"joint_{name}"]), joints[name])
        self.assertGreater(joints["largest_slip_m"], 0.0)
        self.assertAlmostEqual(joints["length_m"], sum(pieces), delta=1e-9 * joints["length_m"])
        self.assertAlmostEqual(joints["length_m"], math.hypot(70, 15), delta=4)
        taken = float(last["well_rate_m2_per_s"]) / float(last["well_pressure_Pa"])  # net pressures
        self.assertAlmostEqual(float(last["well_injectivity_m2_per_Pa_s"]), taken, delta=1e-9 * abs(taken))
        self.assertIn("smooth joints", hfrac("info", folder).stdout)

    def test_catalogue_is_made_anew_by_another_rule(self):
        def events(folder):
            with open(folder / "events.csv", newline="") as file:
                return list(csv.DictReader(file))
        copy = self.top / "catalogue"
        shutil.copytree(self.folder, copy)
        cracks = len((copy / "cracks.csv").read_text().splitlines()) - 1
        self.assertEqual(sum(int(event["crack_count"]) for event in events(copy)), cracks)
        done = hfrac("catalogue", copy)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((copy / "events.csv").read_bytes(), (self.folder / "events.csv").read_bytes())
        done = hfrac("catalogue", copy, "--distance", 1e-9)
        self.assertIn(f"{cracks} of {cracks} cracks", done.stdout)
        self.assertEqual(len(events(copy)), cracks)
        self.assertEqual(hfrac("catalogue", self.top).returncode, 2)

    def test_own_discs_from_csv_and_vtu(self):
        """A run on the discs of another run's snapshot, then on the CSV it kept of them: the same, bit for bit."""
        case = self.top / "own.toml"
        case.write_text("[stress]\nconvention = 'effective'\nsigma_Hmax = 0.0\nsigma_hmin = 0.0\n")
        first = hfrac("run", case, "-o", self.top / "vtu", "--steps", 0, "--discs",
                      self.folder / entries(self.folder, "discs")[0][1])
        self.assertEqual(first.returncode, 0, first.stderr)
        again = hfrac("run", case, "-o", self.top / "csv", "--steps", 0, "--discs",
                      self.top / "vtu" / "given_discs.csv")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(summary(self.top / "vtu")["state_hash"], summary(self.top / "csv")["state_hash"])

    def test_cells_of_a_reservoir_simulator(self):
        folder = self.top / "cells"
        done = run_case(folder, "--grid", 7, 5, 20, 25, "--steps", 4)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(folder / "cells.csv", newline="") as file:
            cells = list(csv.DictReader(file))
        self.assertEqual([(int(c["i"]), int(c["j"])) for c in cells], [(i, j) for j in range(5) for i in range(7)])
        with open(folder / "cracks.csv", newline="") as file:
            length = sum(float(crack["length_m"]) for crack in csv.DictReader(file))
        self.assertAlmostEqual(sum(float(c["crack_length_m"]) for c in cells), length, delta=1e-9 * length)
        self.assertGreater(max(float(c["kxx_m2"]) for c in cells), 0.0)
        for name, keywords in (("permeability", ("PERMX", "PERMY", "PORO")), ("multipliers", ("MULTX", "MULTY", "MULTPV"))):
            text = (folder / f"{name}.grdecl").read_text()
            for keyword in keywords:
                self.assertIn(f"\n{keyword}\n", text)
        again = run_case(folder, "--overwrite", "--steps", 0)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("cells.csv", names(folder), "an earlier run's cells go with it")
        for bad in ((0, 5, 20, 25), (7, 5, 20, -25), (7, 5, 20)):
            self.assertEqual(run_case(self.top / "never", "--grid", *bad).returncode, 2)

    def test_bad_disc_files_are_refused(self):
        bad = self.top / "bad.csv"
        for text, word in (("x,y\n1,2\n", "radius"), ("x,y,radius\n1,2,three\n", ":2:"), ("x,y,radius\n", "no discs"),
                           ("x,y,radius\n1,2,3\n", "at least")):
            bad.write_text(text)
            done = hfrac("run", CASE, "-o", self.top / "never", "--discs", bad)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(word, done.stderr)
        self.assertEqual(hfrac("run", CASE, "-o", self.top / "never", "--discs", self.top / "nowhere.vtu").returncode, 2)

    def test_damaged_grids_of_discs_are_refused(self):
        grid = self.top / "grid.vtu"
        whole = sorted(self.folder.glob("discs_*.vtu"))[-1].read_bytes()
        for text, word in ((whole[:len(whole) // 2], "cannot be read"), (b"", "cannot be read"),
                           (whole.replace(b'"radius_m"', b'"radius_q"'), "no point array"),
                           (whole.replace(b'NumberOfPoints="', b'NumberOfPoints="9'), "wrong length")):
            self.assertNotEqual(text, whole)
            grid.write_bytes(text)
            done = hfrac("run", CASE, "-o", self.top / "never", "--discs", grid)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(word, done.stderr)

    def test_fluid_is_conserved(self):
        last = history(self.folder)[-1]
        injected = float(last["injected_volume_m2"])
        self.assertGreater(injected, 0.0)
        self.assertLess(abs(float(last["fluid_error_m2"])), 1e-6 * injected)

    def test_the_files_agree_with_each_other(self):
        last, short = history(self.folder)[-1], summary(self.folder)
        self.assertEqual(short["state"]["step"], int(last["step"]))
        self.assertEqual(short["state"]["crack_count"], int(last["crack_count"]))
        self.assertEqual(short["balance"]["injected_volume_m2"], float(last["injected_volume_m2"]))
        cracks = (self.folder / "cracks.csv").read_text().splitlines()
        self.assertEqual(len(cracks) - 1, int(last["crack_count"]))
        fractures = (self.folder / "fractures.csv").read_text().splitlines()
        self.assertEqual(len(fractures) - 1, len(short["fractures"]))
        self.assertGreater(short["wells"][0]["radius_m"], 0.0)
        self.assertEqual(short["snapshots"], len(entries(self.folder, "discs")))

    def test_the_case_written_gives_the_same_run(self):
        again = self.top / "again"
        done = hfrac("run", self.folder / "case.toml", "-o", again, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(summary(again)["state_hash"], summary(self.folder)["state_hash"])
        self.assertEqual((again / "cracks.csv").read_bytes(), (self.folder / "cracks.csv").read_bytes())
        self.assertEqual((again / "history.csv").read_bytes(), (self.folder / "history.csv").read_bytes())

    def test_workers_change_nothing(self):
        two = self.top / "two"
        done = run_case(two, "--workers", 2, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(summary(two)["state_hash"], summary(self.folder)["state_hash"])
        for file in ("cracks.csv", "history.csv", "fractures.csv"):
            self.assertEqual((two / file).read_bytes(), (self.folder / file).read_bytes(), file)

    def test_info_and_check_and_options(self):
        done = hfrac("info", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(summary(self.folder)["state_hash"], done.stdout)
        self.assertEqual(hfrac("info", self.top).returncode, 2)
        self.assertEqual(hfrac("check", CASE).returncode, 0)
        self.assertIn("bond.tensile_strength", hfrac("options").stdout)
        self.assertIn("hfrac 0.", hfrac("--version").stdout)


@unittest.skipUnless("HFRAC_RENDERS" in os.environ, "built without the renderer")
class Pictures(unittest.TestCase):
    def test_are_drawn_and_go_when_a_new_run_begins(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as folder:
            self.assertEqual(run_case(folder, "--steps", STEPS, "--quiet").returncode, 0)
            done = hfrac("render", folder, "--width", 640)
            self.assertEqual(done.returncode, 0, done.stderr)
            pictures = pathlib.Path(folder) / "pictures"
            for name in ("model.png", "growth.png", "pressure.png", "movie.mp4"):
                self.assertGreater((pictures / name).stat().st_size, 1000, name)
            self.assertEqual(run_case(folder, "--steps", 1, "--quiet", "--overwrite").returncode, 0)
            self.assertEqual(list(pictures.iterdir()), [])
        self.assertEqual(hfrac("render", "/no/such/run").returncode, 2)


class Codings(unittest.TestCase):
    def test_change_the_files_and_not_the_run(self):
        text = pathlib.Path(CASE).read_text()
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
            hashes = set()
            for choice in ('compression = "lz4"', 'compression = "none"'):
                case, folder = pathlib.Path(top) / "case.toml", pathlib.Path(top) / "run"
                case.write_text(text.replace("[output]", f"[output]\n{choice}"))
                done = hfrac("run", case, "-o", folder, "--steps", 2, "--quiet", "--overwrite")
                self.assertEqual(done.returncode, 0, done.stderr)
                check_whole(self, folder)
                hashes.add(summary(folder)["state_hash"])
                if "HFRAC_RENDERS" in os.environ:
                    done = hfrac("render", folder, "--no-movie", "--width", 480, "--quiet")
                    self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(hashes), 1)


class SecondRun(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "notes.txt").write_text("mine")
        done = run_case(self.folder, "--steps", STEPS, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_is_refused_and_changes_nothing(self):
        before = {name: (self.folder / name).read_bytes() for name in names(self.folder)}
        done = run_case(self.folder, "--steps", 1)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--overwrite", done.stderr)
        self.assertEqual(before, {name: (self.folder / name).read_bytes() for name in names(self.folder)})

    def test_overwrites_only_its_own_files(self):
        done = run_case(self.folder, "--steps", 1, "--overwrite")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "notes.txt").read_text(), "mine")
        self.assertEqual(summary(self.folder)["state"]["step"], 1)
        listed = {file for series in SERIES for _, file in entries(self.folder, series)}
        self.assertEqual({name for name in names(self.folder) if name.endswith(".vtu")}, listed)


if __name__ == "__main__":
    unittest.main()
