"""Options under the names they had before: a keyword, a section and a key are refused with the name of today."""
import unittest

import hfrac


class RenamedOptions(unittest.TestCase):
    def test_old_names_are_refused_with_the_new_one(self):
        for options, now in [
            ({"model_reading": "paper"}, "stress.convention"),
            ({"model": {"reading": "paper"}}, "stress.convention"),
            ({"stress_sigma_H": 1e6}, "stress.sigma_Hmax"),
            ({"stress": {"sigma_h": 1e6}}, "stress.sigma_hmin"),
            ({"stepping_substeps": 3}, "stepping.steps"),
            ({"boundary_walls_after_setup": "servo"}, "boundary.walls_after_equilibration"),
        ]:
            with self.subTest(options=options), self.assertRaisesRegex(hfrac.UnknownKeyError, f"is now called {now}"):
                hfrac.Definition(**options)


if __name__ == "__main__":
    unittest.main()
