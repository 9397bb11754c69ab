"""The few things the checks of this folder need to know about the public headers, by plain text search."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "capi/include"
HEADERS = sorted((INCLUDE / "hfrac").glob("*.h"))


class Library:
    """A library with a C interface: its headers, the header that includes them all, where its lists are."""

    def __init__(self, headers, whole, abi):
        self.headers, self.whole, self.abi = headers, whole, ROOT / abi


VIZ_INCLUDE = ROOT / "viz/include"
LIBRARIES = {
    "hfrac": Library(HEADERS, "hfrac/hfrac.h", "capi/abi"),
    "hfrac_viz": Library([VIZ_INCLUDE / "hfrac/viz.h"], "hfrac/viz.h", "viz/abi"),
}


def library_of(arguments):
    """Takes "--library NAME" out of the arguments; libhfrac without it."""
    if "--library" not in arguments:
        return LIBRARIES["hfrac"]
    at = arguments.index("--library")
    name = arguments[at + 1]
    del arguments[at : at + 2]
    return LIBRARIES[name]


def code(path):
    """The header without comments."""
    return re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)


def functions(headers=None):
    """Names of all declared functions, sorted."""
    return sorted(name for path in headers or HEADERS for name in re.findall(r"^HFRAC_(?:UNSTABLE_)?API\s[^(;]*?(\w+)\(", code(path), re.M))


def structs(headers=None):
    """(struct, [members]) of every public struct, in order of the headers."""
    found = []
    for path in headers or HEADERS:
        for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", code(path), re.S):
            names = [re.search(r"(\w+)\s*(\[\w+\])?\s*$", part).group(1) for part in body.split(";") if part.strip()]
            found.append((name, names))
    return found
