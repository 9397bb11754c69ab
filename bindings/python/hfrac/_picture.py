# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a simulation as it stands, by the renderer (libhfrac_viz), for notebooks and reports.

The renderer reads run folders. So what there is of the model now - discs, bonds, cracks, domains - is written as the one
snapshot of a folder that lives as long as the drawing takes: VTU files in plain text, with the names that `hfrac run` uses.
"""
import ctypes
import os
import pathlib
import tempfile
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Sequence, Tuple

from ._library import library_path
from .errors import HfracError, LibraryError

if TYPE_CHECKING:
    from ._simulation import Simulation

_Array = Tuple[str, int, Iterable[Any]]  # name, components, values
_CELL_TYPES = {"vertex": 1, "line": 3, "polygon": 7}


class _ViewOptions(ctypes.Structure):
    """The beginning of hfrac_viz_view_options; the renderer fills in the rest."""

    _fields_ = [(name, ctypes.c_int32) for name in
                ("struct_size", "struct_version", "snapshot", "width", "height", "dots_per_inch", "dark", "zoom")]


def _renderer() -> Any:
    beside = pathlib.Path(library_path()).parent
    reasons = []
    for place in (os.environ.get("HFRAC_VIZ_LIBRARY"), str(beside / "libhfrac_viz.so.0"), "libhfrac_viz.so.0"):
        try:
            if place:
                return ctypes.CDLL(place)
        except OSError as error:
            reasons.append(str(error))
    raise LibraryError(f"the renderer, libhfrac_viz, was not found; pictures need it. Tried: {'; '.join(reasons)}")


def _array(name: str, components: int, values: Iterable[Any], kind: str = "Float64") -> str:
    text = " ".join(map(repr, values))
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">{text}</DataArray>'


def _vtu(points: Sequence[Tuple[float, float]], cells: Sequence[Sequence[int]], cell: str, point_data: List[_Array],
         cell_data: List[_Array]) -> str:
    ends, at = [], 0
    for corners in cells:
        at += len(corners)
        ends.append(at)
    flat = [value for x, y in points for value in (x, y, 0.0)]
    return "\n".join([
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>',
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><Points>',
        _array("Points", 3, flat), "</Points><Cells>",
        _array("connectivity", 1, (corner for corners in cells for corner in corners), "Int64"),
        _array("offsets", 1, ends, "Int64"), _array("types", 1, [_CELL_TYPES[cell]] * len(cells), "UInt8"),
        "</Cells><PointData>", *(_array(*data) for data in point_data),
        "</PointData><CellData>", *(_array(*data) for data in cell_data),
        "</CellData></Piece></UnstructuredGrid></VTKFile>", ""])


def _numbers(array: Any) -> List[Any]:
    """An array of any kind as a flat list of Python numbers."""
    rows = array.tolist() if hasattr(array, "tolist") else list(array)
    return [value for row in rows for value in (row if hasattr(row, "__len__") else (row,))]


def _pairs(values: List[Any]) -> List[Tuple[Any, Any]]:
    return list(zip(values[::2], values[1::2]))


def _grids(sim: "Simulation") -> Dict[str, str]:
    def field(name: str) -> List[Any]:
        return _numbers(sim.field(name))

    places = _pairs(field("disc.position"))
    flat = [part for x, y in _pairs(field("disc.displacement")) for part in (x, y, 0.0)]
    discs: List[_Array] = [
        ("radius_m", 1, field("disc.radius")), ("displacement_m", 3, flat), ("rotation_rad", 1, field("disc.rotation")),
        ("stress_Pa", 3, field("disc.stress")), ("intact_bonds", 1, map(float, field("disc.intact_bonds")))]
    bonds: List[_Array] = [
        ("state", 1, map(float, field("bond.state"))), ("normal_force_N", 1, field("bond.normal_force")),
        ("gap_m", 1, field("bond.gap")), ("aperture_m", 1, field("pipe.aperture"))]

    ends: List[Tuple[float, float]] = []
    cracks: Dict[str, List[float]] = {"mode": [], "aperture_m": [], "time_s": [], "fracture": []}
    for crack in sim.cracks:
        (x, y), (nx, ny), half = crack.position, crack.normal, 0.5 * float(crack.length)
        ends += [(float(x + half * ny), float(y - half * nx)), (float(x - half * ny), float(y + half * nx))]
        for name, value in zip(cracks, (crack.mode, crack.aperture, crack.time, crack.fracture)):
            cracks[name].append(float(value))

    corners, starts, kind = field("domain.corners"), field("domain.corner_offset"), field("domain.kind")
    bounds = [*starts, len(corners)]
    inside = [d for d in range(len(starts)) if kind[d] != 2]  # 2: the outside, which is no polygon
    pressure, volume = field("domain.pressure"), field("domain.volume")
    flow: List[_Array] = [("pressure_Pa", 1, [pressure[d] for d in inside]), ("volume_m2", 1, [volume[d] for d in inside]),
                          ("kind", 1, [float(kind[d]) for d in inside])]
    polygons = [corners[bounds[d]:bounds[d + 1]] for d in inside]
    return {
        "discs": _vtu(places, [(k,) for k in range(len(places))], "vertex", discs, []),
        "bonds": _vtu(places, _pairs(field("bond.discs")), "line", [], bonds),
        "cracks": _vtu(ends, _pairs(list(range(len(ends)))), "line", [], [(n, 1, v) for n, v in cracks.items()]),
        "flow": _vtu(places, polygons, "polygon", [], flow),
    }


def draw(sim: "Simulation", views: Sequence[str], width: int) -> bytes:
    """The PNG file's bytes."""
    renderer, options = _renderer(), _ViewOptions()
    error = ctypes.create_string_buffer(2048)
    status = renderer.hfrac_viz_view_options_init(ctypes.byref(options), ctypes.sizeof(options))
    options.width = width
    with tempfile.TemporaryDirectory(prefix="hfrac-picture-") as name:
        folder = pathlib.Path(name)
        for series, text in _grids(sim).items():
            (folder / f"{series}_00000.vtu").write_text(text)
            (folder / f"{series}.pvd").write_text(
                '<VTKFile type="Collection" version="0.1" byte_order="LittleEndian"><Collection>\n'
                f'<DataSet timestep="{sim.time!r}" group="" part="0" file="{series}_00000.vtu"/>\n</Collection></VTKFile>\n')
        picture = folder / "picture.png"
        names = (ctypes.c_char_p * len(views))(*(view.encode() for view in views))
        if status >= 0:
            status = renderer.hfrac_viz_render_named_views(os.fsencode(folder), names, len(views), os.fsencode(picture),
                                                           ctypes.byref(options), error, len(error), None)
        if status < 0:
            raise HfracError(error.value.decode(errors="replace") or f"the renderer gave status {status}")
        return picture.read_bytes()
