"""A simulation's life: create, run, wells, cracks, close."""
import copy
import gc
import math
import unittest

import hfrac
from hfrac._ranks import one_rank
from support import CASE, small


class Life(unittest.TestCase):
    def test_from_keywords_alone(self):
        with hfrac.Simulation(
            packing_disc_count=400, packing={"residual": 1e-3}, stress_convention="effective", boundary_kind="walls",
            stress={"sigma_Hmax": 0, "sigma_hmin": 0}, stepping_flow_step=1e-2, wells=[{"radius": 9.0, "pressure": 45e6}],
        ) as sim:
            self.assertEqual(sim.setup.packed_discs, 400)
            self.assertGreaterEqual(sim.step(), 0)

    def test_closing(self):
        with small() as sim:
            self.assertFalse(sim.closed)
        self.assertTrue(sim.closed)
        sim.close()
        self.assertIn("closed", repr(sim))
        for use in (lambda: sim.time, sim.step, lambda: sim.discs.radius, lambda: sim.cracks, lambda: sim.wells):
            with self.assertRaisesRegex(hfrac.BadHandleError, "closed"):
                use()
        with self.assertRaises(TypeError):
            copy.copy(sim)

    def test_the_garbage_collector_ends_it_too(self):
        small()
        gc.collect()

    def test_one_rank_with_a_table_is_one_alone(self):
        with small() as alone, small(comm=one_rank()) as sim:
            self.assertEqual(sim.state_hash, alone.state_hash)
            self.assertEqual(sim.traffic, (0, 0, 0, 0))

    def test_failure_to_build(self):
        with self.assertRaises(hfrac.HfracError):
            small(wells=[{"radius": 500.0}])

    def test_repr(self):
        with small() as sim:
            sim.step(2)
            self.assertRegex(repr(sim), r"small case.*\d+ discs.* 1 wells.*step 2, t = 0.02 s")
            self.assertIn("MPa", repr(sim.wells[0]))
            self.assertIn("position", repr(sim.discs))

    def test_definition(self):
        with small(model_seed=5) as sim:
            self.assertEqual(sim.definition.get("model.seed"), 5)
            self.assertEqual(sim.definition.text, hfrac.Definition(CASE, model_seed=5).text)


class Running(unittest.TestCase):
    def test_step_and_advance(self):
        with small() as sim:
            self.assertEqual((sim.time, sim.step_count), (0.0, 0))
            before = sim.state_hash
            sim.step(3)
            self.assertEqual(sim.step_count, 3)
            self.assertNotEqual(sim.state_hash, before)
            advance = sim.advance(0.05)
            self.assertAlmostEqual(advance.time, 0.05)
            self.assertIs(advance.reason, hfrac.StopReason.TARGET)
            self.assertEqual(advance.time, sim.time)
            self.assertEqual(sim.step(0), hfrac.Status.OK)
            with self.assertRaisesRegex(hfrac.ArgumentError, "count = -1"):
                sim.step(-1)
            with self.assertRaises(hfrac.ArgumentError):
                sim.advance(float("inf"))

    def test_balance_closes(self):
        with small() as sim:
            sim.step(5)
            self.assertEqual((sim.solver.kind, sim.solver.newton_iterations), (0, 0))
            balance = sim.balance
            self.assertGreater(balance.injected_volume, 0.0)
            self.assertLess(abs(balance.fluid_error), 1e-6 * balance.injected_volume)

    def test_stop_condition(self):
        with small(stop_cracks=1) as sim:
            advance = sim.advance(10.0)
            self.assertIs(advance.reason, hfrac.StopReason.CRACKS)
            self.assertLess(advance.time, 10.0)
            self.assertIs(sim.state.stop_reason, hfrac.StopReason.CRACKS)
            self.assertIs(advance.status, hfrac.Status.STOP_CONDITION)
            sim.set_stop()
            self.assertEqual(sim.advance(advance.time + 0.015, exact=True).time, advance.time + 0.015)

    def test_rock_that_falls_apart_is_an_error(self):
        with hfrac.Simulation(packing_disc_count=60, wells=[{"radius": 22, "pressure": 30e6}]) as sim:
            with self.assertRaisesRegex(hfrac.CollapsedError, "fell apart in step 1: disc "):
                sim.step()
            self.assertEqual((sim.time, hfrac.CollapsedError.status), (0.0, hfrac.Status.ERR_COLLAPSED))

    def test_a_step_that_does_not_come_to_rest_is_a_note(self):
        with small(stepping_max_cycles=10) as sim:
            self.assertIs(sim.step(), hfrac.Status.NOT_AT_REST)


class Wells(unittest.TestCase):
    def test_controls(self):
        with small() as sim:
            (well,) = sim.wells
            self.assertEqual((well.state.x, well.state.control), (50.0, hfrac.WellControl.PRESSURE))
            well.set_ramp(10e6, per_step=1e6)
            sim.step(3)
            self.assertAlmostEqual(well.pressure, 3e6, delta=1.0)
            well.set_pressure(5e6)
            sim.step()
            self.assertAlmostEqual(well.pressure, 5e6, delta=1.0)
            self.assertGreater(well.injected_volume, 0.0)
            well.set_rate(1e-4)
            sim.step()
            self.assertIs(well.state.control, hfrac.WellControl.RATE)
            self.assertAlmostEqual(well.rate, 1e-4)

    def test_schedule(self):
        with small() as sim:
            (well,) = sim.wells
            step = 1e-2
            well.set_schedule([(0.5 * step, "pressure", 4e6), (1.25 * step, "rate", 0.0)])
            sim.step()
            self.assertAlmostEqual(sim.time, 0.5 * step)
            sim.step()
            self.assertEqual((well.pressure, sim.time), (4e6, 1.25 * step))
            sim.step()
            self.assertIs(well.state.control, hfrac.WellControl.RATE)
            with self.assertRaisesRegex(hfrac.ArgumentError, "in order of time"):
                well.set_schedule([(2.0, "rate", 0.0), (1.0, "rate", 0.0)])

    def test_fluid(self):
        with small(fluid_second_viscosity=0.1, wells=[{"radius": 9.0, "control": "rate", "rate": 1e-4}]) as sim:
            (well,) = sim.wells
            sim.step()
            self.assertIs(well.state.fluid, hfrac.WellFluid.FIRST)
            self.assertEqual(max(sim.field("domain.second_fluid")), 0.0)
            well.set_fluid("second")
            sim.step()
            self.assertIs(well.state.fluid, hfrac.WellFluid.SECOND)
            self.assertEqual(sim.field("domain.second_fluid")[well.state.domain], 1.0)
        with small() as sim, self.assertRaisesRegex(hfrac.ArgumentError, "second_viscosity"):
            sim.wells[0].set_fluid("second")

    def test_added(self):
        with small() as sim:
            sim.step()
            before, first = sim.save(), sim.state_hash
            well = sim.add_well(75.0, 60.0)
            self.assertEqual((well.index, len(sim.wells), well.state.radius), (1, 2, 0.0))
            self.assertIs(well.state.control, hfrac.WellControl.RATE)
            self.assertEqual(sim.field("domain.kind")[well.state.domain], 1)
            well.set_pressure(3e6)
            sim.step()
            self.assertEqual(well.pressure, 3e6)
            image, then = sim.save(), sim.state_hash
            self.assertEqual(sim.definition.well_count, 1)
            with hfrac.Simulation(sim.definition) as other:
                other.restore(image)
                self.assertEqual((len(other.wells), other.state_hash), (2, then))
            sim.restore(before)
            self.assertEqual((len(sim.wells), sim.state_hash), (1, first))
            with self.assertRaisesRegex(hfrac.ArgumentError, "outside the rock"):
                sim.add_well(-1.0, 60.0)

    def test_wellbore_and_clusters(self):
        """8 and 4 perforations at one pressure of the wellbore: the drop is 8 rho Q^2 / (pi^2 n^2 D^4 C_d^2), rates go with the counts."""
        well = {"x": 30.0, "y": 50.0, "radius": 8.0, "wellbore": 3, "height": 20.0, "perforation_count": 8, "perforation_diameter": 0.01,
                "discharge_coefficient": 0.8, "near_well_friction": 0.0, "depth": 1500.0, "fluid_density": 1050.0, "storage": 1e-12}
        first = {**well, "control": "rate", "rate": 3e-3}
        with hfrac.Simulation(
            packing_disc_count=600, stress={"sigma_Hmax": 30e6, "sigma_hmin": 30e6}, fluid_formation_pressure=25e6, flow_permeability=1e-11,
            stepping={"mode": "coupled", "flow_step": 1.0}, solver_kind="quasi-static", wells=[first, {**well, "x": 70.0, "perforation_count": 4}],
        ) as sim:
            sim.step(4)
            one, two = (well.state for well in sim.wells)
            self.assertAlmostEqual(one.rate / two.rate, 2.0, delta=0.02)
            self.assertAlmostEqual(one.rate + two.rate, 3e-3, delta=3e-8)
            self.assertAlmostEqual(one.wellbore_rate, 3e-3, delta=1e-12)
            self.assertEqual(one.wellbore_pressure, two.wellbore_pressure)
            self.assertAlmostEqual(one.wellbore_pressure - one.wellhead_pressure, 1050.0 * 9.80665 * 1500.0, delta=1.0)
            drop = 8.0 * 1050.0 * (20.0 * one.rate) ** 2 / (math.pi**2 * 8**2 * 0.01**4 * 0.8**2)
            self.assertAlmostEqual(one.wellbore_pressure - one.pressure, drop, delta=0.01 * drop)
            sim.wells[0].set_rate(0.0)
            sim.step(20)
            self.assertLess(sim.wells[0].state.wellbore_pressure - sim.wells[0].pressure, 0.01 * drop)  # shut in

    def test_near_well_friction(self):
        with small(wells=[{"radius": 9.0, "control": "rate", "rate": 1e-4, "near_well_friction": 1e8, "height": 4.0}]) as sim:
            sim.step()
            (well,) = sim.wells
            self.assertAlmostEqual(well.state.wellbore_pressure - well.pressure, 1e8 * (4.0 * 1e-4) ** 0.5, delta=1e4)

    def test_fluid_area(self):
        with hfrac.Simulation(
            packing_disc_count=600, stress={"sigma_Hmax": 30e6, "sigma_hmin": 30e6}, fluid={"formation_pressure": 25e6, "bulk_modulus": 1e7},
            flow_permeability=1e-22, stepping={"mode": "coupled", "flow_step": 1.0}, solver_kind="quasi-static",
            wells=[{"radius": 9.0, "control": "rate", "rate": 0.5, "fluid_area": 100.0}],
        ) as sim:
            sim.step()
            self.assertAlmostEqual(sim.wells[0].pressure - 25e6, 0.5 * 1e7 / 100.0, delta=500.0)  # Q K_f / A

    def test_no_such_well(self):
        with small() as sim, self.assertRaisesRegex(hfrac.ArgumentError, "well 3 is not there"):
            hfrac.Well(sim, 3).set_pressure(1.0)


class Cracks(unittest.TestCase):
    def test_all_and_since(self):
        with small() as sim:
            start = len(sim.cracks)
            sim.step(5)
            cracks = sim.cracks
            self.assertEqual(len(cracks), sim.crack_count)
            self.assertGreater(len(cracks), start)
            later, cursor = sim.cracks_since(start)
            self.assertEqual((len(later), cursor), (len(cracks) - start, len(cracks)))
            self.assertEqual(sim.cracks_since(cursor)[1], cursor)
            self.assertEqual(len(sim.cracks_since(cursor)[0]), 0)
            for index, crack in enumerate(cracks):
                self.assertEqual(crack.id, index)
                self.assertIn(crack.mode, list(hfrac.CrackMode))
                self.assertEqual(len(crack.position), 2)
                self.assertGreater(crack.length, 0.0)
            with self.assertRaises(hfrac.ArgumentError):
                sim.cracks_since(10**6)

    def test_fractures(self):
        with small() as sim:
            self.assertIsInstance(sim.fractures, list)
            sim.step(5)
            largest = sim.fractures[0]
            self.assertIsInstance(largest, hfrac.Fracture)
            self.assertGreater(largest.crack_count, 0)
            self.assertGreater(largest.largest_aperture, 0.0)
            line = sim.fracture_line(largest.index)
            self.assertAlmostEqual(sum(float(point.length) for point in line), largest.length)
            self.assertEqual(int(line[-1].tip), 1)
            with self.assertRaises(hfrac.ArgumentError):
                sim.fracture_line(10**6)

    def test_events(self):
        with small() as sim:
            self.assertEqual(sim.events(), [])
            sim.step(5)
            events = sim.events()
            self.assertEqual(sum(event.crack_count for event in events), len(sim.cracks))
            self.assertTrue(all(event.moment > 0.0 for event in events))
            self.assertEqual(len(sim.events(distance=1e-9)), len(sim.cracks))
            owners = sim.event_of_cracks()
            self.assertEqual([owners.count(event.index) for event in events], [event.crack_count for event in events])
            law = hfrac.magnitude_law([event.magnitude for event in events], -9.0)
            self.assertEqual(law.count, len(events))
            self.assertGreater(law.b, 0.0)
            with self.assertRaises(hfrac.ArgumentError):
                sim.events(thickness=-1.0)


class Slips(unittest.TestCase):
    """A joint without friction beside the well of a dry model slips as the far field becomes uneven."""

    def test_events_from_slip(self):
        joint = {"x1": 20.0, "y1": 30.0, "x2": 50.0, "y2": 60.0, "state": "smooth-broken", "friction": 0.0}
        with small(joints=[joint], boundary_kind="stress", stress_sigma_Hmax=10e6, stress_sigma_hmin=10e6, flow_scheme="off",
                   solver_kind="quasi-static", bond_tensile_strength=1e12, bond_shear_strength=1e12) as sim:
            sim.step(1)
            start = len(sim.slips)
            sim.set_far_field(14e6, 10e6)
            sim.step(1)
            slips, cursor = sim.slips_since(start)
            self.assertGreater(len(slips), 0)
            self.assertEqual(cursor, start + len(slips))
            moment = sum(float(slip.shear_modulus * slip.length * slip.slip) for slip in slips)
            events = [event for event in sim.slip_events(time_window=1e9) if event.kind == hfrac.EventKind.SLIP]
            self.assertEqual(sum(event.slip_count for event in events), sum(int(slip.step) > 0 for slip in sim.slips))
            self.assertGreater(sum(event.moment for event in sim.slip_events()), 0.9 * abs(moment))
            self.assertEqual(sim.slip_events(slip_rate=1e9), [])
            with self.assertRaises(hfrac.ArgumentError):
                sim.slip_events(shear_modulus=-1.0)


class OwnDiscs(unittest.TestCase):
    def test_discs_packed_elsewhere(self):
        with small() as packed:
            rows = [(x, y, radius) for (x, y), radius in zip(packed.discs.position, packed.discs.radius)]
        with small(discs=rows, stepping_force_ratio=1e-2, wells=[{"radius": 5.0}]) as sim:
            self.assertEqual(sim.setup.packed_discs, len(rows))

    def test_bonds_of_a_list(self):
        with small() as packed:
            rows = [(x, y, radius) for (x, y), radius in zip(packed.discs.position, packed.discs.radius)]
        options = {"discs": rows, "stepping_force_ratio": 1e-2, "wells": [{"radius": 5.0}]}
        with small(**options) as near:
            self.assertEqual(near.state.disc_count, len(rows), "indices are those of the rows")
            pairs = [tuple(pair) for pair in near.bonds.discs]
            with small(bonds=pairs, **options) as listed:
                self.assertEqual(listed.state_hash, near.state_hash)
        with small(bonds=pairs[::2], **options) as jointed:
            self.assertEqual(list(jointed.bonds.state).count(3), len(pairs) // 2)
        with self.assertRaisesRegex(hfrac.HfracError, "to itself"):
            small(bonds=[(1, 1)], **options)

    def test_wrong_shape(self):
        with self.assertRaises(ValueError):
            hfrac.Definition(discs=[(1.0, 2.0)])
        with self.assertRaises(ValueError):
            hfrac.Definition(bonds=[(1, 2, 3)])


class Isolation(unittest.TestCase):
    def test_two_interleaved_are_as_alone(self):
        with small() as alone, small() as one, small(model_seed=9) as two:
            alone.step(4)
            for _ in range(4):
                one.step()
                two.step()
            self.assertEqual(one.state_hash, alone.state_hash)
            self.assertNotEqual(one.state_hash, two.state_hash)
