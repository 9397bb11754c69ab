"""The public headers as data.

The headers under capi/include/hfrac keep to a small subset of C: integer macros, X-lists of constants, enums,
structs of fixed-size members, one kind of callback, and functions that return an int32_t status. This module reads
exactly that and refuses anything else with file and line, so that nothing can be bound wrongly in silence.
"""
import ast
import pathlib
import re
from dataclasses import dataclass, field

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "capi/include/hfrac"

SCALARS = {"char": 1, "int32_t": 4, "int64_t": 8, "double": 8}  # name: size and alignment in bytes
POINTER_SIZE = 8


@dataclass
class Type:
    base: str
    const: bool = False
    stars: int = 0


@dataclass
class Variable:
    """A parameter, or a member of a struct."""

    name: str
    type: Type
    length: int = 0  # of an array, 0: not one
    doc: str = ""
    may_be_null: bool = False  # parameter: a buffer whose capacity follows


@dataclass
class Struct:
    name: str
    doc: str
    members: list
    size: int = 0
    alignment: int = 0


@dataclass
class Enum:
    name: str
    doc: str
    values: list  # (name, value, doc)


@dataclass
class Function:
    """A function, or the type of a callback."""

    name: str
    doc: str
    parameters: list


@dataclass
class Header:
    macros: dict = field(default_factory=dict)  # name: integer
    lists: dict = field(default_factory=dict)  # X-list: rows of (name, value, ...)
    enums: list = field(default_factory=list)
    opaque: list = field(default_factory=list)
    structs: list = field(default_factory=list)
    callbacks: list = field(default_factory=list)
    functions: list = field(default_factory=list)

    def struct(self, name):
        return next((s for s in self.structs if s.name == name), None)

    def is_callback(self, name):
        return any(c.name == name for c in self.callbacks)

    def constants(self):
        return {name: value for enum in self.enums for name, value, _ in enum.values} | self.macros


class NotInSubset(Exception):
    """Something in a header that this module does not understand."""


def plain(comment):
    """The text of a comment on one line."""
    text = re.sub(r"^/\*\*?<?|\*/$", "", comment.strip())
    return " ".join(re.sub(r"^\s*\*\s?", "", line).strip() for line in text.splitlines()).strip()


class Reader:
    """Reads headers one after the other into one Header; a header comes after those it includes."""

    DECLARATIONS = [
        ("comment", r"(/\*.*?\*/)"),
        ("enum", r"enum (\w+) \{(.*?)\};"),
        ("opaque", r"typedef struct (\w+) \1;"),
        ("struct", r"typedef struct (\w+) \{(.*?)\} \1;"),
        ("callback", r"typedef int32_t \(\*(\w+)\)\((.*?)\);"),
        ("function", r"HFRAC_(?:UNSTABLE_)?API int32_t (\w+)\((.*?)\);"),
    ]

    def __init__(self):
        self.header = Header()
        self.path = None

    def refuse(self, what):
        raise NotInSubset(f"{self.path}: {what.strip()[:120]!r} is outside the subset of C that can be bound")

    def read(self, path):
        self.path = path
        text = re.sub(r"^#ifdef __cplusplus\n.*?^#endif$", "", path.read_text(), flags=re.S | re.M)
        text = self.preprocess(text)
        doc, at = "", 0
        while text[at:].strip():
            at += len(text[at:]) - len(text[at:].lstrip())
            for kind, pattern in self.DECLARATIONS:
                match = re.compile(pattern, re.S).match(text, at)
                if match:
                    break
            else:
                self.refuse(text[at:])
            at = match.end()
            if kind == "comment":
                doc = plain(match[1]) if match[1].startswith("/**") and "@file" not in match[1] else ""
            else:
                getattr(self, kind)(doc, *match.groups())
                doc = ""

    def preprocess(self, text):
        """Takes note of macros; what is left is declarations."""
        text = text.replace("\\\n", " ")
        rest = []
        for line in text.splitlines():
            if not line.startswith("#"):
                rest.append(line)
            elif match := re.match(r"#define (HFRAC_\w+) (-?\d+)$", line):
                self.header.macros[match[1]] = int(match[2])
            elif match := re.match(r"#define (HFRAC_\w+_LIST)\(X\)(.*)", line):
                self.header.lists[match[1]] = self.rows(match[2])
        return "\n".join(rest)

    def rows(self, text):
        """X(NAME, 1, "text", ...) one after the other. What stands in the brackets is a literal in Python too."""
        literal = r'(?:"(?:[^"\\]|\\.)*"|-?\d+)'
        row = re.compile(rf"\s*X\((\w+)((?:,\s*{literal})+)\)")
        found, at = [], 0
        while text[at:].strip():
            match = row.match(text, at)
            if not match:
                self.refuse(text[at:])
            found.append((match[1], *ast.literal_eval(f"({match[2].lstrip(', ')},)")))
            at = match.end()
        return found

    def enum(self, doc, name, body):
        listed = re.match(r"\s*(HFRAC_\w+_LIST)\(\w+\)\s*\w+_END_ = 0x7fffffff\s*$", body)
        if listed:
            doc = re.sub(r": X\(.*?\)", "", doc)
            values = [(row[0], row[1], row[-1]) for row in self.header.lists[listed[1]]]
        else:
            entry = re.compile(r"\s*(\w+) = (-?\d+)\s*,?\s*(/\*\*<.*?\*/)?", re.S)
            values, at = [], 0
            while body[at:].strip():
                match = entry.match(body, at)
                if not match:
                    self.refuse(body[at:])
                values.append((match[1], int(match[2]), plain(match[3] or "")))
                at = match.end()
        self.header.enums.append(Enum(name, doc, values))

    def opaque(self, doc, name):
        self.header.opaque.append(name)

    def struct(self, doc, name, body):
        member = re.compile(r"\s*((?:/\*.*?\*/\s*)*)([^;/]+);(?:[ \t]*(/\*\*<.*?\*/))?", re.S)
        members, at = [], 0
        while re.sub(r"/\*.*?\*/", "", body[at:], flags=re.S).strip():
            match = member.match(body, at)
            if not match:
                self.refuse(body[at:])
            before = re.findall(r"/\*\*[^<].*?\*/", match[1], re.S)
            variable = self.variable(match[2])
            variable.doc = plain(match[3] or (before[-1] if before else ""))
            members.append(variable)
            at = match.end()
        self.header.structs.append(self.laid_out(Struct(name, doc, members)))

    def callback(self, doc, name, parameters):
        self.header.callbacks.append(Function(name, doc, self.parameters(parameters)))

    def function(self, doc, name, parameters):
        self.header.functions.append(Function(name, doc, self.parameters(parameters)))

    def parameters(self, text):
        found = [self.variable(part) for part in text.split(",")]
        for variable, follower in zip(found, found[1:]):
            variable.may_be_null = variable.type.stars == 1 and follower.name == "capacity"
        return found

    def variable(self, text):
        match = re.match(r"(const )?(\w+) (\**)(\w+)(?:\[(\w+)\])?$", " ".join(text.split()))
        if not match:
            self.refuse(text)
        base, stars = match[2], len(match[3])
        by_value = base in SCALARS or self.header.struct(base) or self.header.is_callback(base)
        pointed_at = by_value or base == "void" or base in self.header.opaque
        if stars > 2 or not (pointed_at if stars else by_value):
            self.refuse(text)
        length = 0
        if match[5]:
            length = int(match[5]) if match[5].isdigit() else self.header.constants()[match[5]]
        return Variable(match[4], Type(base, bool(match[1]), stars), length)

    def laid_out(self, struct):
        """Size by the rule of every 64-bit ABI in use: each member at a multiple of its own alignment."""
        at = 0
        for member in struct.members:
            size, alignment = self.size_of(member.type)
            at = -(-at // alignment) * alignment + size * max(1, member.length)
            struct.alignment = max(struct.alignment, alignment)
        struct.size = -(-at // struct.alignment) * struct.alignment
        return struct

    def size_of(self, kind):
        if kind.stars or self.header.is_callback(kind.base):
            return POINTER_SIZE, POINTER_SIZE
        inner = self.header.struct(kind.base)
        return (inner.size, inner.alignment) if inner else (SCALARS[kind.base], SCALARS[kind.base])


def include_order(folder):
    """All headers of the folder, each after those it includes."""
    ordered = []

    def add(path):
        if path in ordered:
            return
        for name in re.findall(r'^#include "(\w+\.h)"', path.read_text(), re.M):
            add(folder / name)
        ordered.append(path)

    for path in sorted(folder.glob("*.h")):
        add(path)
    return ordered


def read_headers(folder=INCLUDE):
    reader = Reader()
    for path in include_order(folder):
        reader.read(path)
    return reader.header
