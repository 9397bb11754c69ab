"""Snapshots in pieces (output.pieces): what they hold is what one file holds, for everybody who reads them."""
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import CASE, check_whole, entries, hfrac, names

PIECES = 3
LARGE = ("discs", "bonds", "flow")


class Pieces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-pieces-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        text = pathlib.Path(CASE).read_text()
        every = "[output]\nevery = 5"
        assert every in text
        cls.cases = {}
        for count in (1, PIECES):
            cls.cases[count] = cls.top / f"{count}.toml"
            cls.cases[count].write_text(text.replace(every, f"[output]\nevery = 4\ncheckpoint_steps = 4\npieces = {count}"))
            done = hfrac("run", cls.cases[count], "-o", cls.top / str(count), "--steps", 10, "-q")
            assert done.returncode == 0, done.stderr
        cls.whole, cls.cut = cls.top / "1", cls.top / str(PIECES)

    def test_each_large_file_is_so_many_and_a_list(self):
        for series in LARGE:
            self.assertEqual([file.replace(".pvtu", ".vtu") for _, file in entries(self.cut, series)],
                             [file for _, file in entries(self.whole, series)])
            for _, file in entries(self.cut, series):
                for k in range(PIECES):
                    self.assertIn(file.replace(".pvtu", f"_{k:04}.vtu"), names(self.cut))
        self.assertNotIn("cracks_00000.pvtu", names(self.cut))

    def test_vtk_reads_them(self):
        check_whole(self, self.cut)

    def test_pictures_are_the_same(self):
        for folder in (self.whole, self.cut):
            done = hfrac("render", folder)
            if "built without" in done.stderr:
                self.skipTest("no renderer")
            self.assertEqual(done.returncode, 0, done.stderr)
        pictures = names(self.whole / "pictures")
        self.assertIn("pressure.png", pictures)
        for name in pictures:
            self.assertEqual((self.whole / "pictures" / name).read_bytes(), (self.cut / "pictures" / name).read_bytes(), name)

    def test_discs_are_taken_from_them(self):
        for folder, kind in ((self.whole, "vtu"), (self.cut, "pvtu")):
            done = hfrac("run", self.cases[1], "-o", self.top / kind, "--steps", 0, "-q", "--discs", folder / f"discs_00000.{kind}")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.top / "vtu" / "given_discs.csv").read_bytes(), (self.top / "pvtu" / "given_discs.csv").read_bytes())

    def test_a_run_goes_on_and_is_cleared_away_with_all_its_pieces(self):
        folder = self.top / "on"
        shutil.copytree(self.cut, folder)
        for file in list(folder.glob("checkpoints/*00008*")):
            file.unlink()
        (folder / "state.hfrac").unlink()
        summary = (folder / "summary.json").read_text()
        (folder / "summary.json").write_text(summary.replace('"ended": "all steps taken"', '"ended": "interrupted"'))
        done = hfrac("resume", folder, "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in names(self.cut):
            if name.endswith((".vtu", ".pvtu", ".pvd", ".csv")):
                self.assertEqual((self.cut / name).read_bytes(), (folder / name).read_bytes(), name)
        done = hfrac("run", self.cases[1], "-o", folder, "--steps", 0, "--overwrite", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([name for name in names(folder) if name.endswith("pvtu") or name.endswith("_0000.vtu")], [])

    def test_a_piece_that_is_missing_is_named(self):
        folder = self.top / "lacking"
        shutil.copytree(self.cut, folder)
        (folder / "discs_00000_0001.vtu").unlink()
        done = hfrac("run", self.cases[1], "-o", self.top / "none", "--steps", 0, "--discs", folder / "discs_00000.pvtu")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("discs_00000_0001.vtu", done.stderr)

    def test_a_list_reaches_no_file_elsewhere(self):
        folder = self.top / "elsewhere"
        folder.mkdir()
        text = (self.cut / "discs_00000.pvtu").read_text()
        for place in ("../3/discs_00000_0000.vtu", str(self.cut / "discs_00000_0000.vtu"), ".."):
            (folder / "discs.pvtu").write_text(text.replace("discs_00000_0000.vtu", place))
            done = hfrac("run", self.cases[1], "-o", self.top / "none", "--steps", 0, "--discs", folder / "discs.pvtu")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("no file beside it", done.stderr)


if __name__ == "__main__":
    unittest.main()
