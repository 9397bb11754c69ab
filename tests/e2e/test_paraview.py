"""A run folder opens in Debian's own ParaView, in one piece and in several. The argument is a folder for its unpacked packages."""
import os
import pathlib
import subprocess
import sys
import tempfile

from hfrac_runs import CASE, hfrac

for pieces in (1, 3):
    with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
        run, case = pathlib.Path(top) / "run", pathlib.Path(top) / "case.toml"
        case.write_text(pathlib.Path(CASE).read_text().replace("[output]", f"[output]\npieces = {pieces}"))
        done = hfrac("run", case, "-o", run, "--quiet")
        assert done.returncode == 0, done.stderr
        scripts = ["paraview_check.sh"]
        if "HFRAC_RENDERS" in os.environ:
            subprocess.run([os.environ["HFRAC_COMMAND"], "render", run, "--no-movie", "--quiet"], check=True)
            scripts.append("paraview_state_check.sh")
        for script in scripts:
            done = subprocess.run([pathlib.Path(__file__).with_name(script), run, sys.argv[1]], check=False)
            if done.returncode != 0:
                sys.exit(done.returncode)
