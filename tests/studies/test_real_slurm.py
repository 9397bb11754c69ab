#!/usr/bin/python3
"""hfrac sweep --slurm by a real Slurm of one node, started and stopped by the test (one_node_slurm.py): an array and its table, a task put back into the queue
in the middle, and, with HFRAC_LONG=1, 1 079 runs and what the scheduler costs them."""
import datetime
import os
import pathlib
import sys
import tempfile
import time
import unittest

import support
from one_node_slurm import jobs, output, slurm, until, why_not

LONG = "HFRAC_LONG" in os.environ


def seconds(job, name):
    return datetime.datetime.fromisoformat(job[name]).timestamp()


class RealSlurm(unittest.TestCase):
    def setUp(self):
        top = tempfile.TemporaryDirectory(prefix="hfrac-slurm-")
        self.addCleanup(top.cleanup)
        self.folder = pathlib.Path(top.name)
        node = self.folder / "node"
        node.mkdir()
        running = slurm(node)
        self.environment = running.__enter__()
        self.addCleanup(running.__exit__, None, None, None)

    def submit(self, runs, *words):
        study = support.write_study(self.folder, runs)
        done = support.hfrac("sweep", study, "-o", self.folder / "out", "--slurm", "--memory", "1", *words, env=self.environment)
        self.assertEqual(done.returncode, 0, done.stderr)

    def wait(self, limit):
        until(lambda: not output(self.environment, "squeue", "--noheader"), "the end of all jobs", limit)
        logs = "".join(path.read_text() for path in (self.folder / "out/slurm").glob("*.log"))
        self.assertTrue((self.folder / "out/table.csv").exists(), logs)
        return (self.folder / "out/table.csv").read_text().count(",done,")

    @unittest.skipIf(LONG, "the short ones")
    def test_an_array_with_a_task_put_back_into_the_queue(self):
        self.submit(9, "--runs-per-job", "4", "--minutes", "5")
        first = self.folder / "out/runs"
        until(lambda: len(list(first.glob("*/result.json"))) >= 2, "the first runs")
        task = next(job for job in jobs(self.environment) if job.get("JobState") == "RUNNING")
        output(self.environment, "scontrol", "requeue", f"{task['ArrayJobId']}_{task['ArrayTaskId']}")
        self.assertEqual(self.wait(300), 9)
        array = [job for job in jobs(self.environment) if "ArrayTaskId" in job]
        self.assertEqual([job["JobState"] for job in array], ["COMPLETED"] * 3)
        self.assertEqual(sorted(int(job["Restarts"]) for job in array), [0, 0, 1])

    @unittest.skipUnless(LONG, "1 079 runs")
    def test_the_scheduler_takes_a_twentieth_at_most(self):
        runs, began = 1079, time.time()
        self.submit(runs, "--runs-per-job", "90", "--minutes", "60")
        self.assertEqual(self.wait(7200), runs)
        tasks = [job for job in jobs(self.environment) if "ArrayTaskId" in job]
        # Of what the processors could have done until the last task ended; times are whole seconds.
        busy = sum(seconds(job, "EndTime") - seconds(job, "StartTime") for job in tasks)
        whole = max(seconds(job, "EndTime") for job in tasks) - began
        share = 1.0 - busy / (os.cpu_count() * whole)
        print(f"{runs} runs in {len(tasks)} tasks: {whole:.0f} s, {os.cpu_count()} processors busy with tasks for {busy:.0f} s: "
              f"the scheduler's share, and what the last tasks left idle, {100 * share:.1f} %")
        self.assertLess(share, 0.05)


if __name__ == "__main__":
    if why_not():
        print(f"skipped: {why_not()}")
        sys.exit(77)
    unittest.main()
