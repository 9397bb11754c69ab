#!/usr/bin/python3
"""docs/glossary.md defines each word once, and covers every section of the option table and every field.

usage: glossary.py
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    page = (ROOT / "docs/glossary.md").read_text()
    table = re.sub(r"^//.*$", "", (ROOT / "lib/options/option_list.inc").read_text(), flags=re.M)
    sections = set(re.findall(r"^(?:F64|I64|CHOICE)\((\w+),", table, re.M))
    fields = re.findall(r'X\(HFRAC_\w+, \d+, "([\w.]+)"', (ROOT / "capi/include/hfrac/field.h").read_text())
    if len(sections) < 10 or len(fields) < 20:
        return "the option table or the field list was not found: this test reads nothing"
    faults = [f"no word for option section {name}" for name in sorted(sections)
              if not re.search(rf"`{name}(\.\w+[^`]*)?`", page)]
    faults += [f"no word for field {name}" for name in fields if f"`{name}`" not in page]
    words = re.findall(r"^\| (?!word \||---)([^|]+?) \|", page, re.M)
    faults += [f"defined twice: {word}" for word in sorted({word for word in words if words.count(word) > 1})]
    for option in set(re.findall(r"`((?:%s)\.\w+)(?: = [^`]*)?`" % "|".join(sorted(sections)), page)):
        section, name = option.split(".")
        if option not in fields and not re.search(rf"^(?:F64|I64|CHOICE)\({section}, {name},", table, re.M):
            faults.append(f"no such option or field: {option}")
    return "\n".join(faults) or 0


sys.exit(main())
