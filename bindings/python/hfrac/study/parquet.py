# SPDX-License-Identifier: BSD-3-Clause
"""A table as an Apache Parquet file (format 2.10, parquet.thrift), by itself, since Debian has no package that writes one.

As little of the format as a table of some thousand rows needs: one row group, one page a column, values as they are (PLAIN, not compressed), no
value missing: what is not known is NaN, or an empty text. Columns are INT64, DOUBLE or UTF-8 texts. The list of contents at the end is written in
Thrift's compact protocol: a field is its number less that of the field before and its type, a whole number is zigzag and seven bits a byte.
"""
import struct
from typing import Any, List, Sequence, Tuple

_I32, _I64, _BINARY, _LIST, _STRUCT = 5, 6, 8, 9, 12  # types of the compact protocol
_INT64, _DOUBLE, _BYTE_ARRAY = 2, 5, 6  # of parquet.thrift
Field = Tuple[int, int, Any]  # number, type, value; of a list (type of its items, items)


def _varint(value: int) -> bytes:
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def _value(kind: int, value: Any) -> bytes:
    if kind in (_I32, _I64):
        return _varint(2 * value if value >= 0 else -2 * value - 1)
    if kind == _BINARY:
        return _varint(len(value.encode())) + value.encode()
    if kind == _LIST:
        of, items = value
        head = bytes([len(items) << 4 | of]) if len(items) < 15 else bytes([0xF0 | of]) + _varint(len(items))
        return head + b"".join(_value(of, item) for item in items)
    return _struct(value)


def _struct(fields: Sequence[Field]) -> bytes:
    out, before = b"", 0
    for number, kind, value in fields:
        out += bytes([(number - before) << 4 | kind]) + _value(kind, value)
        before = number
    return out + b"\0"


def _column(values: Sequence[Any]) -> Tuple[int, bytes]:
    """Its type and its values."""
    if any(isinstance(value, str) for value in values):
        texts = [("" if value is None or value != value else str(value)).encode() for value in values]
        return _BYTE_ARRAY, b"".join(struct.pack("<i", len(text)) + text for text in texts)
    if all(isinstance(value, int) for value in values):
        return _INT64, struct.pack(f"<{len(values)}q", *values)
    return _DOUBLE, struct.pack(f"<{len(values)}d", *(float("nan") if value is None else value for value in values))


def parquet(names: Sequence[str], rows: Sequence[Sequence[Any]]) -> bytes:
    """The file's bytes. Rows hold numbers and texts; None is not known."""
    count = len(rows)
    out = b"PAR1"
    schema: List[Sequence[Field]] = [[(4, _BINARY, "table"), (5, _I32, len(names))]]
    chunks: List[Sequence[Field]] = []
    for k, name in enumerate(names):
        kind, values = _column([row[k] for row in rows])
        page = [(1, _I32, count), (2, _I32, 0), (3, _I32, 3), (4, _I32, 3)]  # PLAIN; levels by RLE, of which there are none
        head = _struct([(1, _I32, 0), (2, _I32, len(values)), (3, _I32, len(values)), (5, _STRUCT, page)])
        size = len(head) + len(values)
        meta = [(1, _I32, kind), (2, _LIST, (_I32, [0, 3])), (3, _LIST, (_BINARY, [name])), (4, _I32, 0), (5, _I64, count),
                (6, _I64, size), (7, _I64, size), (9, _I64, len(out))]
        chunks.append([(2, _I64, len(out)), (3, _STRUCT, meta)])
        text = [(6, _I32, 0)] if kind == _BYTE_ARRAY else []  # UTF8
        schema.append([(1, _I32, kind), (3, _I32, 0), (4, _BINARY, name), *text])  # REQUIRED
        out += head + values
    group = [(1, _LIST, (_STRUCT, chunks)), (2, _I64, len(out) - 4), (3, _I64, count)]
    end = _struct([(1, _I32, 1), (2, _LIST, (_STRUCT, schema)), (3, _I64, count), (4, _LIST, (_STRUCT, [group])), (6, _BINARY, "hfrac")])
    return out + end + struct.pack("<i", len(end)) + b"PAR1"
