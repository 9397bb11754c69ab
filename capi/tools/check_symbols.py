#!/usr/bin/python3
"""Checks what libhfrac (with --library hfrac_viz: the renderer) shows to the outside and what it takes from there.

usage: check_symbols.py exports LIBRARY [--unfinished]   exported names = capi/abi/symbols.txt = functions of the headers
                                        --unfinished: not all of them need to be there yet
       check_symbols.py imports FILE...  objects and archives of ours call nothing that ends the process, prints, or
                                         changes what belongs to the whole process
       check_symbols.py write            symbols.txt from the headers, after a function was added on purpose
"""
import subprocess
import sys

from c_header import functions, library_of

# Only objects of ours are looked at: libstdc++.so itself calls abort, as it must. What its headers put into our objects
# (std::__throw_*, operator new, terminate of noexcept) has names of its own and is not on this list.
FORBIDDEN = set(
    """abort exit _exit _Exit quick_exit __assert_fail
    printf fprintf vprintf vfprintf puts putchar fputs fputc perror __printf_chk __fprintf_chk __vfprintf_chk
    chdir fchdir setlocale uselocale setenv unsetenv putenv umask
    signal sigaction raise kill srand srandom srand48 system fork
    _ZSt4cout _ZSt4cerr _ZSt4clog _ZSt4wcout _ZNSt8ios_base4InitC1Ev _ZNSt8ios_base4InitC2Ev""".split()
)


def nm(*arguments):
    out = subprocess.run(["nm", *arguments], check=True, capture_output=True, text=True).stdout
    return [line.split() for line in out.splitlines() if line.strip() and not line.endswith(":")]


def exports(library, file, unfinished):
    found = {words[-1].split("@")[0] for words in nm("-D", "--defined-only", file)} - {"HFRAC_0"}
    list_file = library.abi / "symbols.txt"
    listed, declared = set(list_file.read_text().split()), set(functions(library.headers))
    problems = [f"{name}: exported but not in {list_file.name}" for name in sorted(found - listed)]
    problems += [f"{name}: declared in a header but not in {list_file.name}" for name in sorted(declared - listed)]
    problems += [f"{name}: in {list_file.name} but in no header" for name in sorted(listed - declared)]
    missing = sorted(listed - found)
    if unfinished:
        print(f"{len(missing)} functions are not there yet")
    else:
        problems += [f"{name}: in {list_file.name} but not exported" for name in missing]
    return problems


def imports(files):
    problems = []
    for name in files:
        taken = {words[-1].split("@")[0] for words in nm("-u", name)}
        problems += [f"{name}: uses {symbol}" for symbol in sorted(taken & FORBIDDEN)]
    return problems


def main():
    mode, arguments = sys.argv[1], sys.argv[2:]
    library = library_of(arguments)
    if mode == "write":
        (library.abi / "symbols.txt").write_text("\n".join(functions(library.headers)) + "\n")
        return
    problems = exports(library, arguments[0], "--unfinished" in arguments) if mode == "exports" else imports(arguments)
    sys.exit("\n".join(problems) or 0)


main()
