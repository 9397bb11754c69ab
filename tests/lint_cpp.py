"""clang-tidy over the project's C++ (tests/lint cpp): files side by side, each only if it changed since it was found clean.

What a finding depends on is hashed: the file as the preprocessor gives it (so every header too), its compile options, .clang-tidy
and clang-tidy's version. build/tidy holds one empty file for each hash that was found clean. Kernels compiled once per instruction
set (*_avx*) are looked at once. Sources that are compiled as one unit (viz) are looked at as one: the headers of VTK and CLI11
take ten times as long as our code, and are read once for all of them.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
FOLDERS = ("lib", "capi", "bindings", "viz")
CLEAN = BUILD / "tidy"


def output_of(command, folder=ROOT):
    return subprocess.run(command, cwd=folder, capture_output=True, check=True).stdout


def sources_of(unit):
    """What a compiled file consists of: itself, or the sources of a unit that CMake made."""
    if "Unity" not in unit.parts:
        return [unit]
    return [pathlib.Path(line.split('"')[1]) for line in unit.read_text().splitlines() if line.startswith("#include")]


def files():
    """Compile commands of what is looked at, one a file or unit, with the sources in it."""
    with open(BUILD / "compile_commands.json") as stream:
        commands = {pathlib.Path(entry["file"]): entry for entry in json.load(stream)}
    chosen, looked_at = [], set()
    for file, entry in sorted(commands.items()):
        if file.suffix not in (".cpp", ".cxx") or "_avx" in file.name or not file.exists():
            continue
        sources = sources_of(file)
        if all(source.is_relative_to(ROOT) and source.relative_to(ROOT).parts[0] in FOLDERS for source in sources):
            looked_at.update(sources if len(sources) > 1 else ())
            chosen.append((file, entry, sources))
    # What is part of a unit is not looked at a second time where a test compiles it by itself.
    return [one for one in chosen if len(one[2]) > 1 or one[2][0] not in looked_at]


def fingerprint(entry, settings):
    arguments = [word for word in shlex.split(entry["command"]) if not word.endswith("ccache")]
    at = arguments.index("-o")
    preprocess = arguments[:at] + arguments[at + 2:] + ["-E", "-P"]
    return hashlib.sha256(settings + " ".join(arguments[:at]).encode() + output_of(preprocess, entry["directory"])).hexdigest()


def look(file, entry, settings):
    """What clang-tidy has to say of a file: nothing if it is clean."""
    mark = CLEAN / fingerprint(entry, settings)
    if mark.exists():
        return ""
    # gcc's own switches are not clang's; and a unit consists of includes of sources.
    extra = ["--extra-arg=-Wno-unknown-warning-option"]
    if "Unity" in file.parts:
        extra.append("--checks=-bugprone-suspicious-include")
    done = subprocess.run(["clang-tidy", "-quiet", "-p", BUILD, *extra, file], cwd=ROOT, capture_output=True, text=True)
    if done.returncode == 0:
        mark.touch()
        return ""
    return done.stdout or done.stderr


def main():
    wanted = {pathlib.Path(name).resolve() for name in sys.argv[1:]}
    chosen = [(file, entry) for file, entry, sources in files() if not wanted or wanted.intersection(sources)]
    if not chosen:
        print("tests/lint: no such file in build/compile_commands.json; configure first: cmake/configure release", file=sys.stderr)
        return 2
    CLEAN.mkdir(exist_ok=True)
    settings = (ROOT / ".clang-tidy").read_bytes() + output_of(["clang-tidy", "--version"])
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for text in pool.map(lambda pair: look(*pair, settings), chosen):
            if text:
                bad += 1
                print(text, flush=True)
    print(f"clang-tidy: {len(chosen)} files, findings in {bad}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
