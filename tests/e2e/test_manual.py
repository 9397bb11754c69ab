"""The manual page and the completion of bash: they are what the program says of itself, and they work."""
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from hfrac_runs import hfrac

COMMAND_FOLDER = pathlib.Path(__file__).resolve().parents[2] / "viz/command"
PAGE = COMMAND_FOLDER / "manual/hfrac.1"
# What bash has when TAB is pressed behind these words.
COMPLETE = """
source "$1"; shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_hfrac
printf '%s\\n' "${COMPREPLY[@]}"
"""


def completed(*words):
    bash = ["bash", "--norc", "-c", COMPLETE, "bash", COMMAND_FOLDER / "manual/hfrac.bash", "hfrac", *words]
    return subprocess.run(bash, capture_output=True, text=True, check=True).stdout.split()


class Manual(unittest.TestCase):
    def test_both_are_what_the_program_says(self):
        done = subprocess.run([sys.executable, "-B", COMMAND_FOLDER / "make-manual", "--check"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_command_has_its_part(self):
        names = re.findall(r"^  ([a-z]+)  +\S", hfrac("--help").stdout.split("Subcommands:")[1], re.M)
        self.assertGreater(len(names), 15)
        self.assertEqual(re.findall(r"^\.SS hfrac (\w+)", PAGE.read_text(), re.M), names)

    @unittest.skipUnless(shutil.which("groff"), "groff is not here")
    def test_the_page_is_good_roff(self):
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", PAGE], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_completion(self):
        self.assertEqual(completed("re"), ["resume", "render", "report"])
        self.assertEqual(completed("run", "case.toml", "--o"), ["--output", "--one-model", "--overwrite"])
        self.assertEqual(completed("new", "f"), ["fracture"])
        self.assertEqual(completed("lab", "p"), ["pressurised-crack", "permeability"])
        self.assertEqual(completed("render", "out/first", "--view", "joint-s"), ["joint-slip", "joint-state"])
        self.assertEqual(completed("run", ""), [], "names of files are bash's own")
        self.assertEqual(completed("run", "-o", ""), [])


if __name__ == "__main__":
    unittest.main()
