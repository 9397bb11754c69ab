"""A small case, and programs over several processes of MPI."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
HFRAC = os.environ["HFRAC_COMMAND"]
MPIEXEC = os.environ["MPIEXEC"]
CASE = """
title = "a hole under pressure"
[packing]
disc_count = 2000
[stress]
sigma_Hmax = 33e6
sigma_hmin = 28e6
[stepping]
steps = 6
flow_step = 1e-2
[output]
every = 2
checkpoint_steps = 2
[[well]]
radius = 10.0
pressure = 65e6
"""
# The paper's block with effective stresses, flow and equilibrium solved together.
COUPLED = """
title = "coupled, {seed}"
[model]
width = {width}
height = {width}
seed = {seed}
[packing]
method = "{method}"
disc_count = {discs}
[stress]
convention = "effective"
sigma_Hmax = 0.0
sigma_hmin = 0.0
[boundary]
kind = "walls"
[solver]
kind = "quasi-static"
factor = "{factor}"
tolerance = {tolerance}
[stepping]
mode = "coupled"
flow_step = {flow_step}
steps = {steps}
[output]
every = {steps}
[[well]]
radius = {radius}
pressure = {pressure}
"""
# Open MPI asks root twice, and keeps more ranks than cores from spinning; MPICH knows none of it.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_btl="self,vader", OMPI_MCA_plm="isolated")


def over(ranks, *command):
    return [MPIEXEC, "-n", str(ranks), *map(str, command)]


def run(command, **options):
    return subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=300, **options)


class OverRanks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.case = self.folder / "case.toml"
        self.case.write_text(CASE)
