#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The folders of lib include downwards only, in the order that docs/architecture.md states.

    check_layers.py SOURCE_FOLDER

The order is that of the table under "Folders of lib": each row's folder may include those above it. Every #include of a header of
lib is read; one that points to a folder further down the table, to a folder the table does not name, or round a circle of
headers is reported with file and line, and the exit status is 1.
"""
import re
import sys
from pathlib import Path


def stated_order(page):
    text = page.read_text(encoding="utf-8")
    start = text.index("### Folders of `lib`")
    rows = []
    for line in text[start:].splitlines():
        row = re.match(r"\| `(\w+)` \|", line)
        if row:
            rows.append(row.group(1))
        elif rows and not line.startswith("|"):
            break
    return rows


def includes_of(lib):
    found = {}
    for file in sorted(lib.rglob("*")):
        if file.suffix not in (".hpp", ".cpp", ".inc"):
            continue
        name = file.relative_to(lib).as_posix()
        found[name] = [
            (number, match.group(1))
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
            if (match := re.match(r'\s*#include "([^"]+)"', line))
        ]
    return found


def circle_in(includes):
    state = {}

    def visit(name, way):
        state[name] = "open"
        for _, target in includes.get(name, ()):
            if state.get(target) == "open":
                return way + [name, target]
            if target in includes and target not in state:
                circle = visit(target, way + [name])
                if circle:
                    return circle
        state[name] = "done"
        return None

    for name in includes:
        if name not in state:
            circle = visit(name, [])
            if circle:
                return circle[circle.index(circle[-1]):]
    return None


def faults(order, includes):
    place = {folder: k for k, folder in enumerate(order)}
    found = []
    for folder in sorted({name.split("/")[0] for name in includes} - place.keys()):
        found.append(f"lib/{folder} is not in the table of docs/architecture.md")
    for name, targets in includes.items():
        here = name.split("/")[0]
        for number, target in targets:
            there = target.split("/")[0]
            if target not in includes:
                found.append(f"lib/{name}:{number} includes {target}, which is no header of lib")
            elif place.get(there, -1) > place.get(here, len(order)):
                found.append(f"lib/{name}:{number} includes {target}: {there} stands above {here}")
    circle = circle_in(includes)
    if circle:
        found.append("headers include each other in a circle: " + " -> ".join(circle))
    return found


def test_of_the_test():
    """What must be found is found."""
    order = ["low", "high"]
    assert not faults(order, {"low/a.hpp": [], "high/b.hpp": [(1, "low/a.hpp")]})
    assert faults(order, {"low/a.hpp": [(3, "high/b.hpp")], "high/b.hpp": []})
    assert faults(order, {"low/a.hpp": [(1, "low/c.hpp")], "low/c.hpp": [(1, "low/a.hpp")]})
    assert faults(order, {"new/a.hpp": []})
    assert faults(order, {"low/a.hpp": [(1, "gone.hpp")]})


def main():
    test_of_the_test()
    root = Path(sys.argv[1])
    order = stated_order(root / "docs" / "architecture.md")
    includes = includes_of(root / "lib")
    missing = [folder for folder in order if not (root / "lib" / folder).is_dir()]
    found = [f"docs/architecture.md names lib/{folder}, which is not there" for folder in missing]
    found += faults(order, includes)
    for fault in found:
        print(fault)
    if not order or len(includes) < 100:
        print("nothing was read: is the table still under '### Folders of `lib`'?")
        return 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
