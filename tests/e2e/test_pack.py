"""`hfrac pack`: a model made once, and runs that begin from it: the files of a run without it, gone on with after a stop, refused where it does
not fit."""
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import hfrac

CASE = """[packing]
disc_count = 800
residual = 1e-3
[stepping]
flow_step = 1e-2
[[well]]
radius = 8.0
pressure = 60e6
"""


class Pack(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-pack-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.case = self.write("case.toml", CASE)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def from_file(self, more="", name="rock.model"):
        return self.write("from-file.toml", CASE.replace("[packing]", f'[packing]\nfile = "{name}"\n{more}'))

    def good(self, *arguments):
        done = hfrac(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def same(self, one, other):
        names = sorted(p.name for p in one.iterdir() if p.suffix in (".csv", ".vtu", ".pvd", ".hfrac"))
        self.assertIn("history.csv", names)
        for name in names:
            self.assertEqual((one / name).read_bytes(), (other / name).read_bytes(), name)

    def test_runs_begin_from_it(self):
        self.good("run", self.case, "-o", self.folder / "straight", "--steps", 4, "-q")
        done = self.good("pack", self.case, "-o", self.folder / "rock.model")
        self.assertIn("cases begin from it with packing.file", done.stderr)
        case = self.from_file()  # beside the file
        self.good("check", case)
        self.good("run", case, "-o", self.folder / "begun", "--steps", 4, "-q")
        self.same(self.folder / "straight", self.folder / "begun")
        # A run folder knows where the file is.
        self.good("run", case, "-o", self.folder / "resumed", "--steps", 2, "-q")
        self.good("resume", self.folder / "resumed", "--steps", 4, "-q")
        self.same(self.folder / "straight", self.folder / "resumed")

    def test_a_file_for_each_seed(self):
        self.good("pack", self.case, "-o", self.folder / "rock-7.model", "--seed", 7, "-q")
        text = self.from_file(name="rock-{seed}.model").read_text()
        self.good("check", self.write("seven.toml", "[model]\nseed = 7\n" + text))
        done = hfrac("check", self.write("eight.toml", "[model]\nseed = 8\n" + text))
        self.assertEqual(done.returncode, 2)
        self.assertIn("rock-8.model' cannot be read", done.stderr)

    def test_what_does_not_fit_is_said_with_its_line(self):
        self.good("pack", self.case, "-o", self.folder / "rock.model", "-q")
        text = self.from_file().read_text() + "[stress]\nsigma_hmin = 26e6\n"
        case = self.write("other.toml", text)
        for arguments in (("check", case), ("run", case, "-o", self.folder / "run", "-q")):
            done = hfrac(*arguments)
            self.assertEqual(done.returncode, 2)
            line = text.splitlines().index("sigma_hmin = 26e6") + 1
            self.assertIn(f"other.toml:{line}: stress.sigma_hmin = 2.6e7 Pa, but", done.stderr)
        self.assertFalse((self.folder / "run").exists())
        discs = self.write("discs.toml", text.replace("[packing]", '[packing]\nreuse = "discs"'))
        self.good("run", discs, "-o", self.folder / "run", "--steps", 1, "-q")
        self.good("run", self.write("own.toml", CASE + "[stress]\nsigma_hmin = 26e6\n"), "-o", self.folder / "own", "--steps", 1, "-q")
        self.same(self.folder / "run", self.folder / "own")

    def test_it_cannot_be_written_nowhere(self):
        done = hfrac("pack", self.case, "-o", self.folder / "no" / "rock.model", "-q")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be written", done.stderr)


if __name__ == "__main__":
    unittest.main()
