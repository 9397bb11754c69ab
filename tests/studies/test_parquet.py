#!/usr/bin/python3
"""Parquet files as another program reads them: hyparquet (npm) where node and the npm registry are there; the file's frame by itself."""
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile
import unittest

from hfrac.study.parquet import parquet

READER = "hyparquet@1.31.5"
SHOW = """
import fs from 'node:fs';
import { parquetMetadata, parquetReadObjects } from './package/src/index.js';
const bytes = fs.readFileSync('table.parquet');
const file = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const types = parquetMetadata(file).schema.slice(1).map(({ name, type, converted_type }) => [name, type, converted_type ?? null]);
const rows = await parquetReadObjects({ file });
console.log(JSON.stringify([types, rows], (_, value) => (typeof value === 'bigint' ? Number(value) : Number.isNaN(value) ? 'NaN' : value)));
"""
NAMES = ["run", "K_Ic", "packing", "law", "status", "sentence"] + [f"result_{k}_Pa" for k in range(20)]  # more than a short list of Thrift's holds
ROWS = [[k, 1.5e6 + 0.1 * k, 3 if k % 2 else float("nan"), "rough" if k else 7, "done", "" if k else "größer, \"so\"", *(k - 0.5 * j for j in range(20))]
        for k in range(300)]


class Parquet(unittest.TestCase):
    def test_the_frame(self):
        for rows in ([], ROWS):
            file = parquet(NAMES, rows)
            self.assertEqual((file[:4], file[-4:]), (b"PAR1", b"PAR1"))
            (length,) = struct.unpack("<i", file[-8:-4])
            self.assertIn(b"result_19_Pa", file[-8 - length:-8])
            self.assertEqual(file[-9], 0, "the list of contents ends as a struct does")

    def test_read_by_another_program(self):
        node, npm = shutil.which("node"), shutil.which("npm")
        if not node or not npm:
            self.skipTest("there is no node or npm here, so nobody else reads the file")
        with tempfile.TemporaryDirectory(prefix="hfrac-studies-") as top:
            got = subprocess.run([npm, "pack", "--prefer-offline", READER], cwd=top, capture_output=True, text=True, timeout=120)
            if got.returncode != 0:
                self.skipTest(f"the npm registry gives no {READER}")
            with tarfile.open(pathlib.Path(top, got.stdout.split()[-1])) as archive:
                archive.extractall(top)
            pathlib.Path(top, "table.parquet").write_bytes(parquet(NAMES, ROWS))
            pathlib.Path(top, "show.mjs").write_text(SHOW)
            done = subprocess.run([node, "show.mjs"], cwd=top, capture_output=True, text=True, timeout=60, env={**os.environ, "NODE_OPTIONS": ""})
            self.assertEqual(done.returncode, 0, done.stderr)
        types, rows = json.loads(done.stdout)
        text = "BYTE_ARRAY", "UTF8"
        self.assertEqual([tuple(one) for one in types[:6]], [("run", "INT64", None), ("K_Ic", "DOUBLE", None), ("packing", "DOUBLE", None),
                                                             ("law", *text), ("status", *text), ("sentence", *text)])
        self.assertEqual(len(rows), len(ROWS))
        for row, wanted in zip(rows, ROWS):
            for name, value in zip(NAMES, wanted):
                value = str(value) if name == "law" else "NaN" if isinstance(value, float) and math.isnan(value) else value
                self.assertEqual(row[name], value, name)


if __name__ == "__main__":
    sys.exit(unittest.main())
