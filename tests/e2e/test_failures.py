"""Runs that cannot end well: each must say why, in words, with the right exit code, and leave no half file."""
import ctypes
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from hfrac_runs import CASE, COMMAND, SERIES, check_whole, entries, hfrac, history, names, run_case, summary

MANY = 1000000  # more steps than any of these runs will take
CAP_DAC_OVERRIDE, PR_CAPBSET_DROP = 1, 24


def without_root_rights():
    """In the child: root, too, is to be stopped by a folder's permissions."""
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


class FailingRun(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.folder = self.top / "run"

    def bad_case(self, text):
        file = self.top / "bad.toml"
        file.write_text(text)
        return file

    def test_wrong_usage(self):
        for arguments in ((), ("run",), ("run", CASE), ("fly",), ("run", CASE, "-o", self.folder, "--steps", "many")):
            self.assertEqual(hfrac(*arguments).returncode, 2, arguments)
        self.assertFalse(self.folder.exists())

    def test_a_bad_case_writes_nothing(self):
        for text in ("[bond]\ntensile_strenght = 1.0\n", "[bond]\ntensile_strength = -1.0\n", "this is no TOML\n"):
            case = self.bad_case(text)
            for done in (hfrac("run", case, "-o", self.folder), hfrac("check", case)):
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("bad.toml", done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertFalse(self.folder.exists())

    def test_a_refusal_names_its_place_in_the_guide(self):
        guide = (pathlib.Path(__file__).resolve().parents[2] / "docs/user-guide.md").read_text()
        headings = {re.sub(r"[^\w -]", "", line).strip().lower().replace(" ", "-") for line in re.findall(r"^#+ (.*)$", guide, re.M)}
        well = "[[well]]\nradius = 6.0\npressure = 30e6\n"
        for text, place in (
            ("[bond]\ntensile_strenght = 1.0\n", "bond"),
            ("fluid.viscosity = -1.0\n", "fluid"),
            ("[[well]]\nradius = -1.0\npressure = 30e6\n", "well"),
            (well + "[[well.schedule]]\ntime = -1.0\nrate = 0\n", "wellschedule"),
            (well + "[[joint]]\nx1 = 3\n", "joint"),
        ):
            done = hfrac("check", self.bad_case(text))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(f"(docs/user-guide.md#{place})\n", done.stderr)
            self.assertIn(place, headings)

    def test_rock_that_falls_apart_is_no_result(self):
        for discs, radius, pressure in ((60, 22, "30e6"), (300, 15, "60e6")):
            case = self.bad_case(f"[packing]\ndisc_count = {discs}\n[[well]]\nradius = {radius}\npressure = {pressure}\n")
            done = hfrac("run", case, "-o", self.folder, "--overwrite")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("the rock fell apart in step 1: disc ", done.stderr)
            self.assertIn("more than its diameter of ", done.stderr)
            length = re.search(r"longest fracture +(\S+) m long", done.stdout)
            self.assertTrue(length is None or float(length[1]) < 100.0, done.stdout)
            self.assertEqual([row["step"] for row in history(self.folder)], ["0"])
            self.assertRegex(summary(self.folder)["ended"], "^failed: the rock fell apart in step 1: ")

    def test_rock_that_cannot_bear_its_stress_is_not_built(self):
        case = self.bad_case("[packing]\ndisc_count = 600\n[stress]\nsigma_Hmax = 60e6\nsigma_hmin = 30e6\n[bond]\ntensile_strength = 4e6\nshear_strength = 4e6\n")
        done = hfrac("run", case, "-o", self.folder)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("bad.toml: the rock does not bear the far field", done.stderr)
        self.assertIn("initial.broken_fraction", done.stderr)
        self.assertFalse(self.folder.exists())

    def test_a_missing_case(self):
        done = hfrac("run", self.top / "none.toml", "-o", self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("none.toml", done.stderr)

    def test_a_file_where_the_folder_should_be(self):
        self.folder.write_text("not a folder")
        done = run_case(self.folder, "--steps", 1)
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(self.folder), done.stderr)

    def test_a_folder_that_may_not_be_written(self):
        self.folder.mkdir()
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o755)
        done = run_case(self.folder, "--steps", 1, preexec_fn=without_root_rights)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("Permission denied", done.stderr)
        self.assertIn(str(self.folder), done.stderr)
        self.assertEqual(names(self.folder), [])

    def test_a_limit_on_file_size(self):
        run_case(self.folder, "--steps", 0, "--quiet")
        largest = max(path.stat().st_size for path in self.folder.iterdir())
        limited = self.top / "limited"

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest - 1, largest - 1))

        done = run_case(limited, "--steps", 2, preexec_fn=limit)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("File too large", done.stderr)
        self.assertIn(str(limited), done.stderr)
        self.assertEqual([name for name in names(limited) if name.startswith(".")], [])

    def test_a_full_disk_keeps_what_was_complete(self):
        run_case(self.folder, "--steps", 0, "--quiet")
        once = sum(-(-path.stat().st_size // 4096) * 4096 for path in self.folder.iterdir())
        disk = self.top / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={int(1.9 * once)}", "tmpfs", disk],
                                 capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("a small file system cannot be mounted here; test_a_limit_on_file_size covers the rest")
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        done = run_case(disk / "run", "--steps", MANY, "--no-space-check")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("No space left on device", done.stderr)
        self.assertIn("stay readable", done.stderr)
        self.assertTrue(all(len(entries(disk / "run", series)) >= 1 for series in SERIES))
        check_whole(self, disk / "run")

    def test_a_limit_on_memory(self):
        """As under `ulimit -v`: a model that does not fit is refused in words, whatever the limit; never a crash."""
        case = self.bad_case("[packing]\ndisc_count = 20000\nresidual = 0.1\n[stepping]\nforce_ratio = 0.1\nmax_cycles = 20\n")

        def limited(megabytes, *arguments):
            allowed = megabytes << 20
            return hfrac(*arguments, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (allowed, allowed)))

        low, high = 16, 8192  # the least that the program itself needs
        while high - low > 4:
            middle = (low + high) // 2
            low, high = (low, middle) if limited(middle, "check", case).returncode == 0 else (middle, high)
        refused = 0
        for more in (4, 8, 16, 24, 32, 48, 64):
            done = limited(high + more, "run", case, "-o", self.folder, "-q", "--steps", 0, "--overwrite")
            self.assertIn(done.returncode, (0, 1), f"{high} + {more} MB: {done.stderr}")
            if done.returncode == 1:
                self.assertRegex(done.stderr, "memory|workers could be started")
                refused += 1
        self.assertGreater(refused, 0, "no limit was low enough to say anything")

    def start_long_run(self):
        """A run that has taken a few steps and goes on."""
        process = subprocess.Popen([COMMAND, "run", CASE, "-o", self.folder, "--steps", str(MANY), "--quiet"],
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 300
        while not (self.folder / "history.csv").exists() or len(history(self.folder)) < 4:
            self.assertLess(time.monotonic(), deadline, "the run does not get going")
            self.assertIsNone(process.poll(), "the run ended too early")
            time.sleep(0.01)
        return process

    def test_interrupts_end_the_run_cleanly(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start_long_run()
            process.send_signal(number)
            self.assertEqual(process.wait(120), 130)
            self.assertIn("interrupted", process.stderr.read())
            check_whole(self, self.folder)
            short, rows = summary(self.folder), history(self.folder)
            self.assertEqual(short["ended"], "interrupted")
            self.assertEqual(short["state"]["step"], int(rows[-1]["step"]))
            self.assertEqual(entries(self.folder, "discs")[-1][0], float(rows[-1]["time_s"]))
            self.assertEqual(hfrac("info", self.folder).returncode, 0)
            whole = self.top / f"whole-{number}"
            run_case(whole, "--steps", short["state"]["step"], "--quiet")
            self.assertEqual(short["state_hash"], summary(whole)["state_hash"], "not at a whole step")
            shutil.rmtree(self.folder)

    def test_a_killed_run_stays_readable(self):
        process = self.start_long_run()
        process.kill()
        process.wait(60)
        for path in self.folder.glob(".*.tmp"):  # the file at work when the process died
            path.unlink()
        check_whole(self, self.folder)
        self.assertEqual(hfrac("info", self.folder).returncode, 0)
        self.assertIn("unfinished", hfrac("info", self.folder).stdout)


if __name__ == "__main__":
    unittest.main()
