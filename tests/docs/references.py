#!/usr/bin/python3
"""What the documentation and head comments name exists: files, `file: name`, links and their anchors.

usage: references.py

Read are all tracked .md files and the head comment (the first lines that begin with //, # or *) of every source file. Checked:
  [text](path#anchor)         the file is there, and has the heading
  `folder/file`               in code quotes, with a known first folder: the file, folder or pattern is there
  `file.cpp: name, other`     a file of that name is there, and holds the names as words
  file.cpp, folder/file.hpp   in code quotes or in a head comment: a file of that name is there
  `hfrac_name`                in code quotes: a function, type or program of that name stands in headers, bindings or CMake files
and that README.md has at most 150 lines and links to every page of docs/; that each case of verification is built, has a page and a row in their list,
and each page a case.
"""
import fnmatch
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = r"(?:cpp|hpp|inc|f90|ts|mjs)"
FILE = re.compile(rf"(?<![\w./<*{{-])((?:[\w.-]+/)*[\w-]+\.{SOURCE})\b(?!\()")
NAMES = re.compile(rf"`((?:[\w.-]+/)*[\w-]+\.(?:{SOURCE}|py|h|c)): ([\w:~]+(?:\(\))?(?:, [\w:~]+(?:\(\))?)*)`")
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
OURS = re.compile(r"(?<![\w./*-])hfrac_\w+\b(?![*./-])")
# Files that the programs make, and examples of names of a user's own.
MADE = re.compile(r"^(build|out)(/|$)|[A-Z]{4}|[<>{}$]|\.\.\.|^docs/images/.*\*")


def tracked():
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode()
    return [path for path in listed.split("\0") if path and (ROOT / path).exists()]


def slug(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def prose(text):
    return re.sub(r"^```.*?^```", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)


def head_comment(text):
    lines = []
    for line in text.split("\n"):
        bare = line.strip()
        if bare and not re.match(r"//|/\*|\*|#(?!include|pragma|define|if)", bare):
            break
        lines.append(bare)
    return "\n".join(lines)


class References:
    def __init__(self):
        self.files = tracked()
        self.folders = {str(parent) for path in self.files for parent in pathlib.PurePosixPath(path).parents}
        self.top = {path.split("/")[0] for path in self.files if "/" in path}
        self.by_name = {}
        for path in self.files:
            self.by_name.setdefault(path.rsplit("/", 1)[-1], []).append(path)
        self.ours = set()
        for path in self.files:
            if re.search(r"include/hfrac/|^bindings/|CMakeLists\.txt$|\.cmake$", path) and not path.endswith(".md"):
                self.ours.update(re.findall(r"\bhfrac_\w+", (ROOT / path).read_text()))
        self.faults = []
        self.checked = 0

    def found(self, name):
        """Tracked files whose path ends in `name`."""
        return [path for path in self.by_name.get(name.rsplit("/", 1)[-1], []) if ("/" + path).endswith("/" + name)]

    def fault(self, where, what):
        self.faults.append(f"{where}: {what}")

    def names(self, where, text):
        for match in NAMES.finditer(text):
            files = self.found(match[1])
            if not files:
                self.fault(where, f"no file {match[1]}")
                continue
            content = "\n".join((ROOT / path).read_text() for path in files)
            for name in match[2].split(", "):
                self.checked += 1
                word = name.removesuffix("()").split("::")[-1]
                if not re.search(rf"\b{re.escape(word)}\b", content):
                    self.fault(where, f"{match[1]} has no {name}")

    def sources(self, where, text):
        for match in FILE.finditer(text):
            self.checked += 1
            if not MADE.search(match[1]) and not self.found(match[1]):
                self.fault(where, f"no file {match[1]}")

    def page(self, path):
        text = prose((ROOT / path).read_text())
        folder = (ROOT / path).parent
        self.names(path, text)
        for code in CODE.findall(text):
            if re.search(rf"^[\w.*/-]+\.{SOURCE}$", code):
                self.sources(path, code)
            for name in OURS.findall(code):
                self.checked += 1
                if name not in self.ours and not MADE.search(name):
                    self.fault(path, f"no {name} in headers, bindings or CMake files")
            word = code.split(" ")[0].rstrip(":,")
            first = word.split("/")[0]
            if "/" in word and first in self.top and not MADE.search(word):
                self.checked += 1
                name = re.sub(r"\[.*", "", word).rstrip("/").rstrip(".")
                if not (name in self.folders or self.found(name) or fnmatch.filter(self.files, name)
                        or fnmatch.filter(self.folders, name) or fnmatch.filter(self.files, name + ".*")):
                    self.fault(path, f"no {name}")
        for target in LINK.findall(text):
            if re.match(r"[a-z]+:", target):
                continue
            self.checked += 1
            name, _, anchor = target.partition("#")
            there = (folder / name).resolve() if name else ROOT / path
            if not there.exists():
                self.fault(path, f"link to {target}: no such file")
            elif anchor and there.suffix == ".md":
                headings = re.findall(r"^#+ +(.*)$", prose(there.read_text()), re.M)
                if anchor not in {slug(one) for one in headings}:
                    self.fault(path, f"link to {target}: no such heading")

    def readme(self):
        """Is short, and has every page of docs/ one hop away."""
        text = (ROOT / "README.md").read_text()
        if text.count("\n") > 150:
            self.fault("README.md", f"{text.count(chr(10))} lines; at most 150")
        linked = {target.partition("#")[0] for target in LINK.findall(text)}
        for path in self.files:
            if re.fullmatch(r"docs/[\w-]+\.md", path) and path not in linked:
                self.fault("README.md", f"no link to {path}")

    def verification(self):
        """Test, page and row in the list of pages of each V<N> belong together."""
        built = (ROOT / "tests/verification/CMakeLists.txt").read_text()
        rows = set(re.findall(r"^\| \[(V\d+)\]", (ROOT / "docs/verification/README.md").read_text(), re.M))
        tests = {}
        for path in self.files:
            if match := re.fullmatch(r"tests/verification/((V\d+)_\w+_test\.cpp)", path):
                tests[match[2]] = path
                if f"  {match[1]}\n" not in built:
                    self.fault(path, "not in tests/verification/CMakeLists.txt")
        pages = {match[1] for path in self.files if (match := re.fullmatch(r"docs/verification/(V\d+)\.md", path))}
        for case in sorted(rows | pages | tests.keys()):
            self.checked += 1
            for what, there in (("row in docs/verification/README.md", rows), ("page", pages), ("test", tests)):
                if case not in there:
                    self.fault(case, f"no {what}")

    def run(self):
        self.readme()
        self.verification()
        for path in self.files:
            if path.endswith(".md"):
                self.page(path)
            elif re.search(r"\.(cpp|hpp|h|c|py|inc)$", path):
                head = head_comment((ROOT / path).read_text())
                self.names(path, head)
                self.sources(path, head)
        if self.checked < 300:
            self.fault("references.py", f"only {self.checked} references were found: this test reads too little")
        print(f"{self.checked} references, {len(self.faults)} wrong")
        return "\n".join(self.faults) or 0


sys.exit(References().run())
