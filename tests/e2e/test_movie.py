"""Movies made while the run goes on, and movies whose making was killed; and drawing in whatever environment."""
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

    def test_a_killed_render_goes_on(self):
        movie = self.top / "killed.mp4"
        pieces = self.top / ".killed.mp4.pieces"
        render = subprocess.Popen([COMMAND, "render", self.folder, "--movie", movie, "--width", "1600", "-q"])
        end = time.monotonic() + 120
        while not (pieces / "000000.piece").exists() and time.monotonic() < end and render.poll() is None:
            time.sleep(0.005)
        render.send_signal(signal.SIGKILL)
        render.wait()
        self.assertFalse(movie.exists())
        kept = (pieces / "000000.piece").stat().st_mtime_ns
        watched = subprocess.Popen([COMMAND, "render", self.folder, "--movie", movie, "--width", "1600", "-q"])
        while not (pieces / "000001.piece").exists() and not movie.exists() and watched.poll() is None:
            time.sleep(0.005)
        if (pieces / "000000.piece").exists():
            self.assertEqual((pieces / "000000.piece").stat().st_mtime_ns, kept, "the first piece was made again")
        self.assertEqual(watched.wait(), 0)
        self.assertEqual(movie.read_bytes()[4:8], b"ftyp")
        self.assertFalse(pieces.exists())

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
