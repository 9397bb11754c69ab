#!/usr/bin/python3
"""One simulation over several processes: the same files as one process writes, on any number, killed or stopped and gone on with on
another number; no process waits for one that has gone."""
import os
import re
import signal
import subprocess
import sys
import time
import unittest

from over_ranks import ENVIRONMENT, HFRAC, OverRanks, over, run


class Mpi(OverRanks):
    def alone(self, *more):
        done = run([HFRAC, "run", self.case, "-o", self.folder / "alone", "-q", *more])
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / "alone"

    def same(self, one, other):
        """All of a run's results, but for what tells of time and place."""
        names = sorted(p.name for p in one.iterdir() if p.suffix in (".csv", ".vtu", ".pvtu", ".pvd"))
        self.assertIn("cracks.csv", names)
        self.assertEqual(names, sorted(p.name for p in other.iterdir() if p.suffix in (".csv", ".vtu", ".pvtu", ".pvd")))
        for name in names:
            self.assertEqual((one / name).read_bytes(), (other / name).read_bytes(), f"{name} in {other.name}")

    def test_any_number_of_processes_writes_the_same_run(self):
        alone = self.alone()
        self.assertGreater(len((alone / "cracks.csv").read_text().splitlines()), 3)
        for ranks in (2, 3):
            done = run(over(ranks, HFRAC, "run", self.case, "-o", self.folder / f"on-{ranks}", "--workers", 1))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.same(alone, self.folder / f"on-{ranks}")
            # One of them speaks.
            self.assertEqual(done.stderr.count("will write"), 1, done.stderr)

    def test_processes_write_pieces_side_by_side_and_any_number_goes_on(self):
        text = self.case.read_text()
        for pieces in (2, 5):
            case = self.folder / f"pieces-{pieces}.toml"
            case.write_text(text.replace("[output]", f"[output]\npieces = {pieces}"))
            alone = self.folder / f"alone-{pieces}"
            done = run([HFRAC, "run", case, "-o", alone, "-q"])
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue((alone / f"flow_00006_{pieces - 1:04}.vtu").is_file())
            folder = self.folder / f"cut-{pieces}"
            done = run(over(3, HFRAC, "run", case, "-o", folder, "-q", "--steps", 3))
            self.assertEqual(done.returncode, 0, done.stderr)
            done = run(over(2, HFRAC, "resume", folder, "-q", "--steps", 6))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.same(alone, folder)

    def test_a_piece_that_one_cannot_write_ends_all(self):
        case, folder = self.folder / "pieces.toml", self.folder / "full"
        case.write_text(self.case.read_text().replace("[output]", "[output]\npieces = 2"))
        (folder / "bonds_00002_0001.vtu" / "in the way").mkdir(parents=True)  # the second one's to write
        done = run(over(2, HFRAC, "run", case, "-o", folder, "-q"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("could not write its pieces", done.stderr)
        self.assertIn("discs_00000.pvtu", (folder / "discs.pvd").read_text())
        self.assertNotIn("discs_00002", (folder / "discs.pvd").read_text())

    def test_a_killed_process_ends_all_and_the_run_goes_on_on_another_number(self):
        alone = self.alone()
        folder = self.folder / "killed"
        process = subprocess.Popen(over(3, HFRAC, "run", self.case, "-o", folder, "-q"), env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and not list(folder.glob("checkpoint*")):
            time.sleep(0.01)
        children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()
        self.assertTrue(children)
        os.kill(int(children[-1]), signal.SIGKILL)
        began = time.monotonic()
        self.assertNotEqual(process.wait(timeout=30), 0)
        self.assertLess(time.monotonic() - began, 30)
        done = run(over(2, HFRAC, "resume", folder, "-q"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.same(alone, folder)

    def test_all_begin_from_a_packed_model(self):
        alone = self.alone()
        model, case = self.folder / "rock.model", self.folder / "packed.toml"
        done = run([HFRAC, "pack", self.case, "-o", model, "-q"])
        self.assertEqual(done.returncode, 0, done.stderr)
        case.write_text(self.case.read_text().replace("[packing]", f'[packing]\nfile = "{model}"', 1))
        done = run(over(3, HFRAC, "run", case, "-o", self.folder / "packed", "-q"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.same(alone, self.folder / "packed")
        done = run(over(2, HFRAC, "pack", self.case, "-o", model, "-q"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("start it without mpirun", done.stderr)

    def test_writing_takes_the_first_process_no_more_than_docs_scale_says(self):
        discs, model = 20000, self.folder / "rock.model"
        text = self.case.read_text().replace("disc_count = 2000", f"disc_count = {discs}")
        self.case.write_text(text.replace("[output]\nevery = 2\ncheckpoint_steps = 2", "[output]\nevery = 1"))
        self.assertEqual(run([HFRAC, "pack", self.case, "-o", model, "-q"]).returncode, 0)
        self.case.write_text(self.case.read_text().replace("[packing]", f'[packing]\nfile = "{model}"', 1))
        tell = ("import os, resource, subprocess, sys; code = subprocess.run(sys.argv[1:]).returncode; "
                "print('most', os.environ.get('OMPI_COMM_WORLD_RANK'), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss); sys.exit(code)")
        done = run(over(2, sys.executable, "-c", tell, HFRAC, "run", self.case, "-o", self.folder / "run", "-q", "--steps", 2, "--workers", 1))
        self.assertEqual(done.returncode, 0, done.stderr)
        most = {int(rank): 1024 * int(size) for rank, size in re.findall(r"most (\d) (\d+)", done.stdout)}
        self.assertLess(most[0] - most[1], 500 * discs + 4e6, done.stdout)

    def test_what_the_first_process_refuses_ends_all(self):
        self.alone()
        done = run(over(2, HFRAC, "run", self.case, "-o", self.folder / "alone"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("already holds", done.stderr)

    def test_a_program_in_c_gives_its_communicators(self):
        done = run(over(4, os.environ["HFRAC_MPI_PROGRAM"], 2))
        self.assertEqual(done.returncode, 0, done.stderr)
        hashes = done.stdout.split()
        self.assertEqual(len(hashes), 8)
        self.assertEqual(len(set(hashes)), 1, done.stdout)

    def test_the_command_takes_one_model_for_a_machine(self):
        alone, folder = self.alone(), self.folder / "one-model"
        done = run(over(3, HFRAC, "run", self.case, "-o", folder, "--one-model", "--steps", 3))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("will write"), 1, done.stderr)
        done = run(over(2, HFRAC, "resume", folder, "--one-model", "-q", "--steps", 6))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.same(alone, folder)
        done = run(over(2, HFRAC, "run", self.case, "-o", folder, "--one-model"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("already holds", done.stderr)
        petsc = self.folder / "petsc.toml"
        petsc.write_text(self.case.read_text() + "[flow]\nsolver = \"petsc\"\n")
        done = run(over(2, HFRAC, "run", petsc, "-o", self.folder / "none", "--one-model"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--one-model", done.stderr)

    def test_ranks_of_a_machine_have_one_model(self):
        alone = re.search(r"fracture of ([\d.]+) m", run([os.environ["HFRAC_FIRST"], self.case]).stdout).group(1)
        done = run(over(3, os.environ["HFRAC_ONE_MODEL"], self.case))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(done.stdout.splitlines()), [f"rank {rank}, of 3 on its machine: fracture of {alone} m" for rank in range(3)])
        (self.folder / "bad.toml").write_text("[packing]\ndisc_count = -1\n")
        done = run(over(2, os.environ["HFRAC_ONE_MODEL"], self.folder / "bad.toml"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("disc_count", done.stderr)

    def test_the_others_are_told_which_process_gave_up_and_why(self):
        done = run(over(3, os.environ["HFRAC_MPI_PROGRAM"], "fail"))
        self.assertEqual(done.stdout.splitlines(), ["2: no room"] * 2, done.stderr)

    def test_a_program_in_fortran_gives_its_communicator(self):
        program = os.environ.get("HFRAC_MPI_FORTRAN")
        if not program:
            self.skipTest("no Fortran compiler, or no MPI for it")
        hashes = run(over(3, program)).stdout.split()
        self.assertEqual(len(hashes), 3)
        self.assertEqual(len(set(hashes)), 1)
        self.assertEqual(run(over(4, os.environ["HFRAC_MPI_PROGRAM"], 2)).stdout.split()[0].upper(), hashes[0])

    def test_python_takes_a_communicator_of_mpi4py(self):
        try:
            import mpi4py  # noqa: F401
        except ImportError:
            self.skipTest("python3-mpi4py is not installed")
        program = self.folder / "program.py"
        program.write_text(f"""
from mpi4py import MPI
import hfrac
sim = hfrac.Simulation({str(self.case)!r}, comm=MPI.COMM_WORLD)
sim.step(2)
print(f"{{sim.state_hash}}\\n", end="", flush=True)
""")
        hashes = run(over(2, sys.executable, program)).stdout.split()
        self.assertEqual(len(hashes), 2)
        self.assertEqual(len(set(hashes)), 1)
        alone = run([sys.executable, program]).stdout.split()
        self.assertEqual(hashes[:1], alone)


if __name__ == "__main__":
    unittest.main(verbosity=2)
