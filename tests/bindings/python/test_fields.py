"""Fields: shapes, types, copies, views."""
import gc
import unittest

import hfrac
from hfrac import _arrays
from support import plain, small


class Fields(unittest.TestCase):
    def setUp(self):
        self.sim = small()
        self.addCleanup(self.sim.close)

    def test_the_table_is_the_librarys(self):
        for field in hfrac.FIELDS:
            group = getattr(self.sim, field.name.split(".")[0] + "s")
            memory = memoryview(getattr(group, field.name.split(".")[1]))
            self.assertEqual(memory.shape[1:], (field.components,) if field.components > 1 else ())
            self.assertEqual(memory.itemsize, 8 if field.dtype == "double" else 4)
            self.assertTrue(memory.c_contiguous)

    def test_counts(self):
        state = self.sim.state
        self.assertEqual(len(self.sim.discs.position), state.disc_count)
        self.assertEqual(len(self.sim.bonds.discs), state.bond_count)
        self.assertEqual(len(self.sim.pipes.aperture), state.bond_count)
        self.assertEqual(len(self.sim.domains.pressure), state.domain_count)

    def test_contacts_of_smooth_joints(self):
        self.assertEqual(len(self.sim.joints.slip), 0)
        self.assertEqual(len(self.sim.view("joint.begin")), 0)
        joint = {"x1": 20.0, "y1": 70.0, "x2": 80.0, "y2": 75.0, "state": "smooth-broken", "friction": 0.6}
        with small(joints=[joint]) as jointed:
            jointed.step()
            joints, broken = jointed.joints, plain(jointed.bonds.state)
            contacts = len(joints.bond)
            self.assertGreater(contacts, 5)
            self.assertEqual([broken[bond] for bond in plain(joints.bond)], [2] * contacts)
            self.assertEqual(plain(joints.number), [0] * contacts)
            self.assertTrue(set(plain(joints.state)) <= {1, 2, 3})
            for (x0, y0), (x1, y1), state, stress in zip(plain(joints.begin), plain(joints.end), joints.state, joints.normal_stress):
                self.assertAlmostEqual((y1 - y0) * 60.0, (x1 - x0) * 5.0, delta=1e-9)
                self.assertEqual(state == 3, stress == 0.0)

    def test_rows_are_indexed_alike_with_and_without_numpy(self):
        position = self.sim.discs.position
        for x, y in position:
            self.assertTrue(0.0 < x < 100.0 and 0.0 < y < 100.0)
        self.assertEqual(position[3][1], plain(position)[3][1])
        self.assertEqual(self.sim.domains.kind[0], 2)

    def test_a_copy_stays_as_it_was(self):
        before = self.sim.discs.displacement
        held = plain(before)
        self.sim.step(2)
        self.assertEqual(plain(before), held)
        self.assertNotEqual(plain(self.sim.discs.displacement), held)

    def test_unknown_field(self):
        for use in (self.sim.field, self.sim.view):
            with self.assertRaisesRegex(hfrac.UnknownKeyError, "disc.position"):
                use("disc.colour")
        with self.assertRaises(AttributeError):
            self.sim.discs.colour

    @unittest.skipIf(_arrays.numpy is None, "numpy is not there")
    def test_numpy(self):
        position = self.sim.discs.position
        self.assertIsInstance(position, _arrays.numpy.ndarray)
        self.assertEqual(position.dtype, _arrays.numpy.float64)
        self.assertEqual(self.sim.bonds.discs.dtype, _arrays.numpy.int32)
        self.sim.step(5)
        self.assertEqual(self.sim.cracks.position.shape, (self.sim.crack_count, 2))
        self.assertTrue((self.sim.cracks.aperture >= 0.0).all())


class Views(unittest.TestCase):
    def setUp(self):
        self.sim = small()
        self.addCleanup(self.sim.close)

    def test_a_view_is_what_a_copy_is(self):
        for name in ("disc.position", "disc.radius", "bond.discs", "domain.kind"):
            view = self.sim.view(name)
            self.assertEqual([plain(v) if hasattr(v, "__len__") else v for v in map(self._item, view)],
                             [plain(v) if hasattr(v, "__len__") else v for v in map(self._item, self.sim.field(name))])
            self.assertEqual(len(view), len(self.sim.field(name)))
            self.assertTrue(memoryview(view.array).readonly)

    @staticmethod
    def _item(value):
        return list(value) if hasattr(value, "__len__") else value

    def test_reading_keeps_it_fresh_and_stepping_does_not(self):
        view = self.sim.view("disc.position")
        self.sim.fractures, self.sim.discs.radius, self.sim.state  # noqa: B018
        self.assertFalse(view.stale)
        self.assertIn("items", repr(view))
        self.sim.step()
        self.assertTrue(view.stale)
        self.assertIn("stale", repr(view))
        for use in (lambda: view.array, lambda: view[0], lambda: len(view), lambda: list(view)):
            with self.assertRaisesRegex(hfrac.StaleViewError, "disc.position is stale"):
                use()

    def test_the_memory_outlives_the_simulation(self):
        view = self.sim.view("disc.radius")
        array, held = view.array, plain(view.array)
        self.sim.close()
        self.assertTrue(view.stale)
        del view
        gc.collect()
        self.assertEqual(plain(array), held)

    @unittest.skipIf(_arrays.numpy is None, "numpy is not there")
    def test_numpy_without_a_copy(self):
        view = self.sim.view("disc.radius")
        numpy = _arrays.numpy
        self.assertEqual(numpy.asarray(view).ctypes.data, self.sim.view("disc.radius").array.ctypes.data)
        self.assertEqual(numpy.mean(view), self.sim.discs.radius.mean())
        self.assertEqual(numpy.asarray(view, dtype=numpy.float32).dtype, numpy.float32)
        with self.assertRaises(ValueError):
            view.array[0] = 1.0
        self.sim.step()
        with self.assertRaises(hfrac.StaleViewError):
            numpy.asarray(view)
