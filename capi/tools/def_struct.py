#!/usr/bin/python3
"""Writes the option members of hfrac_sim_def into def.h from the one option table.

The struct only grows at its end: members keep the order in which they stand in def.h, and a new line of the table becomes
the last member. So the table may be sorted as reads best, and an option can be added anywhere in it. An option that the
table has no more loses its member.

usage: def_struct.py [--check]     --check: exit 1 if def.h differs from what would be written
"""
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "lib/options/option_list.inc"
HEADER = ROOT / "capi/include/hfrac/def.h"
BODY = re.compile(r"(typedef struct hfrac_sim_def \{\n)(.*?)(\} hfrac_sim_def;)", re.S)
NAME = re.compile(r"^  \w[^;/]*?(\w+)(?:\[\w+\])?;", re.M)


def options():
    """{member: its lines in the struct}, in table order."""
    source = re.sub(r"^//.*$", "", TABLE.read_text(), flags=re.M)
    found = {}
    for kind, part, name, rest in re.findall(
        r"^(F64|I64|CHOICE)\((\w+), (\w+), (.*?)\)$(?=\n(?:\n|F64|I64|CHOICE|\Z)|\Z)", source, re.S | re.M
    ):
        texts = re.findall(r'"((?:[^"\\]|\\.)*)"', rest)
        if kind == "F64":
            doc = f"[{texts[0]}] {texts[-1]} Default {rest.split(',')[1].strip()}."
        elif kind == "I64":
            doc = f"{texts[-1]} Default {rest.split(',')[0].strip()}."
        else:
            words = texts[1].split("|")
            listing = ", ".join(f"{i}: {w}" for i, w in enumerate(words))
            doc = f"{listing}. {texts[-1]} Default {words.index(texts[0])}."
        comment = "  /** " + "\n   * ".join(textwrap.wrap(doc, 102)) + " */\n"
        found[f"{part}_{name}"] = comment + f"  {'double' if kind == 'F64' else 'int64_t'} {part}_{name};\n"
    return found


def members(header):
    """{member: its lines, comments and blank line before it included}, in the header's order."""
    body = BODY.search(header.read_text())[2]
    found, at = {}, 0
    for match in NAME.finditer(re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m[0]), body, flags=re.S)):
        end = body.index("\n", match.end()) + 1
        found[match[1]] = body[at:end]
        at = end
    return found


def main():
    text, table, now = HEADER.read_text(), options(), members(HEADER)
    # Options are told from other members by the default in their comment.
    order = [name for name in now if name in table or not re.search(r"Default [^*]*\. \*/", now[name])]
    order += [name for name in table if name not in now]
    lines, section = [], None
    for name in order:
        if name in table:
            part = name.split("_")[0]
            lines.append(("\n" if part != section else "") + table[name])
            section = part
        else:
            lines.append(now[name])
            section = None
    new = BODY.sub(lambda m: m[1] + "".join(lines) + m[3], text)
    if "--check" in sys.argv:
        sys.exit(0 if new == text else "def.h is not what the option table gives: run capi/tools/def_struct.py")
    HEADER.write_text(new)


main()
