"""A run folder opens in Debian's own ParaView. The argument is a folder for its unpacked packages."""
import pathlib
import subprocess
import sys
import tempfile

from hfrac_runs import run_case

with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
    done = run_case(pathlib.Path(top) / "run", "--quiet")
    assert done.returncode == 0, done.stderr
    script = pathlib.Path(__file__).with_name("paraview_check.sh")
    sys.exit(subprocess.run([script, pathlib.Path(top) / "run", sys.argv[1]], check=False).returncode)
