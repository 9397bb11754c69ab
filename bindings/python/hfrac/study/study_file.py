# SPDX-License-Identifier: BSD-3-Clause
"""The study file: what is refused is refused here, in a sentence with the key and what would be right.

    case = "fracture.toml"          # base case, beside this file
    runs = 200                      # asked for; a grid, saltelli and one-at-a-time make their own number of it
    sampling = "sobol"              # sobol, latin-hypercube, random, grid, saltelli, one-at-a-time
    seed = 1                        # of the sampling
    packings = [1, 2, 3]            # model.seed: each sample in each of these packings, of a match each member in one; left out: the case's own
    [set]                           # over the base case, in every run
    [[parameter]]                   # what varies (laws.py)
    [[quantity]]                    # a further result (measures.py)
    [match]                         # of hfrac match (match_file.py)
"""
import difflib
import math
import pathlib
import tomllib
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from .laws import KEYS, Parameter

SAMPLINGS = ("sobol", "latin-hypercube", "random", "grid", "saltelli", "one-at-a-time")
TAKES = ("last", "first", "largest", "smallest", "mean", "at")


class StudyError(ValueError):
    """The study file, or what it asks for, is wrong; the text names the key. ``heading``: what to read of docs/studies.md."""

    heading = "the-study-file"


class Quantity(NamedTuple):
    """A result read from a column of history.csv."""

    name: str
    column: str
    take: str
    time: float


class Study(NamedTuple):
    """A study file, checked."""

    path: pathlib.Path
    case: pathlib.Path
    runs: int
    sampling: str
    seed: int
    packings: Tuple[int, ...]
    settings: Dict[str, Any]
    parameters: Tuple[Parameter, ...]
    quantities: Tuple[Quantity, ...]
    keep_fields: bool
    match: Optional[Mapping[str, Any]]


class Reader:
    """A table of the file whose keys are taken one by one; what is left at the end is refused."""

    def __init__(self, where: str, table: Any) -> None:
        if not isinstance(table, dict):
            raise StudyError(f"{where} must be a table, not {table!r}")
        self.where, self.table, self.known = where, table, []  # type: str, Dict[str, Any], List[str]

    def fail(self, key: str, text: str) -> StudyError:
        return StudyError(f"{self.where}{key} {text}")

    def take(self, key: str, kind: Any, word: str, default: Any = None, needed: bool = False) -> Any:
        self.known.append(key)
        if key not in self.table:
            if needed:
                raise self.fail(key, f"is missing; give {word}")
            return default
        value = self.table[key]
        if isinstance(value, bool) != (kind is bool) or not isinstance(value, kind):
            raise self.fail(key, f"= {value!r} must be {word}")
        return value

    def number(self, key: str, low: float, high: float, default: Any = None, needed: bool = False) -> float:
        value = self.take(key, (int, float), "a number", default, needed)
        if key in self.table and not (math.isfinite(value) and low <= value <= high):
            raise self.fail(key, f"= {value!r} must be a number from {low:g} to {high:g}")
        return value

    def integer(self, key: str, low: int, high: int, default: Any = None) -> int:
        value = self.take(key, int, "a whole number", default)
        if value is not None and not low <= value <= high:
            raise self.fail(key, f"= {value!r} must be a whole number from {low} to {high}")
        return value

    def word(self, key: str, words: Sequence[str], default: Any = None) -> str:
        value = self.take(key, str, f"one of {', '.join(words)}", default, default is None)
        if value not in words:
            raise self.fail(key, f"= {value!r} must be one of {', '.join(words)}")
        return value

    def end(self) -> None:
        for key in self.table:
            if key not in self.known:
                near = difflib.get_close_matches(key, self.known, 1)
                hint = f"did you mean {near[0]}?" if near else f"known here are {', '.join(self.known)}"
                raise self.fail(key, f"is not known; {hint}")


def _parameter(index: int, table: Any) -> Parameter:
    part = Reader(f"parameter[{index}].", table)
    option = part.take("option", str, "the key of an option, \"stress.sigma_hmin\"")
    options = part.take("options", list, "a list of keys of options", [option] if option else None)
    if not options or (option and options != [option]) or not all(isinstance(one, str) for one in options):
        raise part.fail("option", "or options must name what takes the value: one key, or a list of keys")
    name = part.take("name", str, "a word", options[0])
    law = part.word("law", tuple(KEYS))
    numbers: List[Any] = []
    for key in KEYS[law]:
        if key == "values":
            numbers.append(part.take(key, list, "a list of values", needed=True))
        else:
            numbers.append(part.number(key, -1e300, 1e300, needed=True))
    levels = part.integer("levels", 1, 1000, 3)
    part.end()
    if law == "list" and (not numbers[0] or not all(isinstance(one, (int, float, str)) for one in numbers[0])):
        raise part.fail("values", f"= {numbers[0]!r} must be numbers or words, at least one")
    if law in ("uniform", "loguniform") and not numbers[0] < numbers[1]:
        raise part.fail("high", f"= {numbers[1]!r} must be above low = {numbers[0]!r}")
    if law in ("loguniform", "lognormal") and not numbers[0] > 0.0:
        raise part.fail(KEYS[law][0], f"= {numbers[0]!r} must be above 0 for a logarithmic law")
    if law in ("normal", "lognormal") and not numbers[1] > 0.0:
        raise part.fail("deviation", f"= {numbers[1]!r} must be above 0")
    return Parameter(name, tuple(options), law, tuple(numbers), levels)


def _quantity(index: int, table: Any) -> Quantity:
    part = Reader(f"quantity[{index}].", table)
    name = part.take("name", str, "a word", needed=True)
    column = part.take("column", str, "a column of history.csv", needed=True)
    take = part.word("take", TAKES, "last")
    time = part.number("time", 0.0, 1e12, needed=take == "at")
    part.end()
    return Quantity(name, column, take, time)


def _each(path: str, top: Reader, key: str, read: Any) -> Tuple[Any, ...]:
    items = tuple(read(index, table) for index, table in enumerate(top.take(key, list, f"[[{key}]] tables", [])))
    names = [item.name for item in items]
    for name in names:
        if names.count(name) > 1:
            raise StudyError(f"{key}.name {name!r} is there twice; give each its own")
    return items


def _flat(table: Mapping[str, Any], before: str = "") -> Dict[str, Any]:
    """[set] as keys of a case: tables in tables or keys with dots."""
    flat: Dict[str, Any] = {}
    for key, value in table.items():
        flat.update(_flat(value, f"{before}{key}.") if isinstance(value, dict) else {before + key: value})
    return flat


def read_study(path: pathlib.Path) -> Study:
    """The study in the file. Raises StudyError."""
    path = pathlib.Path(path)
    try:
        content = tomllib.loads(path.read_text())
    except OSError as error:
        raise StudyError(f"'{path}' cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"'{path}' is not TOML: {error}") from error
    try:
        return _study(path, Reader("", content))
    except StudyError as error:
        raise StudyError(f"{path}: {error}") from error


def _study(path: pathlib.Path, top: Reader) -> Study:
    case = path.parent / top.take("case", str, "the base case's file", needed=True)
    if not case.is_file():
        raise StudyError(f"case: there is no file '{case}'")
    runs = top.integer("runs", 1, 10_000_000, 64)
    sampling = top.word("sampling", SAMPLINGS, "sobol")
    seed = top.integer("seed", 0, 2**31 - 1, 1)
    packings = top.take("packings", list, "a list of whole numbers, values of model.seed", [])
    if not all(isinstance(one, int) and one >= 0 for one in packings) or len(set(packings)) < len(packings):
        raise StudyError(f"packings = {packings!r} must be different whole numbers, values of model.seed")
    settings = _flat(top.take("set", dict, "a table of options", {}))
    parameters = _each("parameter", top, "parameter", _parameter)
    quantities = _each("quantity", top, "quantity", _quantity)
    keep = top.take("keep_fields", bool, "true or false", False)
    match = top.take("match", dict, "a table", None)
    top.end()
    if not parameters:
        raise StudyError("[[parameter]] is missing; name at least one option that varies, with its law")
    return Study(path, case, runs, sampling, seed, tuple(packings), settings, parameters, quantities, keep, match)
