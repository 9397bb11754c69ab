#!/usr/bin/python3
"""libhfrac_gpu on a machine without a driver or a card: it loads, says so in words, and the run goes on where it may.

usage: tests/gpu/without_a_driver.py    (PYTHONPATH=bindings/python, HFRAC_LIBRARY, HFRAC_COMMAND)
"""
import os
import subprocess
import unittest

import hfrac

SMALL = {"packing_disc_count": 200, "stress_convention": "effective", "boundary_kind": "walls", "stress_sigma_Hmax": 0.0, "stress_sigma_hmin": 0.0}


@unittest.skipIf(hfrac.devices(), "there is a card here")
class WithoutADriver(unittest.TestCase):
    def test_why_there_is_none(self):
        self.assertRegex(hfrac.why_no_devices(), "driver|device")
        self.assertNotIn("libhfrac_gpu.so", hfrac.why_no_devices(), "the library itself was found")
        told = subprocess.run([os.environ["HFRAC_COMMAND"], "info", "--devices"], capture_output=True, text=True, check=True)
        self.assertEqual(told.stdout, f"no device: {hfrac.why_no_devices()}\n")

    def test_auto_says_so_once_and_goes_on(self):
        heard = []
        with hfrac.Simulation(**SMALL, run_device="auto", log=lambda _, text: heard.append(text)) as sim:
            sim.step(2)
            auto = sim.state_hash
        self.assertEqual(len([text for text in heard if "run.device" in text]), 1)
        with hfrac.Simulation(**SMALL) as sim:
            sim.step(2)
            self.assertEqual(sim.state_hash, auto)

    def test_gpu_is_an_error_in_words(self):
        with self.assertRaises(hfrac.DeviceError) as caught:
            hfrac.Simulation(**SMALL, run_device="gpu")
        self.assertIn('set run.device to "cpu" or "auto"', str(caught.exception))


if __name__ == "__main__":
    unittest.main()
