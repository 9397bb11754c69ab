"""The workflow of the paper's experiments: the same numbers on a second run, no run lost in a kill, a failed run that
stays one, and a cluster's scheduler. Environment: HFRAC_COMMAND, the program."""
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORKFLOW = ROOT / "examples/paper/workflow"
sys.path.insert(0, str(WORKFLOW))
import families
import run_case

HFRAC = os.environ["HFRAC_COMMAND"]
RUNS = families.expand("fast")[0]
REPEATED = ["figure-05-paper-45-s1", "figure-09-tangential-27.5-s1", "figure-12-total-250C-2-s1"]


def one_run(name, folder, packing, program=HFRAC, which="fast"):
    done = subprocess.run(
        [sys.executable, "-B", WORKFLOW / "run_case.py", which, name, folder, *packing],
        capture_output=True,
        text=True,
        env=dict(os.environ, HFRAC=str(program)),
    )
    assert done.returncode == 0, done.stderr
    return folder


def set_of_runs(out, *arguments):
    """Command and options of a call of examples/paper/run --fast."""
    environment = dict(os.environ, HFRAC=HFRAC, HFRAC_PAPER_OUT=str(out))
    return [ROOT / "examples/paper/run", "--fast", *arguments], {"env": environment, "text": True}


class Workflow(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-paper-"))
        self.addCleanup(shutil.rmtree, self.top, ignore_errors=True)

    def packing(self, name, folder):
        return [one_run(f"packing:{RUNS[name].packing}", folder, []) / "discs_00000.vtu"]

    def test_same_numbers_on_a_second_run(self):
        for name in REPEATED:
            results = []
            for turn in ("first", "second"):  # the packing twice, too
                discs = self.packing(name, self.top / turn / f"packing-{name}")
                folder = one_run(name, self.top / turn / name, discs)
                results.append(json.loads((folder / "result.json").read_text()))
            self.assertEqual(results[0]["status"], "done", results[0])
            self.assertEqual(results[0], results[1])  # state hash among them: the last bit
            self.assertGreater(results[0]["cracks"], 0, name)

    def test_a_run_that_fails_is_broken_and_says_so(self):
        folder = one_run(REPEATED[0], self.top / "run", [self.top / "no-discs.vtu"])
        result = json.loads((folder / "result.json").read_text())
        self.assertEqual(result["status"], "broken")
        self.assertIn("no-discs.vtu", result["error"])

    def test_a_run_ends_at_the_area_asked_for(self):
        """Runs with as much fluid for every pressure: the first step after which the fractures are open that far."""
        name = "beyond-10-volume-250C-80-s1"
        run = families.expand("full")[0][name]
        discs = [one_run(f"packing:{run.packing}", self.top / "packing", [], which="full") / "discs_00000.vtu"]
        folder = one_run(name, self.top / "run", discs, which="full")
        result = json.loads((folder / "result.json").read_text())
        areas = [row["fracture_volume_m2"] for row in run_case.numbers(folder / "history.csv")]
        self.assertLess(result["steps"], run.case["stepping"]["steps"])
        self.assertEqual(len(areas), result["steps"] + 1)
        self.assertGreaterEqual(areas[-1], run.until)
        self.assertLess(max(areas[:-1]), run.until)

    @unittest.skipIf(shutil.which("snakemake", path="/usr/bin") is None, "snakemake is not installed")
    def test_a_killed_workflow_goes_on(self):
        command, options = set_of_runs(self.top, "--cores", "1")
        going = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True, **options
        )
        finished = []
        end = time.monotonic() + 240
        while len(finished) < 2 and time.monotonic() < end and going.poll() is None:
            time.sleep(0.2)
            finished = list(self.top.glob("runs/*/result.json"))
        os.killpg(going.pid, signal.SIGKILL)
        going.wait()
        finished = {path.parent.name for path in self.top.glob("runs/*/result.json")}
        self.assertGreaterEqual(len(finished), 2)
        command, options = set_of_runs(self.top, "--cores", "1", "--dry-run")
        plan = subprocess.run(command, capture_output=True, **options)
        self.assertEqual(plan.returncode, 0, plan.stderr)
        planned = {name for name in RUNS if f"run={name}\n" in plan.stdout + plan.stderr}
        # the last two may have been stopped between the result and snakemake's own note of it
        self.assertLessEqual(len(planned & finished), 2)
        self.assertEqual(planned | finished, set(RUNS))

    @unittest.skipIf(shutil.which("snakemake", path="/usr/bin") is None, "snakemake is not installed")
    def test_a_second_time_runs_all_again_beside_the_first(self):
        command, options = set_of_runs(self.top / "set", "--cores", "1", "--again", "--dry-run")
        refused = subprocess.run(command, capture_output=True, **options)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("nothing to compare with", refused.stderr)
        (self.top / "set").mkdir()
        (self.top / "set/measured.csv").write_text("family,series,x,seed,run,status\n")
        plan = subprocess.run(command, capture_output=True, **options)
        self.assertEqual(plan.returncode, 0, plan.stderr)
        text = plan.stdout + plan.stderr
        for name in RUNS:
            self.assertIn(f"set-again/runs/{name}/result.json", text)
        self.assertNotIn("rule judge", text)

    @unittest.skipIf(shutil.which("snakemake", path="/usr/bin") is None, "snakemake is not installed")
    def test_a_cluster_gets_a_job_a_run(self):
        command, options = set_of_runs(self.top, "--dry-run", "--profile", WORKFLOW / "slurm")
        plan = subprocess.run(command, capture_output=True, **options)
        self.assertEqual(plan.returncode, 0, plan.stderr)
        text = plan.stdout + plan.stderr
        for name in RUNS:
            self.assertIn(f"run={name}\n", text)
        self.assertIn("runtime=5", text)


if __name__ == "__main__":
    unittest.main()
