"""Finding the library, its version, its texts."""
import ctypes
import os
import pathlib
import subprocess
import sys
import unittest

import hfrac
from hfrac import _abi, _library, errors

PACKAGE = pathlib.Path(hfrac.__file__).resolve().parent.parent


def run(code, **variables):
    environment = {k: v for k, v in os.environ.items() if k != "HFRAC_LIBRARY"}
    environment.update(variables, PYTHONPATH=str(PACKAGE))
    command = [sys.executable, "-B", "-c", code]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


class Library(unittest.TestCase):
    def test_version(self):
        self.assertEqual(hfrac.version(), (_abi.VERSION_MAJOR, _abi.VERSION_MINOR, _abi.VERSION_PATCH))
        self.assertTrue(hfrac.build_info().startswith("hfrac "))
        self.assertIn("libhfrac", hfrac.library_path())
        self.assertNotEqual(bool(hfrac.devices()), bool(hfrac.why_no_devices()))
        abi = ctypes.c_int32(-1)
        _library.call("hfrac_abi_version", ctypes.byref(abi))
        self.assertEqual(abi.value, _abi.ABI_VERSION)

    def test_a_table_of_solvers_begins_empty(self):
        solver = _abi.hfrac_linear_solver()
        _library.call("hfrac_linear_solver_init", ctypes.byref(solver), ctypes.sizeof(solver))
        self.assertEqual(solver.struct_size, ctypes.sizeof(solver))
        self.assertFalse(solver.prepare or solver.solve or solver.release or solver.reason)

    def test_status_texts_are_those_of_the_library(self):
        for status, text in _abi.STATUS_TEXTS.items():
            self.assertEqual(_library.status_text(status), text)

    def test_every_error_has_an_exception_of_its_own(self):
        kinds = {type(errors.error_of(status, "")) for status in _abi.Status if status < 0}
        self.assertEqual(len(kinds), sum(status < 0 for status in _abi.Status))
        self.assertNotIn(errors.HfracError, kinds)
        self.assertIs(type(errors.error_of(-77, "of a newer library")), errors.HfracError)

    def test_import_needs_no_library(self):
        result = run("import hfrac; print(hfrac.CrackMode.SHEAR.value)", HFRAC_LIBRARY="/nonexistent/libhfrac.so")
        self.assertEqual((result.stdout, result.stderr), ("2\n", ""))

    def test_a_wrong_path_is_named(self):
        result = run("import hfrac; hfrac.version()", HFRAC_LIBRARY="/nonexistent/libhfrac.so")
        self.assertIn("LibraryError: HFRAC_LIBRARY=/nonexistent/libhfrac.so cannot be loaded", result.stderr)

    def test_another_library_is_refused(self):
        result = run("import hfrac; hfrac.version()", HFRAC_LIBRARY="libc.so.6")
        self.assertIn("LibraryError", result.stderr)

    def test_every_public_name_is_there(self):
        for name in hfrac.__all__:
            self.assertTrue(hasattr(hfrac, name), name)
