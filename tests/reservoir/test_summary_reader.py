"""The reader of Eclipse summaries: what it reads of a file made here, and that it refuses a damaged one."""
import pathlib
import struct
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples/reservoir/opm"))

from eclipse_summary import read_blocks, read_summary  # noqa: E402


def record(data):
    return struct.pack(">i", len(data)) + data + struct.pack(">i", len(data))


def block(name, kind, values):
    items = {"CHAR": lambda v: v.ljust(8).encode(), "INTE": lambda v: struct.pack(">i", v),
             "REAL": lambda v: struct.pack(">f", v), "DOUB": lambda v: struct.pack(">d", v)}[kind]
    most = 105 if kind == "CHAR" else 1000
    parts = [values[k:k + most] for k in range(0, len(values), most)]
    head = record(struct.pack(">8si4s", name.ljust(8).encode(), len(values), kind.encode()))
    return head + b"".join(record(b"".join(map(items, part))) for part in parts)


class Reader(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.stem = pathlib.Path(self.folder.name) / "CASE"

    def test_vectors_and_units(self):
        spec = block("KEYWORDS", "CHAR", ["TIME", "FPR", "WWIR"]) + block("WGNAMES", "CHAR", [":+:+:+:+", "", "INJ"])
        spec += block("UNITS", "CHAR", ["DAYS", "BARSA", "SM3/DAY"])
        pathlib.Path(f"{self.stem}.SMSPEC").write_bytes(spec)
        steps = block("SEQHDR", "INTE", [1])
        for k in range(3):
            steps += block("MINISTEP", "INTE", [k]) + block("PARAMS", "REAL", [float(k), 250.0 + k, 2.0 * k])
        pathlib.Path(f"{self.stem}.UNSMRY").write_bytes(steps)
        vectors, units = read_summary(self.stem)
        self.assertEqual(vectors, {"TIME": [0, 1, 2], "FPR": [250, 251, 252], "WWIR:INJ": [0, 2, 4]})
        self.assertEqual(units["WWIR:INJ"], "SM3/DAY")

    def test_long_blocks_and_types(self):
        path = f"{self.stem}.X"
        texts, numbers = [f"T{k}" for k in range(300)], [0.5 * k for k in range(2500)]
        pathlib.Path(path).write_bytes(block("TEXTS", "CHAR", texts) + block("NUMBERS", "DOUB", numbers))
        self.assertEqual(read_blocks(path), [("TEXTS", texts), ("NUMBERS", numbers)])

    def test_damage_is_refused(self):
        path = pathlib.Path(f"{self.stem}.X")
        whole = block("NUMBERS", "REAL", [1.0, 2.0])
        for damaged in (whole[:-3], whole[1:], b"text that is no such file"):
            path.write_bytes(damaged)
            with self.assertRaises((ValueError, struct.error)):
                read_blocks(path)


unittest.main()
