"""Pictures for notebooks: by the renderer where there is one, a text otherwise."""
import ctypes
import pathlib
import struct
import unittest
from unittest import mock

import hfrac
from hfrac import _library
from support import small


def renderer_is_there():
    try:
        ctypes.CDLL(str(pathlib.Path(_library.library_path()).parent / "libhfrac_viz.so.0"))
    except OSError:
        return False
    return True


def size_of(png):
    return struct.unpack(">II", png[16:24])


@unittest.skipUnless(renderer_is_there(), "the renderer is not built")
class Picture(unittest.TestCase):
    def test_is_a_png_of_the_width_asked_for(self):
        with small() as sim:
            sim.step(5)
            before = sim.state_hash
            for views in ((), ("pressure",), ("discs", "aperture")):
                with self.subTest(views=views):
                    png = sim.picture(*views, width=640)
                    self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
                    self.assertEqual(size_of(png)[0], 640)
            self.assertEqual(sim.state_hash, before, "looking changes nothing")

    def test_shows_how_it_stands_now(self):
        with small() as sim:
            for view in ("pressure", "displacement"):
                with self.subTest(view=view):
                    first = sim.picture(view, width=640)
                    self.assertEqual(sim.picture(view, width=640), first)
                    sim.step(5)
                    self.assertNotEqual(sim.picture(view, width=640), first, "the same picture after five steps")

    def test_a_notebook_gets_it(self):
        sim = small()
        self.assertEqual(size_of(sim._repr_png_())[0], 800)
        sim.close()
        self.assertIsNone(sim._repr_png_(), "a closed one has its repr")

    def test_wrong_use_has_a_text(self):
        with small() as sim:
            with self.assertRaisesRegex(hfrac.HfracError, "nonsense"):
                sim.picture("nonsense")
            with self.assertRaisesRegex(hfrac.HfracError, "320"):
                sim.picture(width=3)


class WithoutARenderer(unittest.TestCase):
    def test_a_notebook_shows_the_text(self):
        absent = mock.patch("ctypes.CDLL", side_effect=OSError("no such file"))
        with small() as sim, absent:
            self.assertIsNone(sim._repr_png_())
            with self.assertRaisesRegex(hfrac.LibraryError, "libhfrac_viz"):
                sim.picture()
