#!/usr/bin/python3
"""All tests of the Python package, and a check that they call every function of the C interface.

usage: run_tests.py [--without-numpy]     HFRAC_LIBRARY names the library, HFRAC_REPORT the program of report.c
"""
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
if "--without-numpy" in sys.argv:
    sys.modules["numpy"] = None  # import numpy fails, as where it is not installed

from support import called_functions, declared_functions, watch_calls  # noqa: E402

watch_calls()
suite = unittest.defaultTestLoader.discover(str(HERE), "test_*.py")
passed = unittest.TextTestRunner(verbosity=1).run(suite).wasSuccessful()
missing = sorted(declared_functions() - called_functions())
for name in missing:
    print(f"{name} is not called from Python", file=sys.stderr)
print(f"numpy: {'absent' if sys.modules.get('numpy') is None else sys.modules['numpy'].__version__}")
sys.exit(0 if passed and not missing else 1)
