"""Movies made while the run goes on, and movies whose making was killed; and drawing in whatever environment and limits."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from hfrac_runs import CASE, COMMAND, hfrac

STEPS = 24


class Movie(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-e2e-"))
        cls.addClassCleanup(shutil.rmtree, cls.top)
        text = re.sub(r"disc_count = \d+", "disc_count = 500", pathlib.Path(CASE).read_text())
        case = cls.top / "case.toml"
        case.write_text(re.sub(r"(?m)^every = .*", "every = 1", text))
        cls.folder = cls.top / "run"
        cls.done = hfrac("run", case, "-o", cls.folder, "--steps", STEPS, "--movie", "-q")

    def test_a_run_draws_its_own_movie(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        movie = self.folder / "pictures" / "movie.mp4"
        self.assertEqual(movie.read_bytes()[4:8], b"ftyp")
        self.assertEqual([path.name for path in movie.parent.iterdir()], ["movie.mp4"])

    def test_a_killed_render_leaves_no_movie_and_two_runs_the_same_bytes(self):
        movie = self.top / "killed.mp4"
        render = subprocess.Popen([COMMAND, "render", self.folder, "--movie", movie, "--width", "1600", "-q"])
        time.sleep(0.3)
        render.send_signal(signal.SIGKILL)
        render.wait()
        self.assertFalse(movie.exists())
        self.assertEqual(hfrac("render", self.folder, "--movie", movie, "-q").returncode, 0)
        self.assertEqual(movie.read_bytes()[4:8], b"ftyp")
        again = self.top / "again"
        done = hfrac("run", self.folder / "case.toml", "-o", again, "--steps", STEPS, "--movie", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        of_the_run = pathlib.Path("pictures") / "movie.mp4"
        self.assertEqual((again / of_the_run).read_bytes(), (self.folder / of_the_run).read_bytes())

    def test_limits_of_the_system_end_with_words(self):
        folder = self.top / "limited"
        shutil.copytree(self.folder, folder)
        limited = lambda kind, kilobytes: subprocess.run(
            ["bash", "-c", f"ulimit -{kind} {kilobytes}; exec {COMMAND} render {folder} -q"], capture_output=True, text=True)
        for kilobytes in (600000, 800000, 900000, 1000000):
            done = limited("v", kilobytes)
            self.assertEqual(done.returncode, 1, (kilobytes, done.stderr))
            self.assertIn("memory", done.stderr)
        done = limited("f", 10)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("File too large", done.stderr)

    def test_following_a_run_that_is_over_draws_everything(self):
        done = hfrac("render", self.folder, "--follow", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = {path.name for path in (self.folder / "pictures").iterdir()}
        self.assertLessEqual({"movie.mp4", "growth.png", "pressure.png"}, names)

    def test_no_environment_ends_the_process(self):
        bare = {name: value for name, value in os.environ.items() if name in ("LD_LIBRARY_PATH", "PATH")}
        for change in (
            {},
            {"DISPLAY": ":99", "XAUTHORITY": "/no/such/file"},
            {"DISPLAY": "nonsense", "WAYLAND_DISPLAY": "nonsense"},
            {"HOME": "/proc", "XDG_RUNTIME_DIR": "/proc", "XDG_CACHE_HOME": "/proc", "TMPDIR": "/proc"},
            {"LANG": "no_SUCH", "LC_ALL": "no_SUCH", "LIBGL_ALWAYS_INDIRECT": "1", "__GLX_VENDOR_LIBRARY_NAME": "none"},
        ):
            target = self.top / "view.png"
            target.unlink(missing_ok=True)
            done = hfrac("render", self.folder, "--view", "discs,pressure", "-o", target, env={**bare, **change})
            # Mesa itself says a line if it cannot make the folder of its shader cache.
            told = [line for line in done.stderr.splitlines() if "mesa_shader_cache" not in line]
            self.assertEqual((done.returncode, told), (0, []), change)
            self.assertEqual(target.read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
