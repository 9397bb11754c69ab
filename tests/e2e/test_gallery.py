"""The cases of examples/gallery: short, of seed 1, and each takes its first step. Whole runs: docs/make-gallery --check-runs."""
import pathlib
import tempfile
import tomllib
import unittest

from hfrac_runs import hfrac, summary

CASES = sorted((pathlib.Path(__file__).resolve().parents[2] / "examples/gallery").glob("*.toml"))


class Gallery(unittest.TestCase):
    def test_ten_cases_of_the_first_seed(self):
        self.assertEqual(len(CASES), 10)
        for case in CASES:
            with self.subTest(case.stem):
                self.assertLess(len(case.read_text().splitlines()), 25)
                self.assertNotIn("seed", tomllib.loads(case.read_text()).get("model", {}))

    def test_each_takes_its_first_step(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
            for case in CASES:
                with self.subTest(case.stem):
                    folder = pathlib.Path(top, case.stem)
                    ran = hfrac("run", case, "-o", folder, "--steps", 1, "--quiet")
                    self.assertEqual(ran.returncode, 0, ran.stderr)
                    end = summary(folder)
                    self.assertEqual(end["state"]["step"], 1)
                    self.assertGreater(end["balance"]["injected_volume_m2"], 0)


if __name__ == "__main__":
    unittest.main()
