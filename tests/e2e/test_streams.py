"""The streams to the shell and its signals: text that cannot be written, a terminal that goes away, limits of a queue."""
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from hfrac_runs import COMMAND, TINY_CASE, hfrac, history, summary

MANY = 1000000  # more steps than any of these runs will take
LOG_PAUSE = 5  # seconds between two lines of progress in a log


def close(number):
    return lambda: os.close(number)


class Streams(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.case = self.top / "case.toml"
        self.case.write_text(TINY_CASE)

    def start(self, folder, *arguments, **options):
        """A run that has taken a few steps and goes on."""
        options.setdefault("stdout", subprocess.DEVNULL)
        options.setdefault("stderr", subprocess.DEVNULL)
        process = subprocess.Popen([COMMAND, "run", self.case, "-o", folder, "--steps", str(MANY), *arguments], **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 300
        while not (folder / "history.csv").exists() or len(history(folder)) < 4:
            self.assertLess(time.monotonic(), deadline, "the run does not get going")
            self.assertIsNone(process.poll(), f"the run ended too early: {process.returncode}")
            time.sleep(0.01)
        return process

    def test_progress_that_cannot_be_written_never_ends_a_run(self):
        def limited():  # the log is at its limit; files of the run stay below it
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 24, 1 << 24))

        full = open("/dev/full", "w", encoding="ascii")
        log = open(self.top / "log", "wb")
        log.truncate(1 << 24)
        log.seek(0, os.SEEK_END)
        read_end, write_end = os.pipe()
        os.close(read_end)
        runs = {"full disk": {"stderr": full}, "closed": {"preexec_fn": close(2)},
                "limit on file size": {"stderr": log, "preexec_fn": limited},
                "pipe that nobody reads":
                    {"stderr": write_end, "preexec_fn": lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN),
                     "restore_signals": False}}
        started = {name: self.start(self.top / name, **options) for name, options in runs.items()}
        for file in (full, log):
            file.close()
        os.close(write_end)
        time.sleep(LOG_PAUSE + 2)
        for name, process in started.items():
            with self.subTest(name):
                self.assertIsNone(process.poll(), "the run ended")
                process.terminate()
                self.assertEqual(process.wait(60), 130)
                self.assertEqual(summary(self.top / name)["ended"], "interrupted")
                rows = [int(row["step"]) for row in history(self.top / name)]
                self.assertEqual(rows, list(range(len(rows))), "text of the program is among the data")

    def test_signals_that_end_a_run_leave_a_checkpoint(self):
        for number in (signal.SIGHUP, signal.SIGXCPU, signal.SIGPIPE, signal.SIGXFSZ):
            with self.subTest(number.name):
                folder = self.top / number.name
                process = self.start(folder)
                for _ in range(2):  # a limit of time, or a pipe, sends it again
                    process.send_signal(number)
                    time.sleep(0.002)
                self.assertEqual(process.wait(60), 130)
                self.assertEqual(summary(folder)["ended"], "interrupted")
                step = summary(folder)["state"]["step"]
                self.assertTrue((folder / "checkpoints" / f"step_{step:05}.checkpoint").exists())

    def test_a_reader_that_goes_away_ends_a_run_as_ctrl_c_does(self):
        folder = self.top / "run"
        read_end, write_end = os.pipe()
        process = self.start(folder, stderr=write_end)
        os.close(write_end)
        os.close(read_end)
        self.assertEqual(process.wait(60), 130)
        self.assertTrue(list((folder / "checkpoints").iterdir()))

    def test_nohup_is_kept(self):
        folder = self.top / "run"
        process = self.start(folder, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        time.sleep(1)
        self.assertIsNone(process.poll())

    def test_results_that_cannot_be_written_are_an_error(self):
        folder = self.top / "run"
        self.assertEqual(hfrac("run", self.case, "-o", folder, "--steps", 1, "-q").returncode, 0)
        commands = [("check", self.case), ("info", folder), ("options",), ("options", "bond."), ("--help",), ("--version",),
                    ("catalogue", folder), ("resume", folder), ("export", folder, "-o", self.top / "tables")]
        for arguments in commands:
            with self.subTest(arguments[0]), open("/dev/full", "w", encoding="ascii") as full:
                line = [COMMAND, *map(str, arguments)]
                good = subprocess.run(line, capture_output=True, text=True, timeout=60)
                self.assertEqual(good.returncode, 0, good.stderr)
                done = subprocess.run(line, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
                self.assertEqual(done.returncode, 1)
                self.assertIn("No space left on device", done.stderr)
                done = subprocess.run(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=60,
                                      preexec_fn=close(1))
                self.assertEqual(done.returncode, 1)
                self.assertIn("Bad file descriptor", done.stderr)

    def test_a_run_is_good_though_its_table_cannot_be_printed(self):
        folder = self.top / "run"
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([COMMAND, "run", self.case, "-o", folder, "--steps", "1"], stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("No space left on device", done.stderr)
        self.assertEqual(hfrac("info", folder).returncode, 0)

    def test_an_unknown_command_is_named(self):
        done = hfrac("foo")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'foo'", done.stderr)
        self.assertIn("run", done.stderr)


if __name__ == "__main__":
    unittest.main()
