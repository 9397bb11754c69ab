#!/usr/bin/python3
"""hfrac sweep --slurm with a stand-in for sbatch that runs the tasks of the array one after the other: what is submitted, that the table
comes of it, and that a second submission has only what is missing."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import support

SBATCH = """#!/bin/bash
# Writes down its words, runs every task of the array, and prints a number as sbatch --parsable does.
here=$(dirname "$0")
echo "$@" >> "$here/submitted"
script=${!#}
last=
for word in "$@"; do case $word in --array=0-*) last=${word#--array=0-} ;; --output=*) log=${word#--output=} ;; esac; done
export SLURM_CPUS_PER_TASK=1 SLURM_ARRAY_JOB_ID=7
if [ -z "$last" ]; then bash "$script" > "$log" 2>&1; else
  for ((task = 0; task <= last; task++)); do SLURM_ARRAY_TASK_ID=$task bash "$script" > "${log/\\%a/$task}" 2>&1; done
fi
echo "$(wc -l < "$here/submitted");cluster"
"""


class Slurm(unittest.TestCase):
    def test_an_array_and_its_table(self):
        with tempfile.TemporaryDirectory(prefix="hfrac studies ") as top:
            folder = pathlib.Path(top)
            study = support.write_study(folder, 5)
            out = folder / "out"
            bare = support.hfrac("sweep", study, "-o", out, "--slurm", env={**os.environ, "PATH": str(folder)})
            self.assertEqual(bare.returncode, 2)
            self.assertIn("there is no sbatch", bare.stderr)
            (folder / "sbatch").write_text(SBATCH)
            (folder / "sbatch").chmod(0o755)
            environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
            words = ("--slurm", "--runs-per-job", "2", "--minutes", "5", "--sbatch=--account=mine")
            done = support.hfrac("sweep", study, "-o", out, *words, env=environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("job 1: 5 runs in 3 tasks of up to 2", done.stdout)
            array, table = (folder / "submitted").read_text().splitlines()
            for word in ("--parsable", "--array=0-2", "--cpus-per-task=1", "--time=5", "--account=mine"):
                self.assertIn(word, array)
            self.assertIn("--dependency=afterany:1", table)
            self.assertEqual((out / "slurm/parts.txt").read_text(), "0-1\n2-3\n4\n")
            self.assertIn("#SBATCH --requeue", (out / "slurm/task.sh").read_text())
            logs = "".join(path.read_text() for path in (out / "slurm").glob("*.log"))
            self.assertTrue((out / "table.csv").exists(), logs)
            self.assertEqual((out / "table.csv").read_text().count(",done,"), 5, logs)

            (out / "runs/00001/result.json").unlink()
            (out / "runs/00004/result.json").unlink()
            again = support.hfrac("sweep", study, "-o", out, *words, env=environment)
            self.assertIn("2 runs in 1 tasks", again.stdout)
            self.assertEqual((out / "slurm/parts.txt").read_text(), "1,4\n")
            self.assertTrue((out / "runs/00004/result.json").exists())

    def test_numbers_of_runs(self):
        from hfrac.study.slurm import StudyError, indices, ranges
        self.assertEqual(indices("0-2,5", 6), [0, 1, 2, 5])
        self.assertEqual(ranges([0, 1, 2, 5]), "0-2,5")
        for wrong in ("", "a", "0-6", "3-2"):
            with self.assertRaises(StudyError):
                indices(wrong, 6)

    def test_the_script_puts_itself_back_into_the_queue(self):
        """USR1, as Slurm sends it before the time is over: the study is asked to end, then scontrol is called."""
        from hfrac.study.slurm import TASK
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            folder = pathlib.Path(top)
            (folder / "parts.txt").write_text("0\n")
            (folder / "python").write_text("#!/bin/bash\ntrap 'echo ended > ended; exit 130' TERM\n: > began\nwhile :; do sleep 0.05; done\n")
            (folder / "scontrol").write_text("#!/bin/bash\necho \"$@\" > asked\n")
            for name in ("python", "scontrol"):
                (folder / name).chmod(0o755)
            (folder / "task.sh").write_text(TASK.format(parts=folder / "parts.txt", command="hfrac", path=top, python=folder / "python", study="s",
                                                        folder="o", retry=""))
            task = subprocess.Popen(["bash", folder / "task.sh"], cwd=top, env={**os.environ, "PATH": f"{top}:{os.environ['PATH']}",
                                                                                "SLURM_ARRAY_TASK_ID": "0", "SLURM_ARRAY_JOB_ID": "7"})
            while not (folder / "began").exists():
                pass
            task.send_signal(10)
            task.wait(timeout=30)
            self.assertEqual((folder / "ended").read_text(), "ended\n")
            self.assertEqual((folder / "asked").read_text(), "requeue 7_0\n")


if __name__ == "__main__":
    unittest.main()
