"""What the program says before a run and after it: faults by file and line, values in the wrong unit, room on the disk,
warnings, runs that were killed."""
import ctypes
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
import xml.dom.minidom

from hfrac_runs import COMMAND, hfrac, history, names, summary

CASE_TEXT = """[packing]
disc_count = 300
[solver]
kind = "quasi-static"
[stepping]
steps = 4
[output]
every = 2
[[well]]
radius = 8.0
pressure = 30e6
"""
CAP_DAC_OVERRIDE, PR_CAPBSET_DROP = 1, 24


def without_root_rights():
    """In the child: root, too, is to be stopped by a folder's permissions."""
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


class Words(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.case = self.write(CASE_TEXT)
        self.folder = self.top / "run"

    def write(self, text, name="case.toml"):
        file = self.top / name
        file.write_text(text)
        return file

    def refused(self, *arguments):
        """What is said of a line that must be refused as bad input before anything is written."""
        done = hfrac(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertFalse(self.folder.exists())
        return done.stderr

    def test_contradictions_name_file_and_line(self):
        for text, place in (("[bond]\nfracture_toughness = 1e6\n\ntoughness_reference_radius = 0.5\n", 2),
                            ("[[well]]\npressure = 30e6\n\nradius = 60.0\n", 4),
                            ("[disc]\ndensity = 2000.0\n\n[\x1e[mo = 1\n", 4)):
            bad = self.write(text, "bad.toml")
            for told in (self.refused("check", bad), self.refused("run", bad, "-o", self.folder)):
                self.assertIn(f"{bad}:{place}: ", told)
                self.assertEqual(len(told.splitlines()), 1, told)

    def test_a_title_holds_what_it_likes_and_nothing_of_it_is_shown_raw(self):
        case = self.write('title = "a \\u001b[31mred\\u0007 <b>&</b> \\u0085 title"\n' + CASE_TEXT)
        folder, shown, texts = self.folder, [], []
        for line in (("check", case), ("run", case, "-o", folder), ("info", folder)):
            done = hfrac(*line)
            self.assertEqual(done.returncode, 0, done.stderr)
            shown.append(done.stdout + done.stderr)
        self.assertIn("red", shown[0])
        if os.environ.get("HFRAC_RENDERS"):
            for line in (("render", folder, "--view", "discs", "-o", self.top / "view.svg"),
                         ("plot", folder, "--svg"), ("report", folder, "--no-movie", "--width", 320, "-q")):
                done = hfrac(*line)
                self.assertEqual(done.returncode, 0, done.stderr)
                shown.append(done.stdout + done.stderr)
            drawings = [self.top / "view.svg", *folder.rglob("*.svg")]
            self.assertGreater(len(drawings), 1)
            for drawing in drawings:
                xml.dom.minidom.parse(str(drawing))
            texts = [*drawings, folder / "report.html"]
            self.assertNotIn("<b>&</b>", (folder / "report.html").read_text())
        for text in shown + [file.read_text(encoding="utf-8") for file in texts]:
            self.assertIsNone(re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f]", text))

    def test_grids_are_looked_at_before_the_run(self):
        for numbers, told in ((("10.5", 10, 1, 1), "NX 10.5 is not a whole number"), ((10, 0, 1, 1), "NY 0 is not"),
                              ((10, 10, 1, 1, 5), "5 numbers"), ((10, 10, 1, 1, 0, 0, 0, 0), "8 numbers"),
                              ((10, 10, "nan", 1), "nan is not a finite number"), ((10, 10, 1, -1), "DY -1 is not"),
                              ((10, 10, 1, 1, 5000, 5000), "covers any of the model")):
            self.assertIn(told, self.refused("run", self.case, "-o", self.folder, "-q", "--grid", *numbers))

    def test_numbers_on_the_line_are_refused_in_short(self):
        for option in ("--steps", "--checkpoint-steps"):
            for value in ("-1", "1.5", "99999999999999999999", "nan", ""):
                told = self.refused("run", self.case, "-o", self.folder, f"{option}={value}")
                self.assertLess(len(told), 200)
                self.assertIn(option, told)

    def test_values_in_the_wrong_unit_are_told(self):
        case = self.write(CASE_TEXT.replace("30e6", "30") + "[stress]\nsigma_Hmax = 33\nsigma_hmin = 25\n"
                          "[fluid]\nformation_pressure = 0.0\n[contact]\nnormal_stiffness = 11.2\n", "mega.toml")
        for done in (hfrac("check", case), hfrac("run", case, "-o", self.folder, "--steps", 0)):
            for told in (r"well\[0\].pressure = 30 Pa .* 30e6\?", r"stress.sigma_Hmax = 33 Pa .* 33e6\?",
                         r"contact.normal_stiffness = 11.2 N/m .* 11.2e9\?"):
                self.assertRegex(done.stderr, told)
            self.assertNotIn("formation_pressure", done.stderr, "0 is a value of its own")
        self.assertEqual(hfrac("check", self.case).stderr, "")
        for option, value, meant in (("--E", 14, "14e9"), ("--ucs", 100, "100e6"), ("--tension", 8, "8e6"), ("--K", 1.5, "1.5e6"),
                                     ("--permeability", 5, "4.935e-15")):
            done = hfrac("calibrate", option, value)
            self.assertEqual(done.returncode, 2)
            self.assertIn(option, done.stderr)
            self.assertIn(meant, done.stderr)

    def test_what_memory_a_run_takes_is_told(self):
        for flow in ("implicit", "off"):
            for kind in ("explicit", "quasi-static"):
                case = self.write(f"""[packing]
method = "tiled"
disc_count = 20000
[flow]
scheme = "{flow}"
[solver]
kind = "{kind}"
[stress]
convention = "effective"
sigma_Hmax = 10e6
sigma_hmin = 5e6
[[well]]
radius = 3.0
pressure = 1e6
""")
                told = float(re.search(r"memory +about ([\d.]+) MB", hfrac("check", case).stdout).group(1))
                folder = self.top / f"{kind}-{flow}"
                child = os.posix_spawn(COMMAND, [str(COMMAND), "run", str(case), "-o", str(folder), "-q", "--steps", "1"], os.environ)
                _, status, used = os.wait4(child, 0)
                self.assertEqual(status, 0)
                self.assertTrue(0.5 < used.ru_maxrss * 1024 / (1e6 * told) < 2, (kind, flow, told, used.ru_maxrss))

    def test_what_a_run_will_write_is_told_and_looked_at(self):
        done = hfrac("check", self.case)
        snapshots, files, size = re.search(r"writes +(\d+) snapshots, about (\d+) files and (\d+) kB", done.stdout).groups()
        done = hfrac("run", self.case, "-o", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"will write {snapshots} snapshots", done.stderr)
        written = [path for path in self.folder.rglob("*") if path.is_file()]
        self.assertEqual(int(snapshots), summary(self.folder)["snapshots"])
        self.assertLess(abs(len(written) - int(files)), 6)
        total = sum(path.stat().st_size for path in written)
        self.assertTrue(0.5 < total / (1000 * int(size)) < 2, (total, size))

        huge = self.write(CASE_TEXT.replace("steps = 4", "steps = 1000000000000").replace("every = 2", "every = 1"))
        other = self.top / "other" / "below"
        done = hfrac("run", huge, "-o", other)
        self.assertEqual(done.returncode, 2)
        for told in ("1e+12 snapshots", "5e+12 files", "PB", "--no-space-check"):
            self.assertIn(told, done.stderr)
        self.assertFalse(other.parent.exists())
        done = hfrac("run", huge, "-o", other, "--no-space-check", "--steps", 1)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_warnings_reach_terminal_summary_and_report(self):
        case = self.write(CASE_TEXT.replace('"quasi-static"', '"explicit"').replace("steps = 4", "steps = 30\nmax_cycles = 5"))
        done = hfrac("run", case, "-o", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"warning: the model did not come to rest under the far field: .*raise stepping.max_cycles")
        self.assertIn("warning: step 1 did not come to rest", done.stderr)
        self.assertLess(len(done.stderr.splitlines()), 12, "a warning of every step hides the others")
        warnings = summary(self.folder)["warnings"]
        self.assertEqual([one["step"] for one in warnings], list(range(len(warnings))))
        self.assertEqual(len(warnings), 20)
        self.assertIn("far field", warnings[0]["text"])
        self.assertIn("warning", hfrac("info", self.folder).stdout)
        self.assertEqual(hfrac("run", case, "-o", self.top / "quiet", "-q").stderr, "")
        if os.environ.get("HFRAC_RENDERS"):
            self.assertEqual(hfrac("report", self.folder, "--no-movie", "--width", 320, "-q").returncode, 0)
            self.assertIn("did not come to rest under the far field", (self.folder / "report.html").read_text())

    def test_a_run_that_goes_on_keeps_its_warnings(self):
        case = self.write(CASE_TEXT.replace('"quasi-static"', '"explicit"').replace("steps = 4", "steps = 6\nmax_cycles = 5"))
        self.assertEqual(hfrac("run", case, "-o", self.folder, "-q", "--checkpoint-steps", 3).returncode, 0)
        whole = summary(self.folder)["warnings"]
        self.assertEqual([one["step"] for one in whole], list(range(7)))
        self.assertEqual(hfrac("resume", self.folder, "-q", "--steps", 8).returncode, 0)
        self.assertEqual(summary(self.folder)["warnings"][:7], whole)
        self.assertEqual([one["step"] for one in summary(self.folder)["warnings"]], list(range(9)))

    def test_info_tells_a_killed_run_from_one_that_goes_on(self):
        process = subprocess.Popen([COMMAND, "run", self.case, "-o", self.folder, "-q", "--steps", "1000000"])
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 60
        while not (self.folder / "history.csv").exists() or len(history(self.folder)) < 4:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        self.assertRegex(hfrac("info", self.folder).stdout, r"ended +not yet: it goes on, \d+ steps taken")
        process.send_signal(signal.SIGKILL)
        process.wait(60)
        step = history(self.folder)[-1]["step"]
        self.assertRegex(hfrac("info", self.folder).stdout,
                         rf"ended +unfinished: it was killed, {step} steps taken; hfrac resume {self.folder}")

    def test_options_lists_wells_schedules_and_joints(self):
        text = hfrac("options").stdout
        for key in ("bond.tensile_strength", "well.ramp_per_step", "well.schedule.time", "joint.x1"):
            self.assertIn(f"\n{key} ", text)

    @unittest.skipUnless(os.environ.get("HFRAC_RENDERS"), "built without the renderer")
    def test_a_report_of_a_folder_that_may_not_be_written(self):
        self.assertEqual(hfrac("run", self.case, "-o", self.folder, "-q").returncode, 0)
        before = names(self.folder)
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        target = self.top / "elsewhere.html"
        done = hfrac("report", self.folder, "-o", target, "--no-movie", "--width", 320, "-q", preexec_fn=without_root_rights)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = target.read_text()
        self.assertGreater(text.count("<img"), 2, "pictures are missing")
        self.assertIn("<svg", text)
        self.assertEqual(names(self.folder), before)


if __name__ == "__main__":
    unittest.main()
