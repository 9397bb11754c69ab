"""examples/paper/run --fast as a user runs it: every run is there, every figure is drawn, every claim is answered."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples/paper/workflow"))
import families
import judge  # noqa: F401  brings the claims
from claims import CLAIMS
from figures import CHARTS
from measured import Measured


class Fast(unittest.TestCase):
    def test_from_cases_to_verdict(self):
        out = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-paper-"))
        self.addCleanup(shutil.rmtree, out, ignore_errors=True)
        done = subprocess.run(
            [ROOT / "examples/paper/run", "--fast"],
            capture_output=True,
            text=True,
            env=dict(os.environ, HFRAC=os.environ["HFRAC_COMMAND"], HFRAC_PAPER_OUT=str(out)),
        )
        self.assertEqual(done.returncode, 0, done.stderr[-3000:])
        data = Measured.read(out / "measured.csv", families.expand("fast")[1])
        self.assertEqual(data.lacking(), [])
        for row in data.rows.values():
            self.assertLess(abs(float(row["fluid_error_m2"])), 1e-6, row["run"])
        verdict = (out / "paper-reproduction.md").read_text()
        for claim in CLAIMS:
            self.assertIn(claim.words, verdict)
        self.assertIn("no sample", verdict)
        for name in CHARTS:
            if name.startswith("beyond"):
                continue  # changed physics is run by the full set only
            self.assertEqual((out / "figures" / f"{name}.png").read_bytes()[:4], b"\x89PNG")
        for name in (
            "figure-03.png",
            "figure-04.png",
            "figure-04.webp",
            "figure-04-60-MPa.webp",
            "figure-05.png",
            *(f"figure-06-{pressure}-MPa.png" for pressure in (30, 60)),
        ):
            self.assertTrue((out / "figures" / name).stat().st_size > 1000, name)


if __name__ == "__main__":
    if shutil.which("snakemake", path="/usr/bin") is None:
        print("snakemake is not installed: cmake/install-packages workflow")
        sys.exit(77)
    unittest.main()
