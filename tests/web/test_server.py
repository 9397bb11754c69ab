"""`hfrac view` as a program: what it prints, how it ends, what it serves and what it refuses."""
import http.client
import json
import os
import pathlib
import random
import re
import resource
import select
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.parse

COMMAND = os.environ["HFRAC_COMMAND"]
RUN = pathlib.Path(os.environ["HFRAC_RUN"])


class View:
    """A running `hfrac view`; `self.base` is the path with the key."""

    def __init__(self, folder, *options):
        self.process = subprocess.Popen([COMMAND, "view", folder, "--no-open", *options], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        ready, _, _ = select.select([self.process.stdout], [], [], 20)
        assert ready, "no address after 20 s"
        self.line = self.process.stdout.readline()
        address = urllib.parse.urlsplit(self.line.strip())
        self.port, self.base = address.port, address.path

    def get(self, path, method="GET", **headers):
        """Status, headers and body; the path is sent as it is."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host="Host" in headers)
        for name, value in headers.items():
            connection.putheader(name, value)
        connection.endheaders()
        response = connection.getresponse()
        body = response.read()
        connection.close()
        return response.status, dict(response.getheaders()), body

    def end(self, how=signal.SIGINT):
        self.process.send_signal(how)
        out, err = self.process.communicate(timeout=20)
        return self.process.returncode, out, err


class Program(unittest.TestCase):
    def test_prints_one_address_and_ends_well_on_ctrl_c(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            view = View(RUN, "--port", "0")
            self.assertRegex(view.line, r"^http://127\.0\.0\.1:[1-9][0-9]*/[0-9a-f]{32}/\n$")
            begin = time.monotonic()
            code, out, err = view.end(how)
            self.assertEqual((code, out, err), (0, "", ""))
            self.assertLess(time.monotonic() - begin, 5)

    def test_says_so_if_the_port_is_taken(self):
        view = View(RUN, "--port", "0")
        done = subprocess.run([COMMAND, "view", RUN, "--port", str(view.port), "--no-open"], capture_output=True,
                              text=True, timeout=20)
        view.end()
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"port {view.port} of 127.0.0.1 is in use", done.stderr)
        self.assertIn("--port 0", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_takes_its_port_again_at_once(self):
        view = View(RUN, "--port", "0")
        view.get(view.base)
        view.end()
        again = View(RUN, "--port", str(view.port))
        self.assertEqual(again.port, view.port)
        self.assertNotEqual(again.base, view.base, "each start has its own key")
        again.end()

    def test_refuses_what_is_no_folder(self):
        for folder in ("/no/such/folder", RUN / "history.csv"):
            done = subprocess.run([COMMAND, "view", folder, "--no-open"], capture_output=True, text=True, timeout=20)
            self.assertEqual(done.returncode, 2)
            self.assertIn("there is no folder", done.stderr)
        done = subprocess.run([COMMAND, "view", RUN, "--port", "70000"], capture_output=True, text=True, timeout=20)
        self.assertEqual(done.returncode, 2)

    def test_listens_on_loopback_only(self):
        view = View(RUN, "--port", "0")
        pattern = re.compile(rf":{view.port:04X} ")
        tables = [pathlib.Path("/proc/net/tcp"), pathlib.Path("/proc/net/tcp6")]
        local = [line.split()[1] for table in tables if table.exists() for line in table.read_text().splitlines()
                 if line.split()[3] == "0A" and pattern.search(line.split()[1] + " ")]
        view.end()
        self.assertEqual(local, [f"0100007F:{view.port:04X}"])


class Record(unittest.TestCase):
    """A field's pressures beside the run's: of --record, or of the record that the run's case names."""

    def setUp(self):
        self.top = pathlib.Path(tempfile.mkdtemp(prefix="hfrac-record-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.record = self.top / "pump.csv"
        self.record.write_text("time_s,rate_L_min,pressure_MPa\n0,6,20\n1,6,20.5\n2,0,20.25\n3,0,20\n")

    def served(self, *arguments):
        view = View(*arguments, "--port", "0")
        status, headers, body = view.get(view.base + "api/record")
        view.end()
        self.assertEqual((status, headers["Content-Type"].split(";")[0]), (200, "text/csv"))
        return body.decode()

    def test_by_name(self):
        self.assertEqual(self.served(RUN), "")
        self.assertEqual(self.served(RUN, "--record", self.record),
                         "time_s,pressure_Pa\n0,20000000\n1,20500000\n2,20250000\n3,20000000\n")
        self.record.write_text("time_s,rate_L_min\n0,6\n1,6\n")
        done = subprocess.run([COMMAND, "view", RUN, "--no-open", "--record", self.record], capture_output=True, text=True, timeout=20)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no column of pressure", done.stderr)
        done = subprocess.run([COMMAND, "view", RUN, "--no-open", "--record", RUN / "case.toml"], capture_output=True, text=True, timeout=20)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has a schedule_file", done.stderr)

    def test_of_the_case(self):
        case, run = self.top / "case.toml", self.top / "run"
        case.write_text("[packing]\ndisc_count = 400\n[stress]\nsigma_Hmax = 30e6\nsigma_hmin = 30e6\n[fluid]\nformation_pressure = 10e6\n"
                        "[stepping]\nmode = \"coupled\"\nflow_step = 1.0\nend_time = 3.0\n[solver]\nkind = \"quasi-static\"\n"
                        "[[well]]\nradius = 10.0\ncontrol = \"rate\"\nschedule_file = \"pump.csv\"\nschedule_thickness = 10.0\n")
        done = subprocess.run([COMMAND, "run", case, "-o", run, "-q"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("20500000", self.served(run))
        other = self.top / "other.csv"
        other.write_text("time_s,pressure_bar\n0,300\n3,310\n")
        self.assertEqual(self.served(run, "--record", other), "time_s,pressure_Pa\n0,30000000\n3,31000000\n")
        self.record.write_text("time_s,rate_L_min\n0,6\n3,0\n")  # one without pressures leaves none of the run before
        done = subprocess.run([COMMAND, "run", case, "-o", run, "-q", "--overwrite"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.served(run), "")


class Served(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.view = View(RUN, "--port", "0")
        cls.addClassCleanup(cls.view.end)

    def get(self, path, **options):
        return self.view.get(self.view.base + path, **options)

    def test_the_page(self):
        status, headers, body = self.get("")
        self.assertEqual(status, 200)
        self.assertIn(b"viewer.js", body)
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertNotIn("Access-Control-Allow-Origin", headers)
        for name in ("viewer.js", "viewer.css"):
            status, headers, body = self.get(name)
            self.assertEqual(status, 200)
            self.assertGreater(len(body), 1000)
        self.assertNotIn(b"https://unpkg", body)

    def test_the_index_and_the_grids(self):
        status, _, body = self.get("api/run")
        self.assertEqual(status, 200)
        index = json.loads(body)
        self.assertFalse(index["running"])
        self.assertEqual(index["snapshots"][0]["step"], 0)
        last = index["snapshots"][-1]
        self.assertEqual(set(last["files"]), {"discs", "bonds", "cracks", "flow"})
        for file in last["files"].values():
            status, _, body = self.get(f"api/grid?file={file}")
            self.assertEqual((status, body[:4]), (200, b"HFG1"))
            length = int.from_bytes(body[4:8], "little")
            head = json.loads(body[8:8 + length])
            sizes = {"f32": 4, "i32": 4, "f64": 8}
            for array in head["arrays"]:
                end = 8 + length + array["offset"] + array["length"] * sizes[array["type"]]
                self.assertLessEqual(end, len(body), array["name"])
            units = {array["name"]: array["unit"] for array in head["arrays"]}
            for name, unit in units.items():
                for suffix in ("N_m", "m", "Pa", "N", "rad", "s"):
                    if name.endswith("_" + suffix) and not name.endswith("per_s"):
                        self.assertEqual(unit, suffix.replace("_", " "), name)
                        break
        status, _, body = self.get(f"api/values?file={last['files']['discs']}&of=points&index=3")
        values = {item["name"]: item for item in json.loads(body)}
        self.assertEqual(status, 200)
        self.assertGreater(values["radius_m"]["values"][0], 0)
        self.assertEqual(values["radius_m"]["unit"], "m")

    def test_the_history_in_parts(self):
        whole = (RUN / "history.csv").read_bytes()
        self.assertEqual(self.get("api/history?from=0")[2], whole)
        self.assertEqual(self.get("api/history?from=1000")[2], whole[1000:])
        self.assertEqual(self.get(f"api/history?from={len(whole)}")[2], b"")
        self.assertEqual(self.get(f"api/history?from={len(whole) + 1}")[0], 416)
        for wrong in ("-1", "x", "1e3", "99999999999999999999", ""):
            self.assertEqual(self.get(f"api/history?from={wrong}")[0], 400, wrong)

    def test_files_to_be_saved(self):
        for name in ("history.csv", "summary.json", "case.toml", "discs_00000.vtu", "discs.pvd"):
            status, headers, body = self.get(f"files/{name}")
            self.assertEqual(status, 200)
            self.assertEqual(body, (RUN / name).read_bytes(), name)
            self.assertIn("attachment", headers["Content-Disposition"])

    def test_nothing_without_the_key(self):
        for path in ("/", "/api/run", "/viewer.js", "/files/history.csv", "/0" * 16 + "/",
                     self.view.base[:-2] + "/", self.view.base.upper() + "x"):
            self.assertEqual(self.view.get(path)[0], 404, path)

    def test_nothing_for_other_hosts(self):
        for host in ("evil.example", f"evil.example:{self.view.port}", "127.0.0.1.evil.example", ""):
            status, _, body = self.get("api/run", Host=host)
            self.assertEqual(status, 403, host)
            self.assertNotIn(b"snapshots", body)
        self.assertEqual(self.get("api/run", Host=f"localhost:{self.view.port}")[0], 200)

    def test_nothing_is_written(self):
        before = {path.name: path.stat().st_mtime_ns for path in RUN.iterdir()}
        for method in ("POST", "PUT", "DELETE", "PATCH", "OPTIONS"):
            self.assertGreaterEqual(self.get("files/history.csv", method=method)[0], 400, method)
        self.assertEqual(before, {path.name: path.stat().st_mtime_ns for path in RUN.iterdir()})

    def test_no_way_out_of_the_folder(self):
        up = ("..", "%2e%2e", "%2E.", ".%2e", "%252e%252e", "..%2f..", "%2e%2e%2f", "..%5c", "..\\", "....//",
              "%c0%ae%c0%ae", "..;", "pictures/../..")
        tricks = [f"files/{one}/{target}" for one in up for target in ("etc/passwd", "run/history.csv", "../etc/passwd")]
        tricks += ["files//etc/passwd", "files/%2fetc%2fpasswd", "files/history.csv%00.png", "files/", "files",
                   "files/.", "files/pictures", "files/.hfrac_probe", "api/grid?file=../run/discs_00000.vtu",
                   "api/grid?file=%2fetc%2fpasswd", "api/grid?file=history.csv", "api/grid", "api/grid?file=",
                   "api/values?file=discs_00000.vtu&of=points&index=-1",
                   "api/values?file=discs_00000.vtu&of=points&index=99999999", "api", "../", "viewer.js/..", "%00"]
        for trick in tricks:
            status, _, body = self.get(trick)
            self.assertEqual(status, 404, (trick, body[:80]))
            self.assertNotIn(b"root:", body)
            self.assertNotIn(b"step,time_s", body)

    def test_no_folder_is_listed(self):
        for path in ("files/", "files", "api/", "pictures/"):
            status, _, body = self.get(path)
            self.assertEqual(status, 404)
            self.assertNotIn(b"discs", body)

    def test_answers_are_whole_whatever_range_is_asked_for(self):
        files = [f"api/grid?file={path.name}" for path in RUN.glob("discs_00000.vtu")] + ["files/history.csv", "viewer.css"]
        chance = random.Random(1)
        for path in files:
            status, headers, whole = self.get(path)
            size = len(whole)
            self.assertEqual((status, headers.get("Accept-Ranges")), (200, "none"))
            ranges = ["0-0", f"{size - 1}-{size + 3000000}", f"{size // 2}-3000000000", "99999999999-", "-99999999999", f"{size}-",
                      "0-0,1-1", f"0-10,{size * 2}-{size * 3}", "5-2", "18446744073709551615-18446744073709551615"]
            numbers = (0, 1, size - 1, size, size + 1, 2 * size, 2**31, 2**32, 2**63 - 1)
            for _ in range(100):
                first, last = (chance.choice((chance.randrange(3 * size), *numbers, "")) for _ in range(2))
                ranges.append(f"{first}-{last}" + chance.choice(("", "", f",{last}-{first}")))
            for one in ranges:
                status, headers, body = self.get(path, Range=f"bytes={one}")
                self.assertIn(status, (200, 416), one)
                if status == 200:
                    self.assertEqual(body, whole, one)
                else:  # words that are no range at all
                    self.assertLess(len(body), 100, one)

    def test_the_address_without_its_last_slash_leads_to_the_page(self):
        status, headers, _ = self.view.get(self.view.base.rstrip("/"))
        self.assertEqual((status, headers["Location"]), (302, self.view.base))

    def test_a_connection_serves_many_requests(self):
        connection = http.client.HTTPConnection("127.0.0.1", self.view.port, timeout=20)
        self.addCleanup(connection.close)
        sockets = set()
        for _ in range(50):
            connection.request("GET", self.view.base + "api/run")
            self.assertEqual(connection.getresponse().read()[:1], b"{")
            sockets.add(connection.sock)
        self.assertEqual(len(sockets), 1)
        one = f"GET {self.view.base}viewer.css HTTP/1.1\r\nHost: localhost\r\n\r\n".encode()
        with socket.create_connection(("127.0.0.1", self.view.port), timeout=20) as plug:
            plug.sendall(one + one[:20])  # two requests in three pieces
            time.sleep(0.1)
            plug.sendall(one[20:])
            answers = b""
            while answers.count(b"HTTP/1.1 200") < 2:
                answers += plug.recv(65536)

    def test_connections_without_the_key_keep_nobody_out(self):
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4096), hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        plugs = []
        self.addCleanup(lambda: [plug.close() for plug in plugs])

        def plug_in(count, text):
            for _ in range(count):
                plugs.append(socket.create_connection(("127.0.0.1", self.view.port), timeout=20))
                plugs[-1].sendall(text)

        for count, text in ((24, b"G"), (1000, b""), (100, b"GET / HTTP/1.1\r\nHost: localhost\r\n"),
                            (100, b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"), (50, b"x" * 20000),
                            (50, b"POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000000\r\n\r\nx")):
            plug_in(count, text)
            for _ in range(3):
                begin = time.monotonic()
                self.assertEqual(self.get("api/run")[0], 200)
                self.assertLess(time.monotonic() - begin, 3, (count, text[:20]))
        slow = plugs[:12]
        for _ in range(8):  # a byte now and then keeps no connection alive
            for plug in slow:
                try:
                    plug.sendall(b"E")
                except OSError:
                    pass
            time.sleep(1)
        for plug in slow:
            plug.settimeout(1)
            try:
                self.assertEqual(plug.recv(1), b"", "it is still open")
            except ConnectionError:
                pass

    def test_nonsense_does_not_end_it(self):
        for text in (b"\0\0\0\0\r\n\r\n", b"GET\r\n\r\n", b"GET " + b"a" * 100000 + b" HTTP/1.1\r\n\r\n",
                     b"GET / HTTP/1.1\r\nHost: x\r\nContent-Length: -5\r\n\r\n"):
            with socket.create_connection(("127.0.0.1", self.view.port), timeout=20) as plug:
                try:
                    plug.sendall(text)
                    plug.shutdown(socket.SHUT_WR)
                    plug.recv(65536)
                except OSError:
                    pass
        self.assertEqual(self.get("api/run")[0], 200)


class Growing(unittest.TestCase):
    def test_links_out_of_the_folder_are_not_followed_and_damage_is_told(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-web-") as top:
            folder = pathlib.Path(top) / "run"
            shutil.copytree(RUN, folder)
            (pathlib.Path(top) / "secret.csv").write_text("secret")
            (folder / "secret.csv").symlink_to(pathlib.Path(top) / "secret.csv")
            text = (folder / "discs_00000.vtu").read_bytes()
            (folder / "discs_00000.vtu").write_bytes(text[:len(text) // 2])
            view = View(folder, "--port", "0")
            self.assertEqual(view.get(view.base + "files/secret.csv")[0], 404)
            status, _, body = view.get(view.base + "api/grid?file=discs_00000.vtu")
            self.assertEqual(status, 404)
            self.assertIn(b"discs_00000.vtu", body)
            (folder / "discs_00000.vtu").write_bytes(text)
            self.assertEqual(view.get(view.base + "api/grid?file=discs_00000.vtu")[0], 200)
            code, _, err = view.end()
            self.assertEqual((code, err), (0, ""))

    def test_a_folder_may_be_empty_and_fill_later(self):
        with tempfile.TemporaryDirectory(prefix="hfrac-web-") as folder:
            view = View(folder, "--port", "0")
            self.assertEqual(json.loads(view.get(view.base + "api/run")[2])["snapshots"], [])
            self.assertEqual(view.get(view.base + "api/history")[0], 200)
            shutil.copytree(RUN, folder, dirs_exist_ok=True)
            self.assertTrue(json.loads(view.get(view.base + "api/run")[2])["snapshots"])
            view.end()


if __name__ == "__main__":
    unittest.main()
