#!/usr/bin/python3
"""Every public function has a comment of its own that ends with its mark: "Stable since 0.1.", "Unstable since 0.2.",
"Deprecated since 0.3, to be removed in 1.0." A stable function keeps its meaning until it is deprecated; an unstable one
may change with any minor version, and is hidden unless the host asks for it: it is declared HFRAC_UNSTABLE_API, all others
HFRAC_API. No mark is of a version that is yet to come.

usage: check_marks.py [--write]     --write: puts the right one of the two in front of every function
"""
import re
import sys

from c_header import HEADERS, functions

MARK = re.compile(r"(?:Stable|Unstable) since (\d+)\.(\d+)\.|Deprecated since (\d+)\.(\d+), to be removed in \d+\.\d+\.")
DECLARED = re.compile(r"((?:/\*\*(?:(?!\*/).)*\*/\s*)?)^(HFRAC_\w*API) int32_t (\w+)\(", re.S | re.M)


def release():
    text = "".join(path.read_text() for path in HEADERS)
    return tuple(int(re.search(rf"HFRAC_VERSION_{part} (\d+)", text)[1]) for part in ("MAJOR", "MINOR"))


def plain(comment):
    return " ".join(re.sub(r"^/\*\*|\*/$", "", comment.strip()).replace("*", " ").split())


def visibility(comment):
    mark = list(MARK.finditer(plain(comment)))
    return "HFRAC_UNSTABLE_API" if mark and mark[-1][0].startswith("Unstable") else "HFRAC_API"


def write():
    for path in HEADERS:
        text = path.read_text()
        path.write_text(DECLARED.sub(lambda m: f"{m[1]}{visibility(m[1])} int32_t {m[3]}(", text))


def main():
    if "--write" in sys.argv:
        write()
    problems, seen = [], []
    for path in HEADERS:
        for comment, shown, name in DECLARED.findall(path.read_text()):
            seen.append(name)
            text = plain(comment)
            if shown != visibility(comment):
                problems.append(f"{path.name}: {name} is to be declared {visibility(comment)} (check_marks.py --write)")
            mark = list(MARK.finditer(text))
            if not text:
                problems.append(f"{path.name}: {name} has no comment")
            elif not mark or mark[-1].end() != len(text):
                problems.append(f"{path.name}: the comment of {name} does not end with its mark")
            elif tuple(int(number) for number in mark[-1].groups() if number) > release():
                problems.append(f"{path.name}: {name} is marked with a version yet to come")
    problems += [f"{name} was not looked at" for name in sorted(set(functions()) - set(seen))]
    sys.exit("\n".join(problems) or 0)


main()
