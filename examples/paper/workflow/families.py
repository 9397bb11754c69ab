"""Case families into runs: every value of every series of a family, times the packings, is one run with one case file.

A family (examples/paper/families/*.toml) names the parts its cases are put together from, what it sets itself, and in
each series one option that varies. Families whose cases come out equal share the run. A family may name its packings
(seeds), the sets it belongs to (sets, all otherwise), and end its runs at an area of open fractures
(until_fracture_area).
"""
import copy
import dataclasses
import functools
import json
import pathlib
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
FAMILIES = HERE.parent / "families"
SEEDS = (1, 2, 3, 4, 5, 6)

# What the sets change. Thinned series keep the ends and the middle.
SETS = {
    "full": {"seeds": SEEDS},
    "fast": {"seeds": SEEDS[:2], "thin": "all"},
    # A finer picture of the same rock: strengths at constant toughness (V8), everything else as it was. Half the
    # packings, and three values of each series that is judged by a slope: it is asked whether means move with resolution.
    "fine": {
        "seeds": SEEDS[:3],
        "thin": "slopes",
        "set": {"packing": {"disc_count": 10000}, "bond": {"toughness_reference_radius": 1.14}},
    },
    # The same with a fracture that is a face between two flanks (docs/theory.md) in place of broken contacts.
    "facets": {"seeds": SEEDS[:3], "thin": "slopes", "set": {"fracture": {"law": "facet"}}},
}
SLOPES = {"ramp", "convention-total"}  # parts of the families judged by a slope of the initiation pressure


@dataclasses.dataclass(frozen=True)
class Point:
    """One value of one series of one family in one packing: a place in a figure."""

    family: str
    series: str
    x: float
    seed: int
    run: str  # the run that answers it


@dataclasses.dataclass(frozen=True)
class Run:
    name: str
    packing: str
    case: dict
    pictures: bool
    priority: int
    until: float | None  # m2; the run ends when its fractures are this open, in all


def merged(base, over):
    """`base` with the tables of `over` laid over it; of wells there is one, so lists are merged entry by entry."""
    result = copy.deepcopy(base)
    for key, value in over.items():
        if isinstance(value, dict) and isinstance(result.get(key), list):
            value = [value]
        if isinstance(value, dict):
            result[key] = merged(result.get(key, {}), value)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            result[key] = [merged(old, new) for old, new in zip(result.get(key, [{}]), value)]
        else:
            result[key] = value
    return result


def nested(key, value):
    for name in reversed(key.split(".")):
        value = {name: value}
    return value


@functools.cache
def read(name):
    return tomllib.loads((FAMILIES / f"{name}.toml").read_text())


def row_of(table, temperature):
    rows = [row for row in read(table)["row"] if row["temperature"] == temperature]
    if len(rows) != 1:
        raise ValueError(f"{table}.toml has no row for {temperature} C")
    return {key: value for key, value in rows[0].items() if key != "temperature"}


def as_toml(case):
    """A case file: one table a section, wells as an array of tables."""
    lines = []
    scalars = {key: value for key, value in case.items() if not isinstance(value, (dict, list))}
    lines += [f"{key} = {json.dumps(value)}" for key, value in scalars.items()]
    for section, content in case.items():
        if section in scalars:
            continue
        head = f"[[{section}]]" if isinstance(content, list) else f"[{section}]"
        for table in content if isinstance(content, list) else [content]:
            lines += ["", head] + [f"{key} = {json.dumps(value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def family_names():
    return sorted(path.stem for path in FAMILIES.glob("*.toml") if "series" in read(path.stem))


def cases_of(family, name, settings):
    """(series, x, seed, case) of each run of a family; series is a table of it."""
    base = {}
    for part in family["parts"]:
        base = merged(base, read(part))
    base = merged(merged(base, family.get("set", {})), settings.get("set", {}))
    for series in family["series"]:
        case = merged(base, series.get("set", {}))
        if "temperature" in series:
            case = merged(case, row_of("table-3", series["temperature"]))
        if series.get("strength_by_temperature"):
            case = merged(case, row_of("strength-by-temperature", series["temperature"]))
        values = series["values"]
        thin = settings.get("thin") == "all" or settings.get("thin") == "slopes" and SLOPES & set(family["parts"])
        if thin and len(values) > 3:
            values = [values[0], values[len(values) // 2], values[-1]]
        for value in values:
            varied = merged(case, nested(series["vary"], float(f"{value * series['scale']:.12g}")))
            for seed in family.get("seeds", settings["seeds"]):
                yield series, float(value), seed, merged(varied, {"model": {"seed": seed}})


def expand(which):
    """({name: run}, [points]) of the set `which`. A run's priority is the first of the families' that share it."""
    settings = SETS[which]
    runs, points, known = {}, [], {}
    for name in sorted(family_names(), key=lambda one: (read(one)["priority"], one)):
        family = read(name)
        if which not in family.get("sets", SETS):
            continue
        until = family.get("until_fracture_area")
        for series, x, seed, case in cases_of(family, name, settings):
            key = json.dumps([case, until], sort_keys=True)
            priority = series.get("priority", family["priority"])
            if key not in known:
                word = f"{name}-{series['name']}-{x:g}-s{seed}".replace(" ", "")
                known[key] = word
                packing = f"{case['packing']['disc_count']}-{case['packing']['porosity']}-{seed}"
                titled = {"title": family["title"].replace("{x}", f"{x:g}"), **case}
                runs[word] = Run(word, packing, titled, family.get("pictures", False), priority, until)
            run = runs[known[key]]
            runs[run.name] = dataclasses.replace(run, priority=min(priority, run.priority))
            points.append(Point(name, series["name"], x, seed, run.name))
    return runs, points


def packing_case(packing):
    """The case that packs only: no well, no stress, rigid walls. Its discs are those of every run of this packing."""
    disc_count, porosity, seed = packing.split("-")
    case = merged(read("table-1"), {"packing": {"disc_count": int(disc_count), "porosity": float(porosity)}})
    frame = {key: value for key, value in read("convention-effective").items() if key not in ("well", "output")}
    return merged(merged(case, frame), {"model": {"seed": int(seed)}})
