#!/usr/bin/python3
"""Samples, Sobol indices, percentiles and the ensemble smoother against known answers.

Ishigami's function f = sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1 on (-pi, pi)^3 has S = 0.3139, 0.4424, 0 and ST = 0.5576, 0.4424,
0.2437 (Ishigami and Homma 1990; Saltelli et al. 2008). Tolerance 0.05. A linear Gaussian problem has an
exact posterior (mean and covariance by Bayes); the smoother's tolerance of 0.1 prior deviations in the mean and 10 % in the
deviations. Both were set before measuring. With packings that scatter the posterior is that of the joint error.
"""
import math
import pathlib
import unittest

import support  # noqa: F401
import numpy as np

from hfrac.study import sobol, statistics, sweep
from hfrac.study.designs import design
from hfrac.study.esmda import update
from hfrac.study.laws import Parameter
from hfrac.study.measures import NAMES
from hfrac.study.scatter import Scatter, shrunk
from hfrac.study.study_file import Quantity, Study, StudyError


def study(parameters, sampling, runs):
    return Study(pathlib.Path("s"), pathlib.Path("c"), runs, sampling, 1, (), {}, tuple(parameters), (), False, None)


def ranged(name, low=0.0, high=1.0, levels=3):
    return Parameter(name, (name,), "uniform", (low, high), levels)


def ishigami(points):
    x = -math.pi + 2.0 * math.pi * points
    return np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


FIRST, TOTAL = np.array([0.3139, 0.4424, 0.0]), np.array([0.5576, 0.4424, 0.2437])
THREE = [ranged(name) for name in "abc"]


class Designs(unittest.TestCase):
    def test_every_sampling_covers_the_laws(self):
        laws = [Parameter("u", ("u",), "uniform", (2.0, 6.0), 3), Parameter("l", ("l",), "loguniform", (1e-18, 1e-14), 3),
                Parameter("n", ("n",), "normal", (10.0, 2.0), 3), Parameter("g", ("g",), "lognormal", (3.0, 0.5), 3),
                Parameter("w", ("w",), "list", ([1, 2, 5],), 3)]
        for sampling, tolerance in (("sobol", 0.02), ("latin-hypercube", 0.02), ("random", 0.12)):
            points = design(study(laws, sampling, 512))
            self.assertEqual(points.shape, (512, 5))
            values = [np.array([law.value(share) for share in column]) for law, column in zip(laws, points.T)]
            for got, wanted, scale in ((values[0].mean(), 4.0, 4.0), (np.log10(values[1]).mean(), -16.0, 4.0),
                                       (values[2].mean(), 10.0, 2.0), (values[2].std(), 2.0, 2.0),
                                       (np.log(values[3]).mean(), math.log(3.0), 0.5), ((values[4] == 5).mean(), 1 / 3, 1.0)):
                self.assertLess(abs(got - wanted), tolerance * scale, sampling)

    def test_latin_hypercube_has_one_point_in_each_class(self):
        points = design(study(THREE, "latin-hypercube", 20))
        for column in points.T:
            self.assertEqual(sorted((column * 20).astype(int)), list(range(20)))

    def test_grid_and_one_at_a_time(self):
        grid = design(study([ranged("a", levels=2), ranged("b", levels=3)], "grid", 99))
        self.assertEqual(sorted(map(tuple, np.round(grid, 6))), [(a, b) for a in (0.25, 0.75) for b in (0.166667, 0.5, 0.833333)])
        single = design(study(THREE, "one-at-a-time", 99))
        self.assertEqual(len(single), 7)
        self.assertEqual(((single != 0.5).sum(axis=1)).tolist(), [0, 1, 1, 1, 1, 1, 1])

    def test_samples_repeat_with_their_seed(self):
        for sampling in ("sobol", "latin-hypercube", "random", "saltelli"):
            self.assertTrue((design(study(THREE, sampling, 40)) == design(study(THREE, sampling, 40))).all())

    def test_saltelli_wants_runs_enough(self):
        with self.assertRaisesRegex(StudyError, "runs = 9 must be at least 10"):
            design(study(THREE, "saltelli", 9))


class Indices(unittest.TestCase):
    def test_ishigami_on_the_saltelli_design(self):
        results = ishigami(design(study(THREE, "saltelli", 5 * 1024)))
        first, total = sobol.saltelli_indices(results, 3)
        print(f"Ishigami, 5 x 1024: first {np.round(first, 3)}, total {np.round(total, 3)}")
        self.assertLess(abs(first - FIRST).max(), 0.05)
        self.assertLess(abs(total - TOTAL).max(), 0.05)

    def test_ishigami_with_failed_runs(self):
        results = ishigami(design(study(THREE, "saltelli", 5 * 1024)))
        results[np.random.default_rng(3).random(len(results)) < 0.03] = np.nan
        first, total = sobol.saltelli_indices(results, 3)
        self.assertLess(max(abs(first - FIRST).max(), abs(total - TOTAL).max()), 0.05)

    def test_ishigami_from_a_plain_sample(self):
        points = design(study(THREE, "latin-hypercube", 2000))
        first = np.array([sobol.sample_index(column, ishigami(points)) for column in points.T])
        print(f"Ishigami, 2000 of a Latin hypercube: first {np.round(first, 3)}")
        self.assertLess(abs(first - FIRST).max(), 0.05)

    def test_constant_results_have_none(self):
        self.assertTrue(np.isnan(sobol.saltelli_indices(np.ones(50), 3)[0]).all())
        self.assertTrue(np.isnan(sobol.sample_index(np.arange(50.0), np.ones(50))))


class Together(unittest.TestCase):
    def test_percentiles_and_bands(self):
        self.assertEqual(statistics.percentiles(np.array([*range(101), np.nan])).tolist(), [10.0, 50.0, 90.0])
        tables = [{"time_s": np.array([0.0, 10.0]), "p": np.array([0.0, 10.0 * k])} for k in range(11)]
        tables.append({"time_s": np.array([0.0, 20.0]), "p": np.array([50.0, 50.0])})
        band = statistics.bands(tables, "p", 21)
        self.assertEqual(band["runs"].tolist(), [12] * 11 + [1] * 10)
        self.assertAlmostEqual(band["P50"][10], 50.0)
        self.assertAlmostEqual(band["P50"][20], 50.0)

    def test_what_is_drawn(self):
        """What the study asks for and how far joints slipped come first; a curve that stays the same is left out."""
        asked = study(THREE, "sobol", 8)._replace(quantities=(Quantity("late_Pa", "well_pressure_Pa", "last", 0.0),))
        found = [(name, 1.0) for name in (*NAMES, "late_Pa")]
        names = [one[0] for one in sweep.foremost(found, asked)]
        self.assertEqual(names, ["late_Pa", "joint_slipped_length_m", *NAMES[:sweep.DRAWN - 2]])
        time = np.array([0.0, 10.0])
        for values, moves in (([3.0, 3.0], False), ([3.0, 4.0], True)):
            band = statistics.bands([{"time_s": time, "length": np.array(values)}], "length", 5)
            self.assertEqual(sweep.goes_on(band), moves)
        for values, varies in (([np.nan], False), ([31.488047, 31.488047 + 1e-11], False), ([31.4, np.nan, 31.5], True), ([0.0, 1e-30], True)):
            self.assertEqual(sweep.varies(np.array(values)), varies)

    def test_swings_find_the_larger_effect(self):
        points = np.random.default_rng(1).random((200, 2))
        bars = statistics.swings(["small", "large"], points, points[:, 0] - 5.0 * points[:, 1], False)
        self.assertEqual([bar.name for bar in bars], ["large", "small"])
        self.assertAlmostEqual(bars[0].high - bars[0].low, -4.0, delta=0.3)
        single = statistics.swings(["a", "b"], np.zeros((5, 2)), np.array([0.0, 1.0, 2.0, 5.0, 9.0]), True)
        self.assertEqual(single[0], statistics.Swing("b", 5.0, 9.0))


class Smoother(unittest.TestCase):
    def posterior(self, passes, members=3000):
        random = np.random.default_rng(5)
        forward, errors = random.standard_normal((12, 3)), np.full(12, 0.8)
        forward[:, 2] *= 0.05  # a parameter that data hardly tell
        data = forward @ np.array([1.0, -0.5, 0.3]) + errors * random.standard_normal(12)
        precision = np.eye(3) + forward.T @ (forward / errors[:, None] ** 2)
        covariance = np.linalg.inv(precision)
        mean = covariance @ forward.T @ (data / errors ** 2)
        ensemble = random.standard_normal((members, 3))
        for _ in range(passes):
            ensemble = update(ensemble, ensemble @ forward.T, data, errors, float(passes), random)
        return mean, np.sqrt(np.diag(covariance)), ensemble

    def test_a_linear_gaussian_problem_has_its_exact_posterior(self):
        for passes in (1, 4):
            mean, deviation, ensemble = self.posterior(passes)
            print(f"ES-MDA, {passes} passes: mean {np.round(ensemble.mean(axis=0), 3)} of {np.round(mean, 3)}, "
                  f"deviation {np.round(ensemble.std(axis=0), 3)} of {np.round(deviation, 3)}")
            self.assertLess(abs(ensemble.mean(axis=0) - mean).max(), 0.1)
            self.assertLess(abs(ensemble.std(axis=0) / deviation - 1.0).max(), 0.1)
        self.assertGreater(deviation[2], 0.9)

    def across_packings(self, passes, told, packings=200, each=30):
        """The same, where every packing adds its own e ~ N(0, Q) and the data's packing is none of the ensemble's. Of a new packing about
        these the error is C_D + Q (1 + 1/k); `told`: the smoother is told of Q."""
        random = np.random.default_rng(7)
        forward, errors = random.standard_normal((12, 3)), np.full(12, 0.8)
        root = 0.7 * random.standard_normal((12, 12))
        scatter = Scatter(root @ root.T, packings)
        offsets = random.standard_normal((packings, 12)) @ root.T
        data = forward @ np.array([1.0, -0.5, 0.3]) + root @ random.standard_normal(12) + errors * random.standard_normal(12)
        inverse = np.linalg.inv(np.diag(errors ** 2) + scatter.unseen)
        covariance = np.linalg.inv(np.eye(3) + forward.T @ inverse @ forward)
        mean = covariance @ forward.T @ inverse @ (data - offsets.mean(axis=0))
        ensemble = random.standard_normal((packings * each, 3))
        for _ in range(passes):
            packing = random.permutation(len(ensemble)) % packings
            predicted = ensemble @ forward.T + offsets[packing]
            more = (scatter, packing) if told else ()
            ensemble = update(ensemble, predicted, data, errors, float(passes), random, *more)
        return mean, np.sqrt(np.diag(covariance)), ensemble

    def test_scatter_of_packings_belongs_to_the_error(self):
        for passes in (1, 4):
            mean, deviation, ensemble = self.across_packings(passes, True)
            print(f"ES-MDA across packings, {passes} passes: mean {np.round(ensemble.mean(axis=0), 3)} of {np.round(mean, 3)}, "
                  f"deviation {np.round(ensemble.std(axis=0), 3)} of {np.round(deviation, 3)}")
            self.assertLess(abs(ensemble.mean(axis=0) - mean).max(), 0.1)
            self.assertLess(abs(ensemble.std(axis=0) / deviation - 1.0).max(), 0.1)
        mean, deviation, ensemble = self.across_packings(4, False)
        self.assertLess((ensemble.std(axis=0) / deviation).min(), 0.8)  # scatter taken for knowledge

    def test_shrinkage_keeps_variances_and_leaves_what_many_samples_tell(self):
        random = np.random.default_rng(11)
        root = np.linalg.cholesky(0.8 * np.ones((6, 6)) + 0.2 * np.eye(6)) * np.arange(1.0, 7.0)[:, None]
        true, shares = root @ root.T, []
        for count in (5, 20, 5000):
            samples = random.standard_normal((count, 6)) @ root.T
            found, share = shrunk(samples)
            self.assertLess(abs(np.diag(found) / samples.var(axis=0, ddof=1) - 1.0).max(), 1e-12)
            self.assertGreater(np.linalg.eigvalsh(found).min(), 0.0)
            shares.append(share)
        print(f"lambda of 5, 20 and 5000 samples: {np.round(shares, 4)}")
        self.assertTrue(1.0 >= shares[0] > shares[1] > shares[2] and shares[2] < 0.01)
        self.assertLess(abs(found / true - 1.0).max(), 0.1)
        self.assertEqual(shrunk(random.standard_normal((20, 1)))[1], 1.0)
        constant = shrunk(np.column_stack([np.ones(8), random.standard_normal(8)]))[0]
        self.assertEqual(constant[0].tolist(), [0.0, 0.0])


if __name__ == "__main__":
    unittest.main()
