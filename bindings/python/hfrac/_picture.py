# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a simulation as it stands, by the renderer (libhfrac_viz), for notebooks and reports."""
import ctypes
import os
import pathlib
import tempfile
from typing import Any, Sequence

from ._library import library_path
from .errors import HfracError, LibraryError


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


def _require(renderer: Any, status: int) -> None:
    if status < 0:
        text = ctypes.create_string_buffer(4096)
        renderer.hfrac_viz_last_error(text, len(text), None)
        raise HfracError(text.value.decode(errors="replace") or f"the renderer gave status {status}")


def draw(sim: ctypes.c_void_p, views: Sequence[str], width: int) -> bytes:
    """The PNG file's bytes."""
    renderer, options = _renderer(), _ViewOptions()
    _require(renderer, renderer.hfrac_viz_view_options_init(ctypes.byref(options), ctypes.sizeof(options)))
    options.width = width
    names = (ctypes.c_char_p * len(views))(*(view.encode() for view in views))
    with tempfile.TemporaryDirectory(prefix="hfrac-picture-") as folder:
        picture = pathlib.Path(folder, "picture.png")
        _require(renderer, renderer.hfrac_viz_render_sim(sim, names, len(views), os.fsencode(picture),
                                                         ctypes.byref(options)))
        return picture.read_bytes()
