# SPDX-License-Identifier: BSD-3-Clause
"""Reads the summary of an Eclipse-type simulator: SMSPEC says what the vectors are, UNSMRY holds them.

Both are Fortran's unformatted files, big-endian: blocks of "name, number of items, type" followed by the items, every
record with its length before and after it. Items come in records of at most 1000 (105 texts).
"""
import pathlib
import struct

_SIZES = {"INTE": 4, "REAL": 4, "LOGI": 4, "DOUB": 8, "CHAR": 8, "MESS": 0}
_CODES = {"INTE": "i", "REAL": "f", "LOGI": "i", "DOUB": "d"}


def _record(data, at):
    """The bytes of the record that begins at `at`, and where the next one begins."""
    (length,) = struct.unpack_from(">i", data, at)
    end = at + 4 + length
    if length < 0 or end + 4 > len(data) or struct.unpack_from(">i", data, end)[0] != length:
        raise ValueError(f"no record at byte {at}: the file is cut off or of another kind")
    return data[at + 4:end], end + 4


def read_blocks(path):
    """Every block of a file as (name, values), in order."""
    data, at, blocks = pathlib.Path(path).read_bytes(), 0, []
    while at < len(data):
        head, at = _record(data, at)
        name, count, kind = struct.unpack(">8si4s", head)
        kind = kind.decode()
        if kind not in _SIZES:
            raise ValueError(f"{path}: type {kind} of {name.decode().strip()} is unknown")
        items = b""
        while len(items) < count * _SIZES[kind]:
            part, at = _record(data, at)
            items += part
        if kind == "CHAR":
            values = [items[k:k + 8].decode().strip() for k in range(0, len(items), 8)]
        else:
            values = list(struct.unpack(f">{count}{_CODES[kind]}", items)) if count and kind in _CODES else []
        blocks.append((name.decode().strip(), values))
    return blocks


def read_summary(stem):
    """The vectors of STEM.SMSPEC and STEM.UNSMRY: {"TIME": [...], "WWIR:INJ": [...]}; units by name: {"TIME": "DAYS"}."""
    spec = dict(read_blocks(f"{stem}.SMSPEC"))
    wells = spec.get("WGNAMES") or spec.get("NAMES")
    names = [
        f"{keyword}:{well}" if keyword[0] in "WG" and well and well != ":+:+:+:+" else keyword
        for keyword, well in zip(spec["KEYWORDS"], wells)
    ]
    vectors = {name: [] for name in names}
    for block, values in read_blocks(f"{stem}.UNSMRY"):
        if block == "PARAMS":
            for name, value in zip(names, values):
                vectors[name].append(value)
    return vectors, dict(zip(names, spec["UNITS"]))
