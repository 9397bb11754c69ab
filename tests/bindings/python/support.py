"""What the tests share: the small case, and a record of the functions called."""
import pathlib

import hfrac
from hfrac import _library

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parent / "small.toml"
SYMBOLS = HERE.parents[2] / "capi/abi/symbols.txt"

_called = set()


def declared_functions():
    return set(SYMBOLS.read_text().split())


def called_functions():
    return set(_called)


def watch_calls():
    """Puts a note-taker before every function of the loaded library."""
    library = _library.load()

    def noting(name, function):
        def noted(*arguments):
            _called.add(name)
            return function(*arguments)

        return noted

    for name in declared_functions():
        setattr(library, name, noting(name, getattr(library, name)))


def small(**options):
    """The small case, ready to step."""
    return hfrac.Simulation(CASE, **options)


def plain(array):
    """An array of any kind as nested lists."""
    if hasattr(array, "tolist"):
        return array.tolist()
    return [list(row) if hasattr(row, "__len__") else row for row in array]
