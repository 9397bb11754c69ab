#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the compiler made of the kernels for cards: every kernel is there, nothing is fused, kept in local memory or called, and every
floating-point operation is rounded to nearest. Where NVIDIA's assembler is on the PATH (ptxas, of no package that hfrac needs), that it takes them
for every card from compute capability 8.0 to 9.0, too, with little spilled and registers enough for the threads and blocks that the list names.

    check_ptx.py PTX_FILE KERNEL_LIST
"""
import re
import shutil
import subprocess
import sys
import tempfile
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


CARDS = ("sm_80", "sm_86", "sm_89", "sm_90")
REGISTERS = 65536  # of a multiprocessor
# Bytes a thread: these two keep to 64 and 96 registers, so that a multiprocessor has room for their threads (lib/gpu/device_kernel_list.inc).
SPILLED = {"plain_tile_step": 160, "plain_cross_pairs": 96}
SPILLED_BY_OTHERS = 64


def faults_of_assembling(ptxas, ptx_file, threads):
    """What is wrong, in words, given the threads that a multiprocessor is to have room for, by kernel; prints the most registers taken."""
    for card in CARDS:
        with tempfile.NamedTemporaryFile(suffix=".cubin") as binary:
            done = subprocess.run([ptxas, f"-arch={card}", "-v", ptx_file, "-o", binary.name], capture_output=True, text=True, check=False)
        said = done.stdout + done.stderr
        registers = {name: int(n) for name, n in re.findall(r"entry function '(\w+)'.*?Used (\d+) registers", said, re.DOTALL)}
        kept = {name: max(map(int, sizes)) for name, *sizes in re.findall(
            r"entry function '(\w+)'.*?(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads", said, re.DOTALL)}
        if done.returncode != 0 or set(registers) != set(threads):
            yield f"{card}: {len(registers)} kernels assembled of {len(threads)}: {said.strip()[-500:]}"
            continue
        spilled = [f"{name} ({n} bytes)" for name, n in kept.items() if n > SPILLED.get(name, SPILLED_BY_OTHERS)]
        if spilled:
            yield f"{card}: too much of registers kept in memory: {', '.join(spilled)}"
        many = [f"{name} ({n})" for name, n in registers.items() if n * threads[name] > REGISTERS]
        if many:
            yield f"{card}: too many registers for their threads: {', '.join(many)}"
        print(f"{card}: assembled, at most {max(registers.values())} registers and {max(kept.values())} bytes spilled")


def main():
    ptx_file, list_file = map(Path, sys.argv[1:3])
    listed = re.findall(r"HFRAC_DEVICE_KERNEL\((\w+), \w+, (\w+), (\d+)\)", list_file.read_text(encoding="utf-8"))
    threads = {name: int(blocks) * (256 if of == "device_threads" else int(of)) for name, of, blocks in listed}
    wanted = set(threads)
    ptx = ptx_file.read_text(encoding="utf-8")
    found = list(faults(ptx, wanted))
    if ptxas := shutil.which("ptxas"):
        found += faults_of_assembling(ptxas, ptx_file, threads)
    else:
        print("no ptxas here: not assembled")
    print("\n".join(found) or f"{len(wanted)} kernels, {len(re.findall(r'f64', ptx))} mentions of f64: as wanted")
    return 1 if found or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
