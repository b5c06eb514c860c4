# SPDX-License-Identifier: BSD-2-Clause
"""Agents that a program of its own drove, on pages: their recording, and their kernel while it runs."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from web_client import COMMAND, BrowserRun, WebSocket

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "app"))
from protocol_client import Client  # noqa: E402
from soarbox_command import free_port  # noqa: E402
from test_recorded_clients import APPLY, BEGIN, COUNT  # noqa: E402

PANELS = ["agents", "mind", "operators", "memory", "rules", "why", "trace", "timeline", "console"]


class Clients(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_port()

    def start_kernel(self, *options):
        kernel = subprocess.Popen([COMMAND, "kernel", "--port", str(self.port), *map(str, options)], stdout=subprocess.PIPE, text=True)
        self.addCleanup(kernel.stdout.close)
        self.addCleanup(kernel.wait)
        self.addCleanup(kernel.kill)
        self.assertIn("listens on", kernel.stdout.readline())
        return kernel

    @staticmethod
    def begin(client):
        client.call("create_agent", name="counter")
        for line in (BEGIN, COUNT, APPLY, "wm add I2 limit 100"):
            client.line("counter", line)

    def page(self, what, *words):
        server = BrowserRun(self.folder, *words)
        self.addCleanup(lambda: server.process.poll() is None and server.kill())
        place = server.new_place(Authorization="Bearer " + server.token)
        page = WebSocket(server, f"/api/p/{place}/run", protocol="soarbox." + server.token)
        self.addCleanup(page.close)
        page.until_message("none")
        page.ask(request="open", what=what)
        page.hello = page.until_message("hello")
        page.ask(request="look", panels=PANELS)
        return page

    def test_a_recording_fills_the_panels(self):
        file = self.folder / "run.soarrec"
        kernel = self.start_kernel("--record", file)
        with Client(self.port) as client:
            self.begin(client)
            for _ in range(4):
                client.line("counter", "run 2")
        kernel.terminate()
        kernel.wait()
        page = self.page("recording:run.soarrec", "replay", file)
        self.assertEqual((page.hello["minds"], page.hello["is_recording"]), (["counter"], True))
        page.ask(request="select", agent="counter")
        page.ask(request="seek", tick=5)
        for name in ("mind", "memory", "rules", "trace", "timeline"):
            self.assertIn("count", str(page.until_contents(name, lambda content: "count" in str(content))), name)
        page.ask(request="ask", about="operator", what="count")
        self.assertIn("propose*count", str(page.until_contents("why", lambda content: "propose*count" in str(content))))

    def test_a_kernel_is_watched_while_its_client_drives_it(self):
        self.start_kernel()
        with Client(self.port) as client:
            self.begin(client)
            client.line("counter", "run 3")
            page = self.page("run:kernel", "watch", f"127.0.0.1:{self.port}")
            self.assertEqual((page.hello["minds"], page.hello["is_recording"]), (["counter"], False))
            page.ask(request="select", agent="counter")
            page.until_contents("memory", lambda content: "count" in str(content))
            client.line("counter", "run 20")
            page.until(lambda message: message["message"] == "flow" and message["tick"] >= 23)
            # What is typed goes to the kernel, whose log brings it back.
            page.ask(request="console", agent="counter", line="wm add S1 ^typed here")
            self.assertIn("typed", self.until_line(client, "print S1", "typed"))
            page.until_contents("memory", lambda content: "typed" in str(content))
            # The past is there.
            page.ask(request="seek", tick=4)
            page.until(lambda message: message["message"] == "flow" and message["tick"] == 4)
            page.until_contents("memory", lambda content: "count" in str(content) and "typed" not in str(content))

    @staticmethod
    def until_line(client, line, wanted):
        """What the kernel answers once it has carried out what a page typed."""
        for _ in range(600):
            text = client.line("counter", line)
            if wanted in str(text):
                return str(text)
        return ""


if __name__ == "__main__":
    unittest.main()
