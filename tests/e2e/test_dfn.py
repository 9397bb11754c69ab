"""Traces of natural fractures from statistics: what was asked is what comes out, the same from the same seed, and read again."""
import math
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import hfrac

FIELD = pathlib.Path(__file__).parents[2] / "examples" / "field"
# What docs/stimulation.md says made the example's traces.
EXAMPLE = ("--set", "direction=30,concentration=8,p21=0.052,exponent=2.5,shortest=8,longest=50",
           "--set", "direction=145,concentration=8,p21=0.046,exponent=2.5,shortest=8,longest=50",
           "--through", 50, 50)
GOOD = "direction=30,concentration=8,p21=0.05,exponent=2.5,shortest=4,longest=20"


def lines_of(path):
    return [line.split(",")[1:5] for line in path.read_text().splitlines() if line[0].isdigit()]


def traces_of(path):
    return [tuple(map(float, ends)) for ends in lines_of(path)]


def length(trace):
    return math.dist(trace[:2], trace[2:])


class Dfn(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.file = self.top / "traces.csv"

    def made(self, *arguments, output=None):
        done = hfrac("dfn", "-o", output or self.file, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_examples_traces_come_again(self):
        self.made(*EXAMPLE)
        self.assertEqual(lines_of(self.file), lines_of(FIELD / "stimulation-traces.csv"))

    def test_statistics_are_met(self):
        text = self.made("--size", 400, 200, "--set", GOOD.replace("0.05", "0.2"), "--seed", 7)
        traces = traces_of(self.file)
        p21 = sum(map(length, traces)) / (400 * 200)
        self.assertGreaterEqual(p21, 0.2)
        self.assertLess(p21, 0.2 + 20 / (400 * 200))
        self.assertIn(f"{len(traces)} traces, P21 {p21:.4g} 1/m of 0.2 asked", text)
        for x1, y1, x2, y2 in traces:
            self.assertTrue(all(0 <= x <= 400 for x in (x1, x2)) and all(0 <= y <= 200 for y in (y1, y2)))
        # Mean of doubled angles: von Mises of concentration 8 has a resultant of I1(8) / I0(8) = 0.935.
        ways = [2 * math.atan2(t[3] - t[1], t[2] - t[0]) for t in traces]
        cosine, sine = (sum(f(w) for w in ways) / len(ways) for f in (math.cos, math.sin))
        self.assertAlmostEqual(math.degrees(math.atan2(sine, cosine) / 2), 30.0, delta=1.0)
        self.assertAlmostEqual(math.hypot(cosine, sine), 0.935, delta=0.01)
        # Share of a power law above 8 m: (20^p - 8^p) / (20^p - 4^p), p = -1.5; cutting at the edge takes a little.
        share = sum(length(t) >= 8 for t in traces) / len(traces)
        self.assertAlmostEqual(share, (20**-1.5 - 8**-1.5) / (20**-1.5 - 4**-1.5), delta=0.02)

    def test_a_lognormal_law(self):
        self.made("--size", 500, "--set", "direction=0,concentration=0,p21=0.2,median=5,deviation=0.5")
        lengths = sorted(map(length, traces_of(self.file)))
        self.assertAlmostEqual(lengths[len(lengths) // 2], 5.0, delta=0.15)
        above = sum(one > 5 * math.exp(0.5) for one in lengths) / len(lengths)
        self.assertAlmostEqual(above, 0.1587, delta=0.01)

    def test_the_same_seed_and_another(self):
        self.made("--set", GOOD, "--seed", 3)
        first = lines_of(self.file)
        self.made("--set", GOOD, "--seed", 3)
        self.assertEqual(lines_of(self.file), first)
        self.made("--set", GOOD, "--seed", 2**40 + 3)
        self.assertNotEqual(lines_of(self.file), first)

    def test_t_ends_and_what_is_described(self):
        text = self.made("--set", GOOD, "--set", GOOD.replace("=30", "=120") + ",t=1", "--size", 60)
        self.assertNotIn(" 0 ends on another trace", text)
        described = hfrac("dfn", "--describe", self.file, "--size", 60, "--picture", self.top / "again.svg")
        self.assertEqual(described.returncode, 0, described.stderr)
        same = [line for line in text.splitlines() if line.split()[0] in ("traces", "density", "lengths", "meetings")]
        self.assertEqual(len(same), 4)
        for line in same:
            self.assertIn(line, described.stdout)
        for name in ("traces.png", "again.svg"):
            self.assertGreater((self.top / name).stat().st_size, 1000)

    def test_crossings_and_ends_are_counted(self):
        self.file.write_text("START_X,START_Y,END_X,END_Y\n0,5,10,5\n5,0,5,10\n2,5.0004,2,9\n8,5.3,8,9\n")
        text = hfrac("dfn", "--describe", self.file).stdout
        self.assertIn("1 crossings (X), 1 ends on another trace (T)", text)
        text = hfrac("dfn", "--describe", self.file, "--touching", 0.5).stdout
        self.assertIn("1 crossings (X), 2 ends on another trace (T)", text)

    def test_geojson_is_read_by_a_case(self):
        output = self.top / "traces.geojson"
        self.made("--set", GOOD, "--seed", 3, output=output)
        self.made("--set", GOOD, "--seed", 3)
        words = [[line for line in hfrac("dfn", "--describe", file).stdout.splitlines()[1:] if "picture" not in line]
                 for file in (output, self.file)]
        self.assertEqual(words[0], words[1])
        case = self.top / "case.toml"
        case.write_text(f'[[joint]]\nfile = "{output.name}"\n[stress]\nsigma_Hmax = 40e6\nsigma_hmin = 30e6\n'
                        "[[well]]\nradius = 8.0\npressure = 45e6\n")
        checked = hfrac("check", case)
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_bad_input_is_refused_in_a_sentence(self):
        def bad(change, *more):
            return ("--set", change, "-o", self.file, *more)
        table = (
            (("-o", self.file), "--set"),
            (("--set", GOOD), "dfn needs --output"),
            (bad(GOOD.replace("p21=0.05", "p21=0")), "set 1: p21 = 0 1/m makes no traces; give the length of traces per area"),
            (bad(GOOD.replace("p21=0.05", "p21=-1")), "set 1: p21 = -1 is outside 0 to 1000 1/m"),
            (bad(GOOD.replace("shortest=4", "shortest=40")), "set 1: shortest = 40 m is above longest = 20 m; swap them"),
            (bad(GOOD.replace("shortest=4", "shortest=0")), "set 1: shortest = 0 m; a power law needs lengths above 0"),
            (bad(GOOD.replace("exponent=2.5", "exponent=11")), "set 1: exponent = 11 is outside 0 to 10"),
            (bad(GOOD.replace("exponent=2.5", "exponent=nan")), "set 1: 'exponent=nan' is not a number from 0 to 10"),
            (bad(GOOD.replace("concentration=8", "concentration=-8")), "set 1: concentration = -8 is outside 0 to 10000"),
            (bad(GOOD.replace("direction=30", "direction=400")), "set 1: direction = 400 is outside -360 to 360 degrees"),
            (bad(GOOD + ",t=2"), "set 1: t = 2 is outside 0 to 1"),
            (bad(GOOD + ",length=2"), "set 1: 'length=2' is not NAME=NUMBER with one of the names direction"),
            (bad(GOOD + ",median=2"), "set 1: has both exponent and median"),
            (bad("p21=0.05,median=5"), "set 1: deviation = 0; a lognormal law needs"),
            (bad("p21=0.05,median=5,deviation=0.1,shortest=50"), "set 1: of the lognormal law"),
            (bad(GOOD.replace("p21=0.05", "p21=1000")), "set 1: p21 = 1000 1/m takes more than 100000 traces"),
            (bad(GOOD, "--size", 0), "--size 0 is outside"),
            (bad(GOOD, "--through", 500, 5), "--through 500 5 m does not lie in the model of 100 m x 100 m"),
            (("--set", GOOD, "-o", self.top / "traces.txt"), "traces are written as .csv, .geojson or .json"),
            (("--describe", self.top / "none.csv"), "none.csv: cannot be opened"),
        )
        for arguments, words in table:
            done = hfrac("dfn", *arguments)
            self.assertEqual(done.returncode, 2, (arguments, done.stdout, done.stderr))
            self.assertIn(words, done.stderr)
            self.assertFalse(self.file.exists())
        done = hfrac("dfn", "--set", GOOD, "-o", self.top / "no" / "such" / "traces.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("traces.csv", done.stderr)


if __name__ == "__main__":
    unittest.main()
