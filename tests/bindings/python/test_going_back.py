"""Images of the state, open steps, another far field."""
import unittest

import hfrac
from support import small

SERVO = {"boundary_kind": "stress", "stress": {"sigma_H": 10e6, "sigma_h": 10e6}, "stepping_force_ratio": 1e-2}


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


class OpenSteps(unittest.TestCase):
    def test_several_tries(self):
        with small() as sim:
            with sim.open_step() as step:
                self.assertGreaterEqual(step.do(1e-2), 0)
                with self.assertRaises(hfrac.ArgumentError):
                    sim.step()
                step.do(5e-3)
            self.assertFalse(step.open)
            self.assertAlmostEqual(sim.time, 5e-3)

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
