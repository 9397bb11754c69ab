#!/usr/bin/python3
"""Every public function has a comment of its own that ends with its mark: "Stable since 0.1.", "Unstable since 0.2.",
"Deprecated since 0.3, to be removed in 1.0." A stable function keeps its meaning until it is deprecated; an unstable one
may change with any minor version. No mark is of a version that is yet to come.
"""
import re
import sys

from c_header import HEADERS, functions

MARK = re.compile(r"(?:Stable|Unstable) since (\d+)\.(\d+)\.|Deprecated since (\d+)\.(\d+), to be removed in \d+\.\d+\.")
DECLARED = re.compile(r"((?:/\*\*(?:(?!\*/).)*\*/\s*)?)^HFRAC_API int32_t (\w+)\(", re.S | re.M)


def release():
    text = "".join(path.read_text() for path in HEADERS)
    return tuple(int(re.search(rf"HFRAC_VERSION_{part} (\d+)", text)[1]) for part in ("MAJOR", "MINOR"))


def main():
    problems, seen = [], []
    for path in HEADERS:
        for comment, name in DECLARED.findall(path.read_text()):
            seen.append(name)
            text = " ".join(re.sub(r"^/\*\*|\*/$", "", comment.strip()).replace("*", " ").split())
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
