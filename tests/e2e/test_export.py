"""What `hfrac export` writes of a finished run: the same numbers as the run itself, in tables anything can read."""
import csv
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import hfrac, names, run_case, summary

TABLES = ["bonds.csv", "cracks.csv", "discs.csv", "domains.csv", "fractures.csv"]
CELLS = ["cells.csv", "multipliers.grdecl", "permeability.grdecl"]
LOOSE = """[model]
[stress]
convention = 'effective'
sigma_Hmax = 0.0
sigma_hmin = 0.0
[[well]]
radius = 8.0
pressure = 30e6
"""


def rows(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-export-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        cls.folder = cls.top / "run"
        # Cells that cover the model of 100 m x 100 m exactly, in the run itself and in the export.
        done = run_case(cls.folder, "--steps", 6, "--grid", 5, 4, 20, 25)
        assert done.returncode == 0, done.stderr
        cls.made = hfrac("export", cls.folder, "--cells", "5x4")
        assert cls.made.returncode == 0, cls.made.stderr
        cls.out = cls.folder / "export"

    def test_every_table_is_there(self):
        self.assertEqual(names(self.out), sorted(TABLES + CELLS))
        self.assertIn("export", self.made.stdout)

    def test_tables_are_those_of_the_run(self):
        for name in ["cracks.csv", "fractures.csv", *CELLS]:
            with self.subTest(name=name):
                self.assertEqual((self.out / name).read_text(), (self.folder / name).read_text())

    def test_arrays_have_units_and_as_many_lines_as_there_are_things(self):
        state = summary(self.folder)["state"]
        discs, bonds, domains = (rows(self.out / f"{name}.csv") for name in ("discs", "bonds", "domains"))
        self.assertEqual([len(discs), len(bonds)], [state["disc_count"], state["bond_count"]])
        self.assertGreater(len(domains), 1)
        for table, columns in (
            (discs, "disc x_m y_m radius_m displacement_x_m rotation_rad velocity_x_m_per_s stress_xx_Pa intact_bonds"),
            (bonds, "bond disc_0 disc_1 state normal_force_N moment_N_m gap_m domain_0 domain_1 aperture_m flow_m2_per_s"),
            (domains, "domain pressure_Pa volume_m2 x_m y_m kind"),
        ):
            for column in columns.split():
                self.assertIn(column, table[0])
        broken = [bond for bond in bonds if bond["state"] != "0"]
        self.assertEqual(len(broken), state["crack_count"])
        self.assertEqual({int(crack["bond_id"]) for crack in rows(self.out / "cracks.csv")},
                         {int(bond["bond"]) for bond in broken})

    def test_square_cells_by_their_size(self):
        out = self.top / "coarse"
        done = hfrac("export", self.folder, "-o", out, "--dx", 33)
        self.assertEqual(done.returncode, 0, done.stderr)
        cells = rows(out / "cells.csv")
        self.assertEqual(len(cells), 9)
        self.assertAlmostEqual(sum(float(cell["area_m2"]) for cell in cells), 1e4)
        for column in ("kxx_m2", "kyy_m2", "kxy_m2", "fracture_porosity", "leak_off_m2_per_s"):
            self.assertIn(column, cells[0])
        plain = self.top / "plain"
        self.assertEqual(hfrac("export", self.folder, "-o", plain).returncode, 0)
        self.assertEqual(names(plain), TABLES, "no cells without a grid")

    def test_a_model_starts_from_the_tables(self):
        """The cracks of one run are the joints of the next: its discs and intact bonds make a model, which exports alike."""
        case = self.top / "loose.toml"
        case.write_text(LOOSE)
        jointed = self.top / "jointed"
        done = hfrac("run", case, "-o", jointed, "--steps", 1, "--discs", self.out / "discs.csv",
                     "--bonds", self.out / "bonds.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("given_bonds.csv", names(jointed))
        intact = sum(bond["state"] == "0" for bond in rows(self.out / "bonds.csv"))
        self.assertEqual(len(rows(jointed / "given_bonds.csv")), intact)
        again = hfrac("export", jointed)
        self.assertEqual(again.returncode, 0, again.stderr)
        states = [bond["state"] for bond in rows(jointed / "export" / "bonds.csv")]
        self.assertGreater(states.count("3"), 0)
        self.assertGreater(states.count("0"), 0)

    def test_what_cannot_be_exported_is_refused(self):
        for arguments, word in (((self.top / "nowhere",), "case.toml"), ((self.folder, "--cells", "5"), "NXxNY"),
                                ((self.folder, "--cells", "0x4"), "NXxNY"), ((self.folder, "--cells", "5x4x3"), "NXxNY"),
                                ((self.folder, "--dx", -1), "--dx"), ((self.folder, "--cells", "5x4", "--dx", 3), "--dx")):
            with self.subTest(arguments=arguments):
                done = hfrac("export", *arguments)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(word, done.stderr)
        broken = self.top / "broken"
        shutil.copytree(self.folder, broken)
        (broken / "state.hfrac").write_bytes((self.folder / "state.hfrac").read_bytes()[:-8])
        done = hfrac("export", broken, "-o", self.top / "never")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("state.hfrac", done.stderr)
        (broken / "state.hfrac").unlink()
        self.assertIn("state.hfrac", hfrac("export", broken, "-o", self.top / "never").stderr)
        shutil.copy(self.folder / "state.hfrac", broken)
        text = (broken / "summary.json").read_text()
        (broken / "summary.json").write_text(text.replace(summary(broken)["state_hash"], "0" * 16))
        self.assertIn("state hash", hfrac("export", broken, "-o", self.top / "never").stderr)
        self.assertFalse((self.top / "never").exists(), "nothing is written")

    def test_bad_bond_files_are_refused(self):
        bad = self.top / "bad.csv"
        case = self.top / "loose.toml"
        case.write_text(LOOSE)
        for text, word in (("disc_0\n1\n", "disc_1"), ("disc_0,disc_1\n1,x\n", ":2:"), ("disc_0,disc_1\n1,2.5\n", "whole"),
                           ("disc_0,disc_1\n", "no bonds"), ("disc_0,disc_1\n1,1\n", "itself"),
                           ("disc_0,disc_1\n1,-4\n", "-4")):
            bad.write_text(text)
            done = hfrac("run", case, "-o", self.top / "never", "--discs", self.out / "discs.csv", "--bonds", bad)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(word, done.stderr)
        self.assertNotEqual(hfrac("run", case, "-o", self.top / "never", "--bonds", bad).returncode, 0)


unittest.main()
