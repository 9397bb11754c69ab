"""The few things the checks of this folder need to know about the public headers, by plain text search."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "capi/include"
HEADERS = sorted((INCLUDE / "hfrac").glob("*.h"))


def code(path):
    """The header without comments."""
    return re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)


def functions():
    """Names of all declared functions, sorted."""
    return sorted(name for path in HEADERS for name in re.findall(r"^HFRAC_API\s[^(;]*?(\w+)\(", code(path), re.M))


def structs():
    """(struct, [members]) of every public struct, in order of the headers."""
    found = []
    for path in HEADERS:
        for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", code(path), re.S):
            names = [re.search(r"(\w+)\s*(\[\w+\])?\s*$", part).group(1) for part in body.split(";") if part.strip()]
            found.append((name, names))
    return found
