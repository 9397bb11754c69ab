#!/usr/bin/python3
"""Compares size and offsets of every public struct with the committed capi/abi/layout.txt (x86-64 and AArch64 Linux agree).

usage: check_layout.py CC [--write] [--library hfrac_viz]
                                        --write: layout.txt anew, after a change of the ABI on purpose
                                        --library: of the renderer instead, viz/abi/layout.txt
"""
import pathlib
import subprocess
import sys
import tempfile

from c_header import INCLUDE, VIZ_INCLUDE, library_of, structs


def program(library):
    lines = [f"#include <{library.whole}>", "#include <stddef.h>", "#include <stdio.h>", "int main(void) {"]
    for struct, members in structs(library.headers):
        lines.append(f'  printf("{struct} %zu\\n", sizeof({struct}));')
        for member in members:
            lines.append(
                f'  printf("  {member} %zu %zu\\n", offsetof({struct}, {member}), sizeof((({struct} *)0)->{member}));'
            )
    return "\n".join([*lines, "  return 0;", "}", ""])


def main():
    arguments = sys.argv[1:]
    library = library_of(arguments)
    list_file = library.abi / "layout.txt"
    with tempfile.TemporaryDirectory() as folder:
        source, binary = pathlib.Path(folder, "layout.c"), pathlib.Path(folder, "layout")
        source.write_text(program(library))
        subprocess.run([arguments[0], "-std=c99", f"-I{INCLUDE}", f"-I{VIZ_INCLUDE}", source, "-o", binary], check=True)
        found = subprocess.run([binary], check=True, capture_output=True, text=True).stdout
    if "--write" in arguments:
        list_file.write_text(found)
    elif found != list_file.read_text():
        pairs = [f"{was} -> {now}" for was, now in zip(list_file.read_text().splitlines(), found.splitlines()) if was != now]
        sys.exit("The layout is not that of layout.txt; first differences:\n" + "\n".join(pairs[:5] or ["length"]))


main()
