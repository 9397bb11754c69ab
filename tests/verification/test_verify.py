"""tests/verify: its table, its exit status, and that a case without figures is not called good."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

VERIFY = pathlib.Path(__file__).resolve().parent.parent / "verify"
PROGRAM = os.environ["HFRAC_VERIFICATION"]
FIGURE = "  {:<52} measured {:>12}  analytic {:>12}  error {:>9}  tolerance {}\n"
GOOD = FIGURE.format("a length, m", "1.01", "1", "+1.00e-02", "5.0e-02")


def verify(*arguments, program=PROGRAM):
    return subprocess.run([VERIFY, *arguments, "--program", program], capture_output=True, text=True)


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="hfrac-verify-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def pretend(self, *tests, status=0):
        """A program that prints what GoogleTest prints of tests (name, text, end)."""
        text = "".join(f"[ RUN      ] {name}\n{said}{end} {name} (3 ms)\n" for name, said, end in tests)
        program = self.folder / "program"
        program.write_text(f"#!{sys.executable}\nprint({text!r}, end='')\nraise SystemExit({status})\n")
        program.chmod(0o755)
        return program

    def row(self, done, case):
        rows = [line for line in done.stdout.split("verdict\n")[1].splitlines() if line.split()[0] == case]
        self.assertEqual(len(rows), 1, done.stdout)
        return rows[0]

    def test_shows_the_figure_nearest_to_its_tolerance(self):
        near = FIGURE.format("a width, mm", "0.04", "0", "+4.00e-02", "5.0e-02 abs")
        done = verify("V7", program=self.pretend(("V7SneddonSmoke.One", GOOD + near, "[       OK ]")))
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("a width, mm", " 0.04 ", "+4.00e-02", "5.0e-02  abs", "good"):
            self.assertIn(part, self.row(done, "V7"))

    def test_a_case_without_figures_fails(self):
        done = verify("--all", program=self.pretend(("V1Bond.One", GOOD, "[       OK ]"), ("V2Block.One", "", "[       OK ]")))
        self.assertEqual(done.returncode, 1)
        self.assertIn("NO FIGURE", self.row(done, "V2"))
        self.assertIn("no figure was printed by V2", done.stderr)
        self.assertIn("good", self.row(done, "V1"))

    def test_a_failed_case_fails(self):
        done = verify("--all", program=self.pretend(("V1Bond.One", GOOD, "[  FAILED  ]"), status=1))
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAILED", self.row(done, "V1"))

    def test_not_a_number_is_the_worst_figure(self):
        lost = FIGURE.format("an exponent", "nan", "1", "nan", "1.0e-01")
        done = verify("V1", program=self.pretend(("V1Bond.One", GOOD + lost, "[  FAILED  ]"), status=1))
        self.assertIn("an exponent", self.row(done, "V1"))

    def test_cases_are_in_the_order_of_their_numbers(self):
        done = verify("--all", program=self.pretend(*((f"{name}.One", GOOD, "[       OK ]") for name in ("V10Growth", "StressShadow", "V9Hole"))))
        self.assertEqual([line.split()[0] for line in done.stdout.split("verdict\n")[1].splitlines()], ["V9", "V10", "StressShadow"])

    def test_wrong_use(self):
        for arguments in ((), ("seven",), ("V1", "--all"), ("V1", "--smoke", "--full"), ("V99",)):
            self.assertEqual(verify(*arguments).returncode, 2, arguments)
        self.assertEqual(verify("V1", program="/no/such").returncode, 2)

    def test_the_cases_themselves(self):
        done = verify("V1", "V14", "--smoke")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for case in ("V1", "V14"):
            self.assertIn("good", self.row(done, case))

    @unittest.skipUnless("HFRAC_COMMAND" in os.environ, "the command, which draws, is not built")
    def test_leaves_curves_and_pictures(self):
        out = self.folder / "figures"
        done = verify("V1", "--smoke", "--pictures", out, "--hfrac", os.environ["HFRAC_COMMAND"])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(out / "V1.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["series"] for row in rows}, {"model", "F/A + M R/I = sigma_c"})
        pulled = max(float(row["normal force (MN)"]) for row in rows if row["series"] == "model")
        self.assertAlmostEqual(pulled, 42.5, places=3)
        self.assertTrue((out / "V1.png").read_bytes().startswith(b"\x89PNG"))


unittest.main()
