"""hfrac new: cases to begin with are the examples, pass hfrac check, and replace nothing unasked."""
import pathlib
import re
import tempfile
import unittest

from hfrac_runs import hfrac

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def purposes():
    return re.findall(r"^  ([a-z-]+) {2,}\S", hfrac("new", "--help").stdout.split("Purposes:")[1], re.M)


class New(unittest.TestCase):
    def test_every_purpose_is_an_example_that_can_be_run(self):
        texts = {path.read_text() for path in EXAMPLES.rglob("*.toml")}
        self.assertIn("fracture", purposes())
        self.assertGreater(len(purposes()), 5)
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
            for name in purposes():
                with self.subTest(name):
                    file = pathlib.Path(top, f"{name}.toml")
                    self.assertEqual(hfrac("new", name, "-o", file).returncode, 0)
                    self.assertIn(file.read_text(), texts)
                    checked = hfrac("check", file)
                    if name == "record-study":
                        self.assertEqual(checked.returncode, 2)
                        self.assertIn(f"is a study: hfrac sweep {file}, or hfrac match {file} (docs/studies.md#the-study-file)", checked.stderr)
                    else:
                        self.assertEqual(checked.returncode, 0, checked.stderr)
                    self.assertEqual(hfrac("new", name).stdout, file.read_text())

    def test_a_file_that_is_there_stays(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-e2e-") as top:
            file = pathlib.Path(top, "case.toml")
            file.write_text("mine")
            refused = hfrac("new", "smoke", "-o", file)
            self.assertEqual(refused.returncode, 2)
            self.assertIn("is there already", refused.stderr)
            self.assertEqual(file.read_text(), "mine")
            self.assertEqual(hfrac("new", "smoke", "-o", file, "--overwrite").returncode, 0)
            self.assertIn("[[well]]", file.read_text())
            nowhere = hfrac("new", "smoke", "-o", pathlib.Path(top, "none", "case.toml"))
            self.assertEqual(nowhere.returncode, 2)
            self.assertIn("cannot be written", nowhere.stderr)

    def test_an_unknown_purpose_is_told_the_known_ones(self):
        refused = hfrac("new", "fractur")
        self.assertEqual(refused.returncode, 2)
        for name in purposes():
            self.assertIn(name, refused.stderr)


if __name__ == "__main__":
    unittest.main()
