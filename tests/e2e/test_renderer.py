"""The renderer is loaded by the commands that draw, and by them alone; where it cannot be, everything else goes on."""
import os
import pathlib
import shutil
import tempfile
import unittest

from hfrac_runs import TINY_CASE, hfrac

LIBRARY = "libhfrac_viz.so.0"


class Renderer(unittest.TestCase):
    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.case = self.top / "case.toml"
        self.case.write_text(TINY_CASE)
        self.folder = self.top / "run"

    def loads_it(self, *arguments):
        run = hfrac(*arguments, env=os.environ | {"LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(self.top / "loaded")})
        self.assertEqual(run.returncode, 0, run.stderr)
        logs = list(self.top.glob("loaded.*"))
        found = any(LIBRARY in log.read_text() for log in logs)
        for log in logs:
            log.unlink()
        return found

    def test_only_commands_that_draw_load_it(self):
        self.assertFalse(self.loads_it("--version"))
        self.assertFalse(self.loads_it("run", self.case, "-o", self.folder, "--steps", "1"))
        self.assertFalse(self.loads_it("info", self.folder))
        self.assertTrue(self.loads_it("render", "--help"))
        self.assertTrue(self.loads_it("plot", self.folder))

    def test_without_it_runs_go_on_and_pictures_say_what_is_missing(self):
        broken = self.top / "libraries"
        broken.mkdir()
        (broken / LIBRARY).write_text("no library")
        without = os.environ | {"LD_LIBRARY_PATH": str(broken)}
        run = hfrac("run", self.case, "-o", self.folder, "--steps", "1", env=without)
        self.assertEqual(run.returncode, 0, run.stderr)
        for command in (["render"], ["render", "--view", "discs", "-o", self.top / "x.png"], ["plot"], ["report"]):
            drawn = hfrac(command[0], self.folder, *command[1:], env=without)
            self.assertEqual(drawn.returncode, 1, command)
            self.assertRegex(drawn.stderr, f"^hfrac: pictures need the renderer, {LIBRARY}, .*; install hfrac with it")
            self.assertFalse((self.top / "x.png").exists())


if __name__ == "__main__":
    unittest.main()
