#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the compiler made of the kernels for cards: every kernel is there, nothing is fused, kept in local memory or called, and every
floating-point operation is rounded to nearest.

    check_ptx.py PTX_FILE KERNEL_LIST
"""
import re
import sys
from pathlib import Path


def faults(ptx, wanted):
    """What is wrong, in words."""
    entries = set(re.findall(r"\.visible \.entry (\w+)\(", ptx))
    if entries != wanted:
        yield f"kernels are {sorted(entries)}, wanted {sorted(wanted)}"
    for number, line in enumerate(ptx.splitlines(), 1):
        code = line.split("//")[0].strip()
        for word in ("fma.", "mad.f", ".local", "call", ".approx", ".ftz", ".full"):
            if word in code:
                yield f"line {number}: {word} in '{code}'"
        operation = re.match(r"(?:@%p\d+\s+)?(add|sub|mul|div|sqrt|rcp)\.(\S*f64)", code)
        if operation and not operation.group(2).startswith("rn."):
            yield f"line {number}: not rounded to nearest: '{code}'"


def main():
    ptx_file, list_file = map(Path, sys.argv[1:3])
    wanted = set(re.findall(r"HFRAC_DEVICE_KERNEL\((\w+),", list_file.read_text(encoding="utf-8")))
    ptx = ptx_file.read_text(encoding="utf-8")
    found = list(faults(ptx, wanted))
    print("\n".join(found) or f"{len(wanted)} kernels, {len(re.findall(r'f64', ptx))} mentions of f64: as wanted")
    return 1 if found or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
