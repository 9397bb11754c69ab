#!/usr/bin/python3
"""The Python face of the Basic Model Interface, with the calls of the public tester (csdms/bmi-tester) in its order and what it
checks of each: control, info, time, variables, grids, values. Then what the C face says of the same model must be the same.

usage: test_bmi.py CASE BMI_TEST     BMI_TEST: the program of bmi_test.c
"""
import inspect
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from hfrac.bmi import BmiHfrac

CASE, PROGRAM = sys.argv[1:3]
LOCATIONS = ("node", "edge", "face", "none")
GRID_TYPES = ("scalar", "unstructured")


class Stage0Control(unittest.TestCase):
    def test_initialize_and_finalize_give_nothing_back(self):
        model = BmiHfrac()
        self.assertIsNone(model.initialize(CASE))
        self.assertIsNone(model.finalize())

    def test_update(self):
        model = BmiHfrac()
        model.initialize(CASE)
        self.assertIsNone(model.update())
        model.finalize()

    def test_from_any_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "case.toml")
            path.write_bytes(pathlib.Path(CASE).read_bytes())
            model = BmiHfrac()
            model.initialize(str(path))
            model.finalize()

    def test_all_of_the_standard_is_there(self):
        functions = [name for name, _ in inspect.getmembers(BmiHfrac, inspect.isfunction) if not name.startswith("_")]
        self.assertEqual(len(functions), 41 + 1, functions)  # and set_grid, beside it


class Initialized(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bmi = BmiHfrac()
        cls.bmi.initialize(CASE)

    @classmethod
    def tearDownClass(cls):
        cls.bmi.finalize()

    def names(self):
        return dict.fromkeys(self.bmi.get_input_var_names() + self.bmi.get_output_var_names())

    def grids(self):
        return sorted({self.bmi.get_var_grid(name) for name in self.names()})


class Stage1Info(Initialized):
    def test_component_name(self):
        self.assertIsInstance(self.bmi.get_component_name(), str)

    def test_var_names(self):
        for name in self.names():
            self.assertRegex(name, r"^[a-z]+([a-z0-9_~-]*[a-z0-9])?__[a-z]+([a-z0-9_-]*[a-z0-9])?$")

    def test_counts(self):
        for count, names in (
            (self.bmi.get_input_item_count(), self.bmi.get_input_var_names()),
            (self.bmi.get_output_item_count(), self.bmi.get_output_var_names()),
        ):
            self.assertIsInstance(count, int)
            self.assertIsInstance(names, tuple)
            self.assertEqual(len(names), count)


class Stage1Time(Initialized):
    def test_times(self):
        start, step = self.bmi.get_start_time(), self.bmi.get_time_step()
        now, end = self.bmi.get_current_time(), self.bmi.get_end_time()
        for value in (start, step, now, end):
            self.assertIsInstance(value, float)
        self.assertEqual(start, 0.0)
        self.assertGreater(step, 0.0)
        self.assertTrue(start <= now <= end)
        self.assertEqual(self.bmi.get_time_units(), "s")


class Stage2Variables(Initialized):
    def test_variables(self):
        for name in self.names():
            with self.subTest(name=name):
                self.assertGreater(self.bmi.get_var_itemsize(name), 0)
                self.assertGreater(self.bmi.get_var_nbytes(name), 0)
                location = self.bmi.get_var_location(name)
                self.assertIn(location, LOCATIONS)
                grid = self.bmi.get_var_grid(name)
                if self.bmi.get_grid_type(grid) == "unstructured":
                    self.assertGreater(getattr(self.bmi, f"get_grid_{location}_count")(grid), 0)
                numpy.empty(1, dtype=self.bmi.get_var_type(name))
                self.assertIsInstance(self.bmi.get_var_units(name), str)


class Stage3Grids(Initialized):
    def test_grids(self):
        for grid in self.grids():
            with self.subTest(grid=grid):
                rank, size, kind = (getattr(self.bmi, f"get_grid_{what}")(grid) for what in ("rank", "size", "type"))
                self.assertIsInstance(rank, int)
                self.assertLessEqual(rank, 3)
                self.assertIsInstance(size, int)
                self.assertGreater(size, 0)
                self.assertIn(kind, GRID_TYPES)
                if kind == "scalar":
                    self.assertEqual(rank, 0)

    def test_unstructured_grids(self):
        for grid in (g for g in self.grids() if self.bmi.get_grid_type(g) == "unstructured"):
            nodes, edges = self.bmi.get_grid_node_count(grid), self.bmi.get_grid_edge_count(grid)
            faces = self.bmi.get_grid_face_count(grid)
            for count in (nodes, edges, faces):
                self.assertIsInstance(count, int)
            if edges == 0:
                self.assertEqual(faces, 0)
            for axis in ("x", "y"):
                values = numpy.full(nodes, numpy.nan)
                self.assertIs(getattr(self.bmi, f"get_grid_{axis}")(grid, values), values)
                self.assertFalse(numpy.isnan(values).any())
            ends = numpy.full(2 * edges, -10, dtype=numpy.int32)
            self.assertIs(self.bmi.get_grid_edge_nodes(grid, ends), ends)
            self.assertTrue(((ends >= 0) & (ends < nodes)).all())
            per_face = numpy.full(faces, -1, dtype=numpy.int32)
            self.assertIs(self.bmi.get_grid_nodes_per_face(grid, per_face), per_face)
            self.assertTrue((per_face >= 3).all())
            around = numpy.full(per_face.sum(), -1, dtype=numpy.int32)
            self.assertIs(self.bmi.get_grid_face_nodes(grid, around), around)
            face_edges = numpy.full(per_face.sum(), -1, dtype=numpy.int32)
            self.assertIs(self.bmi.get_grid_face_edges(grid, face_edges), face_edges)
            at = 0
            for count in per_face:
                ring = around[at : at + count]
                for k, edge in enumerate(face_edges[at : at + count]):
                    self.assertEqual(set(ends[2 * edge : 2 * edge + 2]), {ring[k], ring[(k + 1) % count]})
                at += count


class Stage3Values(Initialized):
    def test_values_are_written(self):
        for name in self.bmi.get_output_var_names():
            with self.subTest(name=name):
                size = self.bmi.get_var_nbytes(name)
                values = numpy.frombuffer(b"\xa5" * size, dtype=self.bmi.get_var_type(name)).copy()
                before = values.tobytes()
                self.assertIs(self.bmi.get_value(name, values), values)
                self.assertNotEqual(values.tobytes(), before)
                self.assertTrue((self.bmi.get_value_ptr(name) == values).all())
                last = numpy.empty(1, dtype=values.dtype)
                self.bmi.get_value_at_indices(name, last, [values.size - 1])
                self.assertEqual(last[0], values[-1])


class Running(unittest.TestCase):
    def test_until_pointers_and_setting(self):
        bmi = BmiHfrac()
        bmi.initialize(CASE)
        step, cracks = bmi.get_time_step(), bmi.get_value_ptr("rock_crack__count")
        bmi.update_until(2.5 * step)
        self.assertAlmostEqual(bmi.get_current_time(), 2.5 * step, delta=1e-9 * step)
        self.assertGreater(cracks[0], 0)
        bmi.set_value("well_fluid__pressure", [20e6])
        bmi.update()
        self.assertEqual(bmi.get_value_ptr("well_fluid__pressure")[0], 20e6)
        for wrong in (
            lambda: bmi.set_value("rock_crack__count", [1]),
            lambda: bmi.set_value("well_fluid__pressure", [1.0, 2.0]),
            lambda: bmi.set_value_at_indices("well_fluid__pressure", [1], [1.0]),
            lambda: bmi.get_value("no_such__variable", None),
            lambda: bmi.update_until(0.0),
            lambda: bmi.initialize(CASE),
            lambda: bmi.get_grid_type(7),
        ):
            self.assertRaises((ValueError, LookupError, RuntimeError), wrong)
        bmi.finalize()
        self.assertRaises(RuntimeError, bmi.update)
        bmi.finalize()

    def test_two_models_know_nothing_of_each_other(self):
        one, other, alone = BmiHfrac(), BmiHfrac(), BmiHfrac()
        for model in (one, other, alone):
            model.initialize(CASE)
        other.set_value("well_fluid__pressure", [20e6])
        for _ in range(2):
            one.update()
            other.update()
            alone.update()
        name = "well_fluid__injected_volume_per_thickness"
        self.assertEqual(one.get_value_ptr(name)[0], alone.get_value_ptr(name)[0])
        self.assertNotEqual(one.get_value_ptr(name)[0], other.get_value_ptr(name)[0])


class Cells(Initialized):
    def test_cells_are_read_and_given_pressures(self):
        bmi, name = self.bmi, "cell_boundary_fluid__pressure"
        self.assertRaises(KeyError, bmi.get_grid_type, 3)
        self.assertRaises(KeyError, bmi.get_var_units, name)
        bmi.set_grid(4, 2, (-10.0, 0.0), (30.0, 50.0))
        self.assertEqual(bmi.get_grid_type(3), "uniform_rectilinear")
        self.assertEqual(bmi.get_grid_shape(3, numpy.empty(2, int)).tolist(), [2, 4])
        self.assertEqual(bmi.get_grid_spacing(3, numpy.empty(2)).tolist(), [50.0, 30.0])
        self.assertEqual(bmi.get_grid_origin(3, numpy.empty(2)).tolist(), [25.0, 5.0])
        self.assertEqual(bmi.get_grid_x(3, numpy.empty(4))[3], 95.0)
        self.assertEqual(bmi.get_grid_y(3, numpy.empty(2))[1], 75.0)
        self.assertRaises(NotImplementedError, bmi.get_grid_shape, 0, numpy.empty(2, int))
        shown = bmi.get_value_ptr(name)
        bmi.set_value_at_indices(name, [0, 7], [30e6, 31e6])
        self.assertEqual((shown[0], shown[7], shown[1]), (30e6, 31e6, bmi.get_value_ptr("rock_formation_fluid__pressure")[0]))
        outflow = bmi.get_value_ptr("cell_boundary_fluid__outflow_rate_per_thickness")
        before = float(outflow[0])
        bmi.update()
        self.assertLess(outflow[0], before)
        self.assertTrue((bmi.get_value("cell_rock_matrix__permeability", numpy.empty(8)) > 0.0).all())


class BothFaces(Initialized):
    def test_c_says_the_same(self):
        self.bmi.set_grid(4, 2, (0.0, 0.0), (25.0, 50.0))
        said = subprocess.run([PROGRAM, CASE, "--table"], check=True, capture_output=True, text=True).stdout.split()
        inputs = self.bmi.get_input_var_names()
        names_in_c = {"int32": "int", "int64": "long"}  # each face names types as its language does
        ours = [
            "|".join(
                str(part)
                for part in (
                    name,
                    names_in_c.get(self.bmi.get_var_type(name), "double"),
                    self.bmi.get_var_units(name),
                    self.bmi.get_var_location(name),
                    self.bmi.get_var_grid(name),
                    self.bmi.get_var_nbytes(name),
                    int(name in inputs),
                )
            )
            for name in self.bmi.get_output_var_names()
        ]
        self.assertEqual(" ".join(said), " ".join(ours))


del sys.argv[1:]
unittest.main()
