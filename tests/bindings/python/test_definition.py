"""Options by keyword, by section, by key and by case file."""
import os
import pathlib
import tempfile
import unittest

import hfrac
from support import CASE


class Definition(unittest.TestCase):
    def test_table_of_options(self):
        table = {option.key: option for option in hfrac.options()}
        width = table["model.width"]
        self.assertEqual((width.type, width.unit, width.default, width.keyword), ("real", "m", 100.0, "model_width"))
        self.assertEqual(table["model.seed"].default, 1)
        self.assertEqual(table["boundary.kind"].choices, ("stress", "walls", "infinite"))
        self.assertEqual(table["boundary.kind"].default, "stress")
        self.assertTrue(all(option.help for option in table.values()))

    def test_every_keyword_sets_its_key(self):
        for option in hfrac.options():
            definition = hfrac.Definition(**{option.keyword: option.default})
            self.assertEqual(definition.get(option.key), option.default)
            self.assertEqual(type(definition.get(option.key)), type(option.default))

    def test_three_ways_to_the_same(self):
        flat = hfrac.Definition(bond_tensile_strength=40e6, packing_disc_count=500)
        nested = hfrac.Definition(bond={"tensile_strength": 40e6}, packing={"disc_count": 500})
        keyed = hfrac.Definition()
        keyed.set("bond.tensile_strength", 40e6)
        keyed.set("packing.disc_count", 500)
        self.assertEqual(flat.text, nested.text)
        self.assertEqual(flat.text, keyed.text)
        self.assertEqual(flat.options["packing.disc_count"], 500)

    def test_lists_of_any_length(self):
        wells = [{"x": 4.0 + 3.0 * (k % 30), "y": 4.0 + 3.0 * (k // 30), "radius": 0.5, "rate": 1e-6 * k, "control": "rate"} for k in range(200)]
        joints = [{"x1": 10.0, "y1": 0.5 * (k + 1), "x2": 90.0, "y2": 0.5 * (k + 1), "friction": 0.25} for k in range(150)]
        schedule = [{"well": k % 200, "time": 1.0 + k // 200, "value": 1e-6, "control": "rate"} for k in range(500)]
        definition = hfrac.Definition(wells=wells, joints=joints, schedule=schedule, packing_disc_count=200000)
        definition.check()
        counts = [definition.get(f"{kind}_count") for kind in ("well", "joint", "schedule")]
        self.assertEqual(counts, [200, 150, 500])
        copied = definition.copy()
        definition.set("well_count", 0)
        self.assertEqual((definition.well_count, copied.well_count), (0, 200))
        self.assertEqual(copied.wells[199]["rate"], 1e-6 * 199)
        self.assertEqual(copied.joints[149]["friction"], 0.25)
        self.assertEqual(copied.schedule[499], {**schedule[499], "fluid": "same"})
        copied.set("schedule[499].time", 1.0)
        with self.assertRaisesRegex(hfrac.ModelError, r"schedule\[499\]"):
            copied.check()

    def test_disc_radii(self):
        uniform, graded = hfrac.Definition(), hfrac.Definition(packing_coarsening=4.0)
        self.assertEqual(*uniform.disc_radii)
        fine, coarsest = graded.disc_radii
        self.assertLess(fine, uniform.disc_radii[0])
        self.assertAlmostEqual(coarsest / fine, 4.0)

    def test_a_packed_model(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rock.model")
            small = {"packing_disc_count": 300, "packing_residual": 1e-3}
            hfrac.Definition(**small).pack(path)
            begun = hfrac.Definition(packing_file=path, **small)
            self.assertEqual(begun.get("packing.file"), path)
            with hfrac.Simulation(begun) as one, hfrac.Simulation(hfrac.Definition(**small)) as other:
                self.assertEqual(one.state_hash, other.state_hash)
            begun.set("stress.sigma_hmin", 26e6)
            with self.assertRaisesRegex(hfrac.ModelError, "stress.sigma_hmin = 2.6e7 Pa, but"):
                begun.check()

    def test_wells(self):
        definition = hfrac.Definition(
            model_width=80, wells=[{"radius": 5, "pressure": 40e6}, {"x": 10, "y": 20, "radius": 2, "control": "rate"}]
        )
        first, second = definition.wells
        self.assertEqual((first["x"], first["y"], first["control"]), (40.0, 50.0, "pressure"))
        self.assertEqual((second["x"], second["y"], second["control"]), (10.0, 20.0, "rate"))

    def test_joints_and_schedule(self):
        joint = {"x1": 10.0, "y1": 5.0, "x2": 60.0, "y2": 5.0, "friction": 0.6, "state": "broken"}
        entry = {"well": 0, "time": 60.0, "value": 0.0, "control": "rate", "fluid": "second"}
        definition = hfrac.Definition(CASE, joints=[joint], schedule=[entry])
        (read,) = definition.joints
        self.assertEqual(read, {**dict.fromkeys(read, 0.0), **joint, "tensile_factor": 1.0, "shear_factor": 1.0})
        self.assertEqual(definition.schedule, [entry])
        self.assertEqual((definition.get("joint_count"), definition.get("schedule_count")), (1, 1))
        self.assertIn("[[well.schedule]]", definition.text)
        self.assertEqual([option.key for option in hfrac.schedule_options()], list(entry))
        self.assertIn("tensile_factor", [option.key for option in hfrac.joint_options()])

    def test_traces_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "traces.csv")
            with open(path, "w", encoding="utf-8") as out:
                out.write("START_X,START_Y,END_X,END_Y\n1,2,3,4\n5,6,7,8\n")
            definition = hfrac.Definition()
            definition.add_traces(path)
            self.assertEqual([joint["y2"] for joint in definition.joints], [4.0, 8.0])
            with self.assertRaisesRegex(hfrac.CaseFileError, "other.csv"):
                definition.add_traces(os.path.join(folder, "other.csv"))

    def test_a_record_in_its_units(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "record.csv")
            with open(path, "w", encoding="utf-8") as out:
                out.write("time_min,rate_L_s\n0,5\n2,0\n")
            first, last = hfrac.read_record(path, thickness=50.0)
            self.assertAlmostEqual(first.rate, 1e-4, delta=1e-16)
            self.assertEqual((first.time, last.time, last.rate), (0.0, 120.0, 0.0))
            self.assertNotEqual(first.pressure, first.pressure)
            with self.assertRaisesRegex(hfrac.CaseFileError, "other.csv"):
                hfrac.read_record(os.path.join(folder, "other.csv"))

    def test_case_file_and_keywords_on_top(self):
        definition = hfrac.Definition(CASE, model_seed=3, wells=[{"pressure": 30e6}], title="another")
        self.assertEqual(definition.get("model.seed"), 3)
        self.assertEqual(definition.get("packing.disc_count"), 500)
        self.assertEqual(definition.get("well_count"), 1)
        self.assertEqual((definition.wells[0]["pressure"], definition.wells[0]["radius"]), (30e6, 8.5))
        self.assertEqual((definition.title, definition.get("title")), ("another", "another"))

    def test_text_is_a_case_file(self):
        definition = hfrac.Definition(CASE)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "söme case.toml")
            path.write_text(definition.text, encoding="utf-8")
            self.assertEqual(hfrac.Definition(path).text, definition.text)

    def test_a_copy_is_independent(self):
        definition = hfrac.Definition(CASE)
        copy = definition.copy()
        copy.set("model.seed", 99)
        self.assertEqual(definition.get("model.seed"), 4)
        self.assertEqual(copy.title, definition.title)

    def test_check_names_the_fix(self):
        with self.assertRaisesRegex(hfrac.HfracError, "well"):
            hfrac.Definition(wells=[{"radius": 1000.0}]).check()
        hfrac.Definition(CASE).check()
        hfrac.Definition(CASE).check(CASE)

    def test_errors(self):
        for options, error, text in [
            ({"packing_disk_count": 3}, hfrac.UnknownKeyError, "did you mean packing.disc_count"),
            ({"bond": {"tensile_strenth": 1}}, hfrac.UnknownKeyError, "did you mean bond.tensile_strength"),
            ({"wells": [{"radios": 1}]}, hfrac.UnknownKeyError, "radius"),
            ({"fluid_viscosity": -1}, ValueError, "fluid.viscosity = -1"),
            ({"fluid_viscosity": float("nan")}, hfrac.ArgumentError, "fluid.viscosity"),
            ({"model_seed": 10**30}, hfrac.ArgumentError, "model.seed"),
            ({"boundary_kind": "wall"}, hfrac.ArgumentError, "stress, walls or infinite"),
            ({"case": "/nonexistent.toml"}, hfrac.CaseFileError, "nonexistent"),
            ({"title": "x" * 500}, hfrac.ArgumentError, "title"),
        ]:
            with self.subTest(options=options), self.assertRaisesRegex(error, text):
                hfrac.Definition(**options)

    def test_repr_tells_what_differs_from_the_defaults(self):
        self.assertIn("model.seed=4", repr(hfrac.Definition(CASE)))
        self.assertIn("all defaults", repr(hfrac.Definition()))
