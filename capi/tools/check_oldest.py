#!/usr/bin/python3
"""A client compiled against the oldest supported headers, capi/abi/oldest, still fits: the new headers only add to them.

usage: check_oldest.py CC [ABIDIFF]

Checked: every constant has its value; every struct has its old members with their types at their offsets, and may be
longer; a struct that lies inside another, or has no size of its own told by the caller, is not longer either. With
ABIDIFF, also the functions: both sets of headers become libraries of empty functions with debug information, made by
the same compiler here and now, which abidiff compares. A stored dump would compare compilers as much as interfaces.
That the real library defines what the headers declare is the business of check_symbols.py and of the compiler.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from c_header import INCLUDE, ROOT, code

OLDEST = ROOT / "capi/abi/oldest/include"
# They say which headers these are, and so differ.
RELEASE = re.compile(r"HFRAC_VERSION_\w+")
PRINT_MEMBER = """  printf("{struct}.{member} at %zu, %zu bytes, type %s\\n", offsetof({struct}, {member}),
    sizeof((({struct} *)0)->{member}), _Generic((((({struct} *)0)->{member})), double: "double", int32_t: "int32_t",
    int64_t: "int64_t", char *: "text", const char *: "const text", const double *: "const doubles", default: "other"));"""


def headers(include):
    return {path.name: code(path) for path in sorted((include / "hfrac").glob("*.h"))}


def constants(texts):
    found = {}
    for text in texts.values():
        for pattern in (r"#define (HFRAC_\w+) (-?\d+)\s*$", r"\b(HFRAC_\w+) = (-?\w+)", r"X\((HFRAC_\w+), (-?\d+)"):
            found |= {name: value for name, value in re.findall(pattern, text, re.M) if not RELEASE.match(name)}
    return found


def structs(texts):
    """{struct: [members]}"""
    found = {}
    for text in texts.values():
        for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", text, re.S):
            found[name] = [re.search(r"(\w+)\s*(?:\[\w+\])?\s*$", part)[1] for part in body.split(";") if part.strip()]
    return found


def fixed(texts):
    """Structs whose size cannot grow: members of others."""
    every = structs(texts)
    text = "".join(texts.values())
    return {name for name in every if re.search(rf"^\s+(?:const )?{name} \w+(\[\w+\])?;", text, re.M)}


def layout(cc, include, wanted, folder):
    """{"struct.member": where and what} and {struct: size} for the structs and members wanted."""
    source, binary = folder / "layout.c", folder / "layout"
    lines = ["#include <hfrac/hfrac.h>", "#include <stddef.h>", "#include <stdio.h>", "int main(void) {"]
    for struct, members in wanted.items():
        lines.append(f'  printf("{struct} %zu\\n", sizeof({struct}));')
        lines += [PRINT_MEMBER.format(struct=struct, member=member) for member in members]
    source.write_text("\n".join([*lines, "  return 0;", "}", ""]))
    subprocess.run([cc, "-std=c11", f"-I{include}", source, "-o", binary], check=True)
    out = subprocess.run([binary], check=True, capture_output=True, text=True).stdout.splitlines()
    sizes = {line.split()[0]: int(line.split()[1]) for line in out if "." not in line}
    return {line.split()[0]: line for line in out if "." in line}, sizes


def library(cc, include, texts, folder, name):
    """Empty functions of the headers as a shared library with debug information."""
    source, made = folder / f"{name}.c", folder / f"lib{name}.so"
    bodies = [
        f"int32_t {function}({parameters}) {{ return 0; }}"
        for text in texts.values()
        for function, parameters in re.findall(r"^HFRAC_(?:UNSTABLE_)?API int32_t (\w+)\(([^;]*)\);", text, re.M)
    ]
    source.write_text("\n".join(["#include <hfrac/hfrac.h>", *bodies, ""]))
    subprocess.run([cc, "-std=c99", "-g", "-O0", "-shared", "-fPIC", "-DHFRAC_ENABLE_UNSTABLE", f"-I{include}", source, "-o", made], check=True)
    return made


def main():
    cc, abidiff = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    old, new = headers(OLDEST), headers(INCLUDE)
    problems = []
    now = constants(new)
    for name, value in constants(old).items():
        if now.get(name) != value:
            problems.append(f"{name} was {value} and is {now.get(name, 'gone')}")
    wanted, there = structs(old), structs(new)
    for struct, members in wanted.items():
        missing = [f"{struct}.{member}" for member in members if member not in there.get(struct, [])]
        problems += [f"{name} is gone" for name in missing]
    if not problems:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (was, sizes), (here, sizes_now) = (layout(cc, include, wanted, folder) for include in (OLDEST, INCLUDE))
            problems += [f"was: {was[key]}; is: {here[key]}" for key in was if was[key] != here[key]]
            # The old header's last member may have been followed by padding; a shorter struct has lost something.
            problems += [f"{s} is shorter than it was" for s in sizes if sizes_now[s] < sizes[s]]
            problems += [f"{s} lies inside another struct and cannot grow" for s in fixed(old) if sizes_now[s] != sizes[s]]
            if abidiff:
                # Appended members are checked above, and more strictly; here they would only be in the way.
                suppressions = folder / "suppressions"
                suppressions.write_text("[suppress_type]\n  type_kind = struct\n  has_data_member_inserted_at = end\n")
                libraries = [library(cc, OLDEST, old, folder, "oldest"), library(cc, INCLUDE, new, folder, "newest")]
                found = subprocess.run(
                    [abidiff, "--no-added-syms", "--suppressions", suppressions, *libraries],
                    capture_output=True, text=True, check=False,
                )
                if found.returncode != 0:
                    problems.append(f"abidiff (status {found.returncode}):\n{found.stdout}{found.stderr}")
    sys.exit("\n".join(problems) or 0)


main()
