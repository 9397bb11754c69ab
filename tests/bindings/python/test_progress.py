"""Progress functions, what they raise, and Ctrl-C."""
import os
import signal
import threading
import unittest

import hfrac
from support import small


class Progress(unittest.TestCase):
    def test_it_is_told_what_is_done(self):
        seen = []
        with small(progress=lambda fraction, what: seen.append((fraction, what))) as sim:
            seen.clear()
            sim.on_progress(lambda fraction, what: seen.append((fraction, what)), seconds=0)
            sim.step(3)
        self.assertGreater(len(seen), 3)
        self.assertTrue(all(0.0 <= fraction <= 1.0 and what for fraction, what in seen))

    def test_a_true_result_stops(self):
        with small() as sim:
            sim.on_progress(lambda fraction, what: sim.step_count >= 2, seconds=0)
            self.assertIs(sim.step(50), hfrac.Status.STOPPED)
            self.assertEqual(sim.step_count, 2)
            advance = sim.advance(10.0)
            self.assertEqual((advance.reason, advance.status), (hfrac.StopReason.CALLBACK, hfrac.Status.STOPPED))
            sim.on_progress(None)
            self.assertGreaterEqual(sim.step(2), 0)
            self.assertEqual(sim.step_count, 4)

    def test_stopping_the_building(self):
        with self.assertRaises(hfrac.StoppedError):
            small(packing_disc_count=5000, packing_residual=1e-9, progress=lambda fraction, what: True)

    def test_what_it_raises_comes_out(self):
        def fail(fraction, what):
            raise ZeroDivisionError("mine")

        with small() as sim:
            sim.on_progress(fail, seconds=0)
            with self.assertRaisesRegex(ZeroDivisionError, "mine"):
                sim.step(3)
            sim.on_progress(None)
            self.assertGreaterEqual(sim.step(), 0)

    def test_changing_from_inside_is_refused(self):
        with small() as sim:
            sim.on_progress(lambda fraction, what: sim.step() and None, seconds=0)
            with self.assertRaisesRegex(hfrac.BusyError, "callback"):
                sim.step()

    def test_closing_from_inside_takes_effect_after_the_call(self):
        sim = small()
        sim.on_progress(lambda fraction, what: sim.close(), seconds=0)
        sim.step(2)
        self.assertTrue(sim.closed)

    def test_after_every_step(self):
        seen = []
        with small() as sim:
            sim.on_step(lambda now: seen.append((now.step_count, now is sim)) or now.step_count == 3)
            self.assertIs(sim.step(10), hfrac.Status.STOPPED)
            self.assertEqual((seen, sim.step_count), ([(1, True), (2, True), (3, True)], 3))
            sim.on_step(lambda now: now.step())
            with self.assertRaisesRegex(hfrac.BusyError, "callback"):
                sim.step(4)
            self.assertEqual(sim.step_count, 4)
            sim.on_step(None)
            sim.step()
            self.assertEqual(len(seen), 3)

    def test_log(self):
        told = []
        with small(log=lambda level, message: told.append((level, message))) as sim:
            self.assertTrue(any("discs of mean radius" in message for _, message in told))
            told.clear()
            sim.wells[0].set_pressure(20e6)
            self.assertEqual(told[0][0], hfrac.LogLevel.INFO)
            self.assertIn("well 0", told[0][1])
            sim.on_log(lambda level, message: told.append(level), hfrac.LogLevel.ERROR)
            told.clear()
            with self.assertRaises(hfrac.ArgumentError):
                sim.step(-1)
            self.assertEqual(told, [hfrac.LogLevel.ERROR])
            sim.on_log(lambda level, message: 1 / 0)
            with self.assertRaises(ZeroDivisionError):
                sim.wells[0].set_pressure(21e6)
            sim.on_log(None)
            sim.wells[0].set_pressure(22e6)

    def test_interrupt(self):
        with small() as sim:
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                sim.step(10**9)
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
            self.assertGreaterEqual(sim.step(), 0)

    def test_calls_of_several_threads_wait_for_one_another(self):
        with small() as sim:
            workers = [threading.Thread(target=sim.step, args=(2,)) for _ in range(4)]
            for worker in workers:
                worker.start()
            for worker in workers:
                worker.join()
            self.assertEqual(sim.step_count, 8)
