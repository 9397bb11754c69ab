"""Checkpoints and `hfrac resume`: a run goes on as if nothing had happened, or says why it cannot."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "e2e"))
from hfrac_runs import CASE, COMMAND, hfrac, history, names, summary  # noqa: E402

from crash_campaign import CASES, check_end  # noqa: E402


class Resumed(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-trust-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.folder, self.whole = self.top / "run", self.top / "whole"

    def case(self, text=CASES["explicit_direct"]):
        file = self.top / "case.toml"
        file.write_text(text)
        return file

    def run_good(self, *arguments):
        done = hfrac(*arguments, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def start_until(self, case, step, *arguments):
        """A run that has taken so many steps and goes on."""
        process = subprocess.Popen([COMMAND, "run", str(case), "-o", str(self.folder), "-q", *arguments],
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 120
        while not (self.folder / "summary.json").exists() or len(history(self.folder)) <= step:
            self.assertLess(time.monotonic(), deadline, "the run does not get going")
            time.sleep(0.002)
        return process

    def cut_short(self, case, step):
        """What a run leaves that was killed after `step`: a run to there whose summary says it is going on."""
        self.run_good("run", case, "-o", self.folder, "--steps", step)
        short = summary(self.folder)
        short["ended"], short["request"]["steps"] = "running", -1
        (self.folder / "summary.json").write_text(json.dumps(short))
        (self.folder / "fractures.csv").unlink()

    def checkpoints(self):
        return sorted(path.name for path in (self.folder / "checkpoints").iterdir())

    def test_every_solver_goes_on_bit_for_bit(self):
        for name, text in CASES.items():
            with self.subTest(name):
                case = self.case(text)
                self.run_good("run", case, "-o", self.whole)
                self.assertGreater(summary(self.whole)["state"]["crack_count"], 0, "nothing broke: no test of cracks")
                self.cut_short(case, 9)
                self.assertEqual(self.checkpoints(), ["step_00004.checkpoint", "step_00008.checkpoint"])
                self.run_good("resume", self.folder)
                check_end(self.folder, self.whole)
                shutil.rmtree(self.folder)
                shutil.rmtree(self.whole)

    def test_interrupted_by_a_signal(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start_until(CASE, 4)
            process.send_signal(number)
            self.assertEqual(process.wait(120), 130)
            self.assertIn("hfrac resume", process.stderr.read())
            step = summary(self.folder)["state"]["step"]
            self.assertEqual(self.checkpoints()[-1], f"step_{step:05}.checkpoint", "none of the moment it was interrupted")
            self.run_good("resume", self.folder)
            if not self.whole.exists():
                self.run_good("run", CASE, "-o", self.whole)
            check_end(self.folder, self.whole)
            shutil.rmtree(self.folder)

    def test_by_wall_time(self):
        self.run_good("run", self.case(CASES["explicit_direct"].replace("checkpoint_steps = 4", "checkpoint_every = 1e-9")),
                      "-o", self.folder)
        self.assertEqual(self.checkpoints(), ["step_00013.checkpoint", "step_00014.checkpoint"])
        self.run_good("run", self.case(), "-o", self.folder, "--overwrite", "--checkpoint-every", 0, "--checkpoint-steps", 0)
        self.assertFalse(list((self.folder / "checkpoints").iterdir()))

    def test_a_damaged_checkpoint_is_passed_over(self):
        case = self.case()
        self.run_good("run", case, "-o", self.whole)
        self.cut_short(case, 9)
        newest = self.folder / "checkpoints" / "step_00008.checkpoint"
        good = newest.read_bytes()
        for damage, words in ((good[:-1], "cut"), (good[:3000] + b"\0\1" + good[3002:], "damaged"), (b"", "shorter"),
                              (good[:8] + b"\7" + good[9:], "its format is 7")):
            newest.write_bytes(damage)
            done = self.run_good("resume", self.folder)
            self.assertIn(words, done.stderr)
            self.assertIn(newest.name, done.stderr)
            check_end(self.folder, self.whole)
            shutil.rmtree(self.folder)
            self.cut_short(case, 9)
        for path in (self.folder / "checkpoints").iterdir():
            path.write_bytes(b"nothing")
        done = hfrac("resume", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from its beginning again", done.stdout)
        check_end(self.folder, self.whole)

    def test_half_a_line_of_history_is_cut_away(self):
        case = self.case()
        self.run_good("run", case, "-o", self.whole)
        self.cut_short(case, 9)
        with open(self.folder / "history.csv", "a") as file:
            file.write("10,0.1,45")
        unfinished = self.folder / ".discs_00012.vtu.4711-3.tmp"
        unfinished.write_text("half")
        self.run_good("resume", self.folder)
        self.assertFalse(unfinished.exists())
        check_end(self.folder, self.whole)

    def test_own_discs_and_a_grid_come_along(self):
        discs = self.top / "discs.csv"
        discs.write_text("x,y,radius\n" + "".join(f"{5 + 10 * i + 5 * (j % 2)},{5 + 8.66 * j},5\n" for i in range(9) for j in range(11)))
        case = self.case("[model]\nwidth = 100\nheight = 100\n[stress]\nconvention = 'effective'\nsigma_Hmax = 1e6\nsigma_hmin = 1e6\n"
                         "[stepping]\nflow_step = 1e-2\nsteps = 12\n[[well]]\nx = 50\ny = 48\nradius = 12\npressure = 60e6\n"
                         "[output]\nevery = 4\ncheckpoint_steps = 3\n")
        arguments = ("--discs", discs, "--grid", 4, 4, 20, 20)
        self.run_good("run", case, "-o", self.whole, *arguments)
        process = self.start_until(case, 7, *map(str, arguments))
        process.kill()
        process.wait()
        discs.unlink()
        self.run_good("resume", self.folder)
        check_end(self.folder, self.whole)
        self.assertIn("cells.csv", names(self.folder))

    def test_a_complete_run_is_left_alone_or_made_longer(self):
        case = self.case()
        self.run_good("run", case, "-o", self.folder)
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        done = hfrac("resume", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("nothing to do", done.stdout)
        self.assertEqual(before, {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()})
        self.run_good("resume", self.folder, "--steps", 20)
        self.run_good("run", case, "-o", self.whole, "--steps", 20)
        check_end(self.folder, self.whole)
        self.assertEqual(hfrac("resume", self.folder, "--steps", 3).returncode, 2, "there is no way back")

    def test_what_cannot_go_on_says_so_and_changes_nothing(self):
        case = self.case()
        done = hfrac("resume", self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("summary.json", done.stderr)
        self.cut_short(case, 9)

        def refused(words):
            before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
            result = hfrac("resume", self.folder)
            self.assertIn(result.returncode, (1, 2))
            self.assertIn(words, result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()) <= 2, True, result.stderr)
            return before == {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}

        text = (self.folder / "case.toml").read_text()
        (self.folder / "case.toml").write_text(text.replace("friction = 0.22", "friction = 0.3"))
        self.assertTrue(refused("does not belong to"))
        (self.folder / "case.toml").write_text("nothing")
        self.assertTrue(refused("case.toml"))
        (self.folder / "case.toml").write_text(text)
        (self.folder / "history.csv").write_text("step\n")
        refused("lacks lines")
        short = summary(self.folder)
        del short["request"]
        (self.folder / "summary.json").write_text(json.dumps(short))
        self.assertTrue(refused("older hfrac"))

    def test_one_process_at_a_time(self):
        process = self.start_until(CASE, 2, "--steps", "1000000")
        for arguments in (("resume", self.folder), ("run", CASE, "-o", self.folder, "--overwrite")):
            done = hfrac(*arguments)
            self.assertEqual(done.returncode, 1)
            self.assertIn("another process", done.stderr)
        self.assertIsNone(process.poll())
        process.kill()
        process.wait()

    def test_planted_links_are_not_followed(self):
        victim = self.top / "victim"
        victim.write_text("mine")
        elsewhere = self.top / "elsewhere"
        elsewhere.mkdir()
        for link in ("case.toml", "summary.json", "discs_00000.vtu"):
            shutil.rmtree(self.folder, ignore_errors=True)
            self.folder.mkdir()
            (self.folder / link).symlink_to(victim)
            hfrac("run", self.case(), "-o", self.folder, "-q", "--overwrite")
            self.assertEqual(victim.read_text(), "mine", link)
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        (self.folder / "history.csv").symlink_to(victim)
        (self.folder / "checkpoints").symlink_to(elsewhere)
        done = hfrac("run", self.case(), "-o", self.folder, "-q", "--overwrite")
        self.assertEqual(victim.read_text(), "mine")
        self.assertEqual(list(elsewhere.iterdir()), [])
        self.assertIn("no checkpoint", done.stderr)

    def test_info_tells_hash_and_checkpoints(self):
        self.run_good("run", self.case(), "-o", self.folder)
        text = hfrac("info", self.folder).stdout
        self.assertIn(summary(self.folder)["state_hash"], text)
        self.assertIn("after step 8 and 12", text)

    @unittest.skipUnless(os.environ.get("HFRAC_RENDERS"), "built without the renderer")
    def test_the_movie_comes_along(self):
        process = self.start_until(self.case(), 5, "--movie")
        process.kill()
        process.wait()
        self.run_good("resume", self.folder)
        self.assertGreater((self.folder / "pictures" / "movie.mp4").stat().st_size, 1000)


if __name__ == "__main__":
    unittest.main()
