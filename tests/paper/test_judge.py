"""The judge of the paper's claims, on measurements nobody ran: it says yes to a rock that does all the paper says, no
to one that does not, claim by claim, and nothing at all where runs are missing or broken."""
import contextlib
import csv
import io
import pathlib
import sys
import tempfile
import tomllib
import unittest

WORKFLOW = pathlib.Path(__file__).resolve().parents[2] / "examples/paper/workflow"
sys.path.insert(0, str(WORKFLOW))
import claims
import compare
import estimates
import families
import judge
import measure
from made_up import obedient
from measured import Measured

LIMIT = tomllib.loads((WORKFLOW / "thresholds.toml").read_text())
POINTS = families.expand("full")[1]


def changed(family, change, series=None):
    """The obedient rock with every row of a family (and series) changed by change(row, x)."""
    rows = obedient(POINTS)
    for row in rows:
        if row["family"] == family and series in (None, row["series"]):
            row.update({key: f"{value:.10g}" for key, value in change(row, float(row["x"])).items()})
    return Measured(rows, POINTS)


# A rock that breaks this one claim; families whose claims share a cause may fall with it.
CONTRARY = {
    "quiet_below_initiation": ("figure-05", lambda row, x: {"cracks": 3}),
    "onset_pressure": ("figure-05", lambda row, x: {"cracks": 0 if x < 60 else 9}),
    "cracks_rise": ("figure-05", lambda row, x: {"cracks": 10}),
    "plateau": ("figure-05", lambda row, x: {"cracks_at_four_fifths": 0.5 * float(row["cracks"])}),
    "sudden_above_upper": ("figure-05", lambda row, x: {"cracks_at_tenth": 0.5 * float(row["cracks"])}),
    "upper_pressure": ("figure-05", lambda row, x: {"cracks": max(x - 30, 0)}),
    "more_wings": ("figure-05", lambda row, x: {"wings": 2}),
    "bonds_are_cracks": ("figure-05", lambda row, x: {"cracks_drawn": 1 + float(row["cracks"])}),
    "smaller_stress": ("figure-07", lambda row, x: {"onset_MPa": 40 - x}, "sigma_hmin"),
    "larger_stress": ("figure-07", lambda row, x: {"onset_MPa": 60 - 2 * x}, "sigma_Hmax"),
    "normal_stiffness": ("figure-08", lambda row, x: {"onset_MPa": 35}, "normal"),
    "tangential_stiffness": ("figure-08", lambda row, x: {"onset_MPa": 30 + x}, "tangential"),
    "normal_strength": ("figure-09", lambda row, x: {"onset_MPa": 35 + 0.1 * x}, "normal"),
    "tangential_strength": ("figure-09", lambda row, x: {"onset_MPa": 90 - x}, "tangential"),
    "length_falls_again": ("figure-10", lambda row, x: {"extent_m": x}),
    "width_falls_again": ("figure-10", lambda row, x: {"width_m": 0.001 * x}),
    "optimum_moves": ("figure-10", lambda row, x: {"width_m": 0.001 * x, "extent_m": x}),
    "falls_with_stress": ("figure-11", lambda row, x: {"width_m": 0.1 + 0.01 * x}),
    "sudden_drop": ("figure-11", lambda row, x: {"extent_m": 40 - 2 * x}),
    "key_stress_moves": ("figure-11", lambda row, x: {"extent_m": 40 if x <= 8 else 5}, "400 C"),
    "slower_beyond": ("figure-11", lambda row, x: {"extent_m": 40 - 0.3 * x * x}),
    "grows_with_permeability": ("figure-12", lambda row, x: {"width_m": 0.1 - 0.005 * x}),
    "permeability_kink": ("figure-12", lambda row, x: {"extent_m": 20 + x}),
    "hotter_grows_more": ("figure-12", lambda row, x: {"extent_m": 20 + x}),
    "along_larger_stress": ("figure-12", lambda row, x: {"azimuth_deg": 60}),
}


def verdicts(data):
    return {claim.name: judge.verdict_of(claim, data, LIMIT)[0] for claim in claims.CLAIMS}


class Judge(unittest.TestCase):
    def test_says_yes_to_a_rock_that_does_all_the_paper_says(self):
        self.assertEqual({v for v in verdicts(Measured(obedient(POINTS), POINTS)).values()}, {"holds"})

    def test_says_no_where_the_rock_does_otherwise(self):
        self.assertEqual(set(CONTRARY), {claim.name for claim in claims.CLAIMS})
        for name, (family, change, *series) in CONTRARY.items():
            with self.subTest(name):
                self.assertNotEqual(verdicts(changed(family, change, *series))[name], "holds")

    def test_says_nothing_where_a_run_is_missing_or_broken(self):
        for status in ("missing", "broken"):
            rows = obedient(POINTS)
            for row in rows:
                if row["seed"] == 2:
                    row.update(status=status)
            found = verdicts(Measured(rows, POINTS))
            self.assertEqual(set(found.values()), {"not judged"}, status)
            self.assertIn(f"runs are {status}", judge.page("full", Measured(rows, POINTS), LIMIT, "table"))

    def test_a_row_that_is_not_there_is_a_missing_run(self):
        rows = [row for row in obedient(POINTS) if row["family"] != "figure-07"]
        self.assertEqual(verdicts(Measured(rows, POINTS))["smaller_stress"], "not judged")

    def test_a_value_that_is_not_there_is_no_pass(self):
        rows = obedient(POINTS)
        next(row for row in rows if row["family"] == "figure-08" and row["series"] == "normal")["onset_MPa"] = ""
        self.assertEqual(verdicts(Measured(rows, POINTS))["normal_stiffness"], "not judged")

    def test_other_convention_and_other_physics_make_conditions(self):
        def falling(row, x):
            return {"onset_MPa": 80 - x}

        found = verdicts(changed("figure-07-total", falling, "sigma_hmin"))
        self.assertEqual(found["smaller_stress"], "holds only if not with total stresses")
        found = verdicts(
            changed("figure-10", lambda row, x: {"width_m": 0.1, "extent_m": 30 - abs(x - 60) / 5}, "400 C")
        )
        self.assertTrue(found["optimum_moves"].startswith("holds only if strength falls"), found["optimum_moves"])

    def test_every_change_tried_is_on_record(self):
        """Changes that do not help stand beside the one that does, each with its figures."""
        claim = next(one for one in claims.CLAIMS if one.name == "length_falls_again")
        for helps in (True, False):
            rows = obedient(POINTS)
            for row in rows:
                if row["family"] in ("figure-10", "beyond-10-supply") or not helps and "10" in row["family"]:
                    row["extent_m"] = row["x"]
            verdict, _, _, why = judge.verdict_of(claim, Measured(rows, POINTS), LIMIT)
            self.assertEqual(why.count("Tried: "), len(claim.needs) - helps)
            self.assertEqual(why.count("With this change it holds: "), int(helps))
            expected = "holds only if every pressure has as much fluid" if helps else "does not hold"
            self.assertEqual(verdict.split(",")[0], expected)

    def test_a_set_without_changed_physics_says_so(self):
        points = families.expand("fast")[1]
        rows = obedient(points)
        for row in rows:
            if row["family"] == "figure-05":
                row["cracks_at_tenth"] = "0"
        claim = next(one for one in claims.CLAIMS if one.name == "sudden_above_upper")
        verdict, _, _, why = judge.verdict_of(claim, Measured(rows, points), LIMIT)
        self.assertEqual(verdict, "does not hold")
        self.assertEqual(why.count("is no part of this set"), len(claim.needs))

    def test_few_packings_decide_nothing(self):
        points = families.expand("fast")[1]
        self.assertIn("no sample", judge.page("fast", Measured(obedient(points), points), LIMIT, "table"))


class Measuring(unittest.TestCase):
    def test_a_folder_without_runs_gives_a_table_of_missing_ones(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "measured.csv"
            first = families.expand("fast")[1][0].run
            broken = pathlib.Path(folder) / "runs" / first
            broken.mkdir(parents=True)
            (broken / "result.json").write_text('{"status": "do')  # cut off
            with contextlib.redirect_stdout(io.StringIO()):
                measure.main("fast", folder, table)
            text = table.read_text()
            points = families.expand("fast")[1]
            data = Measured.read(table, points)
            self.assertEqual(text.count("\n"), len(points) + 1)
            self.assertEqual(dict(data.lacking())[first], "broken")
            self.assertEqual(len(data.lacking()), len({point.run for point in points}))


class Comparing(unittest.TestCase):
    def compared(self, change, *which):
        """(exit status, what was said) of a table against itself with one row changed."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            points = families.expand("fast")[1]
            for turn, name in enumerate(("first.csv", "second.csv")):
                rows = obedient(points)
                for row in rows:
                    row["state_hash"] = "f51f2b0806401eec"
                if turn == 1:
                    change(rows)
                with open(folder / name, "w", newline="") as file:
                    writer = csv.DictWriter(file, measure.COLUMNS)
                    writer.writeheader()
                    writer.writerows(rows)
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                status = compare.main(folder / "first.csv", folder / "second.csv", *which)
            return status, said.getvalue()

    def test_equal_tables_are_equal(self):
        status, said = self.compared(lambda rows: None)
        self.assertEqual(status, 0)
        self.assertIn("0 differ", said)

    def test_one_bit_of_one_state_is_seen(self):
        status, said = self.compared(lambda rows: rows[7].update(state_hash="f51f2b0806401eed"))
        self.assertEqual(status, 1)
        self.assertIn("state_hash f51f2b0806401eec and f51f2b0806401eed", said)

    def test_a_run_that_is_not_there_was_not_compared(self):
        for status in ("missing", "broken"):
            self.assertEqual(self.compared(lambda rows, status=status: rows[7].update(status=status))[0], 1)
        self.assertEqual(self.compared(lambda rows: rows.pop())[0], 1)

    def test_points_in_common_are_asked_for(self):
        status, said = self.compared(lambda rows: rows.pop(), "common")
        self.assertEqual(status, 0)
        self.assertTrue(said.startswith(f"{len(families.expand('fast')[1]) - 1} points, 0 differ"), said)
        self.assertEqual(self.compared(lambda rows: rows.clear(), "common")[0], 1)  # nothing was compared


class Estimates(unittest.TestCase):
    def test_known_numbers(self):
        x = [0, 1, 2, 3, 4, 5]
        self.assertAlmostEqual(estimates.slope(x, [1 + 2 * one for one in x]), 2.0)
        self.assertAlmostEqual(estimates.r_squared(x, [1 + 2 * one for one in x]), 1.0)
        self.assertAlmostEqual(estimates.spearman(x, [-(one**3) for one in x]), -1.0)
        self.assertAlmostEqual(estimates.spearman([1, 2, 3, 4], [1, 1, 2, 3]), 0.9486832980505138)  # as scipy.stats
        self.assertEqual(estimates.spearman(x, [7] * 6), 0.0)
        where, before, after = estimates.kink(x, [max(one - 3, 0) for one in x])
        self.assertAlmostEqual(where, 3.0, places=1)
        self.assertAlmostEqual(before, 0.0, places=1)
        self.assertAlmostEqual(after, 1.0, places=1)
        self.assertEqual(estimates.largest_drop([10, 9, 3, 2], 1.0), (1, 6 / 9))


class Families(unittest.TestCase):
    def test_every_figure_and_table_of_the_paper_has_its_data(self):
        there = " ".join(families.family_names())
        for figure in ("03-04", "05", "06", "07", "08", "09", "10", "11", "12"):
            self.assertIn(f"figure-{figure}", there)
        for table in (1, 2, 3):
            self.assertTrue((families.FAMILIES / f"table-{table}.toml").exists())

    def test_six_packings_and_one_change_a_series(self):
        for name in families.family_names():
            if "seeds" in families.read(name):  # pictures of one packing; some changes of the physics, which say so
                self.assertTrue(name.startswith("beyond") or families.read(name).get("pictures"), name)
                continue
            for series in families.read(name)["series"]:
                points = [one for one in POINTS if (one.family, one.series) == (name, series["name"])]
                self.assertEqual({one.seed for one in points}, set(families.SEEDS), name)

    def test_equal_cases_are_run_once(self):
        runs = {(one.family, one.x): one.run for one in POINTS if one.series in ("paper", "250 C") and one.seed == 1}
        self.assertEqual(runs["figure-10", 50.0], runs["figure-05", 50.0])

    def test_fine_keeps_all_but_the_discs_and_their_strength(self):
        run = families.expand("fine")[0]["figure-05-paper-45-s1"].case
        self.assertEqual(run["packing"]["disc_count"], 10000)
        self.assertEqual(run["bond"]["toughness_reference_radius"], 1.14)

    def test_facets_change_the_law_alone(self):
        of_facets, of_full = (families.expand(which)[0]["figure-05-paper-45-s1"].case for which in ("facets", "full"))
        self.assertEqual(of_facets.pop("fracture"), {"law": "facet"})
        self.assertEqual(of_facets, of_full)


if __name__ == "__main__":
    unittest.main()
