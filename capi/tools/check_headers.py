#!/usr/bin/python3
"""Compiles each public header alone, as C99 and as C++11, with every warning an error; and a call of every function:
stable ones as they are, unstable ones only where HFRAC_ENABLE_UNSTABLE is defined.

usage: check_headers.py CC CXX
"""
import re
import subprocess
import sys

from c_header import HEADERS, INCLUDE, LIBRARIES, VIZ_INCLUDE, code

STRICT = ["-Wall", "-Wextra", "-pedantic", "-pedantic-errors", "-Wshadow", "-Werror", "-fsyntax-only", f"-I{INCLUDE}", f"-I{VIZ_INCLUDE}"]


HIDING = "#if !__has_attribute(unavailable)\n#error\n#endif\n"


def declared(visibility):
    return [name for path in HEADERS for name in re.findall(rf"^{visibility} int32_t (\w+)\(", code(path), re.M)]


def compiles(command, names, *definitions):
    """Whether a program that takes the address of these functions does."""
    lines = ["#include <hfrac/hfrac.h>", "typedef void (*any)(void);", "any all[] = {"]
    lines += [f"  (any){name}," for name in names] + ["};", "int main(void) { return all[0] == 0; }", ""]
    done = subprocess.run([*command, *definitions, f"-I{INCLUDE}", "-fsyntax-only", "-"], input="\n".join(lines), text=True,
                          capture_output=True, check=False)
    return done.returncode == 0


def check_hiding(command):
    """Names of functions that are hidden and should not be, or the other way round."""
    if subprocess.run([*command, "-E", "-"], input=HIDING, text=True, capture_output=True, check=False).returncode != 0:
        return []  # this compiler cannot hide at compile time
    stable, unstable = declared("HFRAC_API"), declared("HFRAC_UNSTABLE_API")
    wrong = [] if compiles(command, stable) else ["a stable function does not compile as it is"]
    if not compiles(command, stable + unstable, "-DHFRAC_ENABLE_UNSTABLE"):
        wrong.append("a function does not compile with HFRAC_ENABLE_UNSTABLE")
    return wrong + [f"{name} is unstable and not hidden" for name in unstable if compiles(command, [name])]


def main():
    cc, cxx = sys.argv[1:]
    failed = 0
    for problem in check_hiding([cc, "-std=c99", "-xc"]) + check_hiding([cxx, "-std=c++11", "-xc++"]):
        print(problem, file=sys.stderr)
        failed = 1
    for header in [header for library in LIBRARIES.values() for header in library.headers]:
        line = f"#include <hfrac/{header.name}>\n"
        for command in ([cc, "-std=c99", "-Wstrict-prototypes", "-xc"], [cxx, "-std=c++11", "-xc++"]):
            failed |= subprocess.run([*command, *STRICT, "-"], input=line, text=True, check=False).returncode
    sys.exit(failed)


main()
