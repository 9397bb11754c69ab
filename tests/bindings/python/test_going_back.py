"""Images of the state in memory and in files, open steps, what acts from outside."""
import pathlib
import tempfile
import unittest

import hfrac
from support import small

SERVO = {"boundary_kind": "stress", "stress": {"sigma_Hmax": 10e6, "sigma_hmin": 10e6}, "stepping_force_ratio": 1e-2}


class Images(unittest.TestCase):
    def test_restore_and_the_same_way_again(self):
        with small() as sim:
            sim.step(2)
            image, start = sim.save(), sim.state_hash
            self.assertIsInstance(image, bytes)
            sim.step(3)
            once = sim.state_hash
            sim.restore(image)
            self.assertEqual((sim.state_hash, sim.step_count), (start, 2))
            sim.step(3)
            self.assertEqual(sim.state_hash, once)
            with small() as other:
                other.restore(image)
                self.assertEqual(other.state_hash, start)

    def test_bad_images_change_nothing(self):
        with small() as sim:
            sim.step()
            image, now = sim.save(), sim.state_hash
            for bad in (b"", image[:-1], image[:100] + bytes([image[100] ^ 1]) + image[101:]):
                with self.assertRaises(hfrac.HfracError):
                    sim.restore(bad)
                self.assertEqual(sim.state_hash, now)
            with small(model_seed=9) as other, self.assertRaises(hfrac.HfracError):
                other.restore(image)

    def test_a_view_is_stale_after_restore(self):
        with small() as sim:
            image, view = sim.save(), sim.view("disc.position")
            sim.restore(image)
            self.assertTrue(view.stale)


class Files(unittest.TestCase):
    def test_saved_and_loaded(self):
        with tempfile.TemporaryDirectory() as folder, small() as sim, small() as other:
            path = pathlib.Path(folder, "a state")
            sim.step(2)
            sim.save_file(path)
            self.assertEqual([p.name for p in path.parent.iterdir()], ["a state"])
            other.load_file(path)
            self.assertEqual(other.state_hash, sim.state_hash)
            path.write_bytes(path.read_bytes()[:-1])
            with self.assertRaisesRegex(hfrac.FileError, "was cut"):
                other.load_file(path)
            with self.assertRaises(OSError):
                sim.save_file("/nonexistent/state")


class OpenSteps(unittest.TestCase):
    def test_several_tries(self):
        with small() as sim:
            with sim.open_step() as step:
                self.assertGreaterEqual(step.do(1e-2), 0)
                with self.assertRaises(hfrac.ArgumentError):
                    sim.step()
                step.do(5e-3)
                self.assertGreaterEqual(step.more(2e-3), 0)
            self.assertFalse(step.open)
            self.assertAlmostEqual(sim.time, 7e-3)

    def test_rejected_by_hand_and_by_an_exception(self):
        with small() as sim:
            before = sim.state_hash
            with sim.open_step() as step:
                step.do(1e-2)
                step.reject()
            self.assertEqual(sim.state_hash, before)
            with self.assertRaises(ZeroDivisionError), sim.open_step() as step:
                step.do(1e-2)
                1 / 0  # noqa: B018
            self.assertEqual(sim.state_hash, before)
            self.assertGreaterEqual(sim.step(), 0)


class FarField(unittest.TestCase):
    def test_it_makes_a_difference(self):
        with small(**SERVO) as kept, small(**SERVO) as changed:
            changed.set_far_field(12e6, 9e6)
            kept.step(2)
            changed.step(2)
            self.assertNotEqual(kept.state_hash, changed.state_hash)
            with self.assertRaises(hfrac.ArgumentError):
                changed.set_far_field(1e6, 2e6)


class FormationPressure(unittest.TestCase):
    def test_it_is_reported(self):
        with small() as sim:
            sim.set_formation_pressure(26e6)
            self.assertEqual(sim.state.formation_pressure, 26e6)
            with self.assertRaises(hfrac.ArgumentError):
                sim.set_formation_pressure(float("nan"))


class WallsAndLimits(unittest.TestCase):
    def test_walls(self):
        with small() as sim:
            self.assertEqual([wall.normal for wall in sim.walls], [(1, 0), (-1, 0), (0, 1), (0, -1)])
        with small(**SERVO) as sim:
            self.assertEqual(sim.walls, [])

    def test_limits(self):
        with small() as sim:
            self.assertIs(sim.step_limits.binding, hfrac.StepLimit.NONE)
            self.assertGreater(sim.step_limits.mechanical_step, 0.0)
