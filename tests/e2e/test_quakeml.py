"""Events as QuakeML 1.2: ids, times, places and magnitudes, read by an XML parser, and by ObsPy where it is installed."""
import csv
import datetime
import math
import pathlib
import re
import shutil
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from hfrac_runs import hfrac, run_case

BED = "{http://quakeml.org/xmlns/bed/1.2}"
EARTH = 6371008.8  # m
IDENTIFIER = re.compile(r"(smi|quakeml):[\w\d][\w\d\-.*()_~']{2,}/[\w\d\-.*()_~'][\w\d\-.*()+?_~'=,;#/&]*$")  # of the format
PLACE = ("--start", "2026-05-01T12:00:00Z", "--latitude", 47.5, "--longitude", 7.6, "--depth", 4500)


def words(element, path):
    found = element.find("/".join(BED + name for name in path.split("/")))
    return found.text


class QuakeML(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        cls.folder = cls.top / "a run & more"
        done = run_case(cls.folder)
        assert done.returncode == 0, done.stderr
        cls.file = cls.top / "events.xml"
        done = hfrac("catalogue", cls.folder, "--quakeml", cls.file, *PLACE)
        assert done.returncode == 0, done.stderr
        with open(cls.folder / "events.csv", newline="") as table:
            cls.table = [row for row in csv.DictReader(table) if math.isfinite(float(row["magnitude"]))]

    def test_holds_every_event_of_a_magnitude(self):
        root = ElementTree.parse(self.file).getroot()
        self.assertEqual(root.tag, "{http://quakeml.org/xmlns/quakeml/1.2}quakeml")
        events = root.findall(f"{BED}eventParameters/{BED}event")
        self.assertGreater(len(self.table), 3)
        self.assertEqual(len(events), len(self.table))
        ids = [element.attrib["publicID"] for element in root.iter() if "publicID" in element.attrib]
        self.assertEqual(len(ids), len(set(ids)))
        for one in ids:
            self.assertRegex(one, IDENTIFIER)
        start = datetime.datetime(2026, 5, 1, 12, tzinfo=datetime.timezone.utc)
        for event, row in zip(events, self.table):
            self.assertIn(words(event, "preferredOriginID"), ids)
            self.assertIn(words(event, "preferredMagnitudeID"), ids)
            self.assertIn(words(event, "focalMechanism/momentTensor/derivedOriginID"), ids)
            self.assertEqual(float(words(event, "magnitude/mag/value")), float(row["magnitude"]))
            self.assertEqual(float(words(event, "focalMechanism/momentTensor/scalarMoment/value")), float(row["moment_N_m"]))
            moment = datetime.datetime.fromisoformat(words(event, "origin/time/value").replace("Z", "+00:00"))
            self.assertAlmostEqual((moment - start).total_seconds(), float(row["time_s"]), delta=1e-6)
            north = math.radians(float(words(event, "origin/latitude/value")) - 47.5) * EARTH
            east = math.radians(float(words(event, "origin/longitude/value")) - 7.6) * EARTH * math.cos(math.radians(47.5))
            self.assertAlmostEqual(east, float(row["x_m"]), delta=1e-3)
            self.assertAlmostEqual(north, float(row["y_m"]), delta=1e-3)
            self.assertEqual(float(words(event, "origin/depth/value")), 4500.0)
            tensor = [float(words(event, f"focalMechanism/momentTensor/tensor/{part}/value"))
                      for part in ("Mpp", "Mtt", "Mtp")]
            for ours, theirs in zip(tensor, (float(row[f"moment_{part}_N_m"]) * sign for part, sign in (("xx", 1), ("yy", 1), ("xy", -1)))):
                self.assertAlmostEqual(ours, theirs, delta=1e-9 * float(row["moment_N_m"]))

    def test_turns_the_model_by_its_azimuth(self):
        file = self.top / "turned.xml"
        self.assertEqual(hfrac("catalogue", self.folder, "--quakeml", file, "--azimuth", 0).returncode, 0)
        for event, row in zip(ElementTree.parse(file).getroot().iter(f"{BED}event"), self.table):  # x north, y west
            self.assertAlmostEqual(math.radians(float(words(event, "origin/latitude/value"))) * EARTH, float(row["x_m"]), delta=1e-3)
            self.assertAlmostEqual(math.radians(float(words(event, "origin/longitude/value"))) * EARTH, -float(row["y_m"]), delta=1e-3)
            self.assertAlmostEqual(float(words(event, "focalMechanism/momentTensor/tensor/Mtt/value")), float(row["moment_xx_N_m"]),
                                   delta=1e-9 * float(row["moment_N_m"]))
            self.assertTrue(words(event, "origin/time/value").startswith("1970-01-01T00:00:"))

    def test_refuses_what_is_no_date_or_place(self):
        for bad in (("--start", "yesterday"), ("--start", "2026-02-30T00:00:00Z"), ("--start", "2026-05-01T12:00:00Zx"), ("--latitude", 95)):
            done = hfrac("catalogue", self.folder, "--quakeml", self.top / "never.xml", *bad)
            self.assertEqual(done.returncode, 2, done.stderr)
        self.assertNotEqual(hfrac("catalogue", self.folder, "--latitude", 10).returncode, 0)
        self.assertFalse((self.top / "never.xml").exists())

    def test_obspy_reads_it(self):
        try:
            from obspy import read_events
            from obspy.io.quakeml.core import _validate
        except ImportError:
            self.skipTest("ObsPy is not installed")
        events = read_events(str(self.file))
        self.assertEqual(len(events), len(self.table))
        self.assertAlmostEqual(events[0].preferred_magnitude().mag, float(self.table[0]["magnitude"]))
        self.assertTrue(_validate(str(self.file), verbose=True), "it does not keep to the schema")


unittest.main()
