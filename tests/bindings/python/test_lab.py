"""The laboratory and the calibration."""
import math
import unittest

import hfrac


class Laboratory(unittest.TestCase):
    def test_elastic_constants(self):
        result = hfrac.lab("elastic", disc_count=500)
        self.assertGreater(result.report.modulus, 10e9)
        self.assertLess(result.report.modulus, 18e9)
        self.assertEqual(len(result.discs), result.report.disc_count)
        self.assertEqual(result.cracks, [])

    def test_stiffer_bonds_make_stiffer_rock(self):
        soft, stiff = (
            hfrac.lab("elastic", hfrac.Definition(bond={"normal_stiffness": kn}), disc_count=300).report.modulus
            for kn in (4e9, 8e9)
        )
        self.assertGreater(stiff, 1.1 * soft)

    def test_stops_when_asked(self):
        result = hfrac.lab("uniaxial", disc_count=500, progress=lambda share, what: True)
        self.assertEqual(result.report.end.name, "STOPPED")

    def test_refuses(self):
        with self.assertRaisesRegex(ValueError, "'wishing'.*elastic, tension"):
            hfrac.lab("wishing")
        with self.assertRaisesRegex(hfrac.ArgumentError, "disc_count = 3"):
            hfrac.lab("elastic", disc_count=3)
        with self.assertRaisesRegex(TypeError, "colour"):
            hfrac.calibrate(colour=1.0)

    def test_calibration(self):
        definition, found = hfrac.calibrate(modulus=20e9, disc_count=500, packings=1)
        self.assertEqual(found.reached, 1)
        self.assertLess(abs(found.achieved[0] / 20e9 - 1.0), 0.1)
        self.assertTrue(math.isnan(found.achieved[1]))
        again = hfrac.lab("elastic", definition, disc_count=500).report.modulus
        self.assertLess(abs(again / 20e9 - 1.0), 0.1)
