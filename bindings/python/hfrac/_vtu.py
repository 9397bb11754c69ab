# SPDX-License-Identifier: BSD-3-Clause
"""Reading the snapshots of a run folder: VTU files with arrays in base64, packed by zlib or not at all, and PVTU files, which list such
files as pieces of one grid.

Sizes before the data are 32 bits wide: number of blocks, size of a block, size of the last one, packed size of each; without
packing the number of bytes (the VTK file formats' XML chapter).
"""
import base64
import pathlib
import struct
import xml.etree.ElementTree as xml
import zlib
from typing import Any, Dict, List, Tuple

from .errors import FileError

KINDS = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}


def series(path: pathlib.Path) -> List[Tuple[float, str]]:
    """Time [s] and file of each entry of a .pvd list."""
    try:
        entries = xml.parse(path).getroot().iter("DataSet")
    except (OSError, xml.ParseError) as error:
        raise FileError(f"'{path}' cannot be read: {error}") from error
    return [(float(entry.attrib["timestep"]), entry.attrib["file"]) for entry in entries]


def _bytes(text: str, packed: bool) -> bytes:
    text = "".join(text.split())
    if not packed:
        return base64.b64decode(text)[4:]
    blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    size = 4 * (3 + blocks)
    head = -(-size // 3) * 4  # letters of the sizes, which are coded by themselves
    sizes = struct.unpack(f"<{3 + blocks}I", base64.b64decode(text[:head])[:size])[3:]
    data, first, parts = base64.b64decode(text[head:]), 0, []
    for one in sizes:
        parts.append(zlib.decompress(data[first:first + one]))
        first += one
    return b"".join(parts)


def _one_grid(pieces: List[Dict[str, Dict[str, Tuple[Any, str]]]]) -> Dict[str, Dict[str, Tuple[Any, str]]]:
    """Pieces one after the other; cells count points and corners from the first piece on."""
    import numpy

    whole: Dict[str, Dict[str, Tuple[Any, str]]] = {"FieldData": pieces[0]["FieldData"]}
    for section in ("Points", "PointData", "CellData", "Cells"):
        whole[section] = {}
        for name, (_, unit) in pieces[0][section].items():
            parts, before = [], 0
            for piece in pieces:
                shift = before if name in ("connectivity", "offsets") and section == "Cells" else 0
                parts.append(piece[section][name][0] + shift if shift else piece[section][name][0])
                before += len(next(iter(piece["Points"].values()))[0]) if name == "connectivity" else len(piece["Cells"]["connectivity"][0])
            whole[section][name] = (numpy.concatenate(parts), unit)
    return whole


def arrays(path: pathlib.Path) -> Dict[str, Dict[str, Tuple[Any, str]]]:
    """By section (Points, PointData, CellData, FieldData, Cells) and name: the array and its unit."""
    import numpy

    try:
        root = xml.parse(path).getroot()
    except (OSError, xml.ParseError) as error:
        raise FileError(f"'{path}' cannot be read: {error}") from error
    listed = [piece.attrib["Source"] for piece in root.iterfind("PUnstructuredGrid/Piece")]
    if any(pathlib.Path(file).suffix != ".vtu" for file in listed):
        raise FileError(f"'{path}' cannot be read: it lists a piece that is no VTU file")
    if listed:
        return _one_grid([arrays(path.parent / pathlib.Path(file).name) for file in listed])
    packer = root.attrib.get("compressor", "")
    if packer not in ("", "vtkZLibDataCompressor"):
        raise FileError(f"'{path}' is packed by {packer}; Python reads zlib and none: run with output.compression = \"zlib\"")
    found: Dict[str, Dict[str, Tuple[Any, str]]] = {}
    for section in ("Points", "PointData", "CellData", "FieldData", "Cells"):
        part = found.setdefault(section, {})
        for one in root.iterfind(f".//{section}/DataArray"):
            values = numpy.frombuffer(_bytes(one.text or "", bool(packer)), KINDS[one.attrib["type"]])
            width = int(one.attrib.get("NumberOfComponents", "1"))
            unit = one.findtext("InformationKey", "")
            part[one.attrib.get("Name", section)] = (values.reshape(-1, width) if width > 1 else values, unit)
    return found
