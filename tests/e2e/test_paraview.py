"""A run folder opens in Debian's own ParaView. The argument is a folder for its unpacked packages."""
import os
import pathlib
import subprocess
import sys
import tempfile

from hfrac_runs import run_case

with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
    done = run_case(pathlib.Path(top) / "run", "--quiet")
    assert done.returncode == 0, done.stderr
    run = pathlib.Path(top) / "run"
    scripts = ["paraview_check.sh"]
    if "HFRAC_RENDERS" in os.environ:
        subprocess.run([os.environ["HFRAC_COMMAND"], "render", run, "--no-movie", "--quiet"], check=True)
        scripts.append("paraview_state_check.sh")
    for script in scripts:
        done = subprocess.run([pathlib.Path(__file__).with_name(script), run, sys.argv[1]], check=False)
        if done.returncode != 0:
            sys.exit(done.returncode)
