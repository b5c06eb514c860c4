# SPDX-License-Identifier: BSD-2-Clause
"""A server started by the real command, and a client that behaves like a browser."""
import base64
import http.client
import json
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import tempfile
import time
import unittest

COMMAND = os.path.abspath(os.environ["SOARBOX"])
LESSONS = pathlib.Path(__file__).resolve().parents[2] / "lessons"
# A test that waits longer than this has failed, even on a slow machine.
PATIENCE_S = 120


class Gone(Exception):
    """The other side has closed the connection."""


def printed(console):
    """The lines of a console's document, in one text."""
    lines = [line for node in console["document"] if node["is"] == "transcript" for line in node["lines"]]
    return "".join((line if isinstance(line, str) else line[0]) + "\n" for line in lines)


class WebSocket:
    """A page's connection. Text frames become messages; binary frames are stored in `blocks`."""

    def __init__(self, server, path, protocol=None, origin=None, host=None, source=None):
        self.socket = socket.create_connection(("127.0.0.1", server.port), timeout=PATIENCE_S, source_address=source and (source, 0))
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f"GET {path} HTTP/1.1", f"Host: {host or server.host}", "Upgrade: websocket", "Connection: Upgrade",
                 f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13", f"Origin: {origin or server.origin}"]
        if protocol:
            lines.append(f"Sec-WebSocket-Protocol: {protocol}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        self.held, self.blocks, self.messages, self.contents, self.text_bytes = b"", [], [], {}, 0
        while b"\r\n\r\n" not in self.held:
            self.fill()
        head, self.held = self.held.split(b"\r\n\r\n", 1)
        self.status = int(head.split(b" ")[1])
        self.head = head.decode()

    def fill(self):
        got = self.socket.recv(65536)
        if not got:
            raise Gone()
        self.held += got

    def take(self, count):
        while len(self.held) < count:
            self.fill()
        taken, self.held = self.held[:count], self.held[count:]
        return taken

    @staticmethod
    def frame(opcode, payload):
        """The bytes of one frame, as a browser sends it."""
        mask = os.urandom(4)
        size = len(payload)
        head = bytes([0x80 | opcode])
        head += bytes([0x80 | size]) if size < 126 else bytes([0x80 | 126]) + struct.pack(">H", size) if size < 65536 \
            else bytes([0x80 | 127]) + struct.pack(">Q", size)
        masks = int.from_bytes((mask * (size // 4 + 1))[:size], "big")
        return head + mask + (int.from_bytes(payload, "big") ^ masks).to_bytes(size, "big")

    def send_frame(self, opcode, payload):
        self.socket.sendall(self.frame(opcode, payload))

    def ask(self, **request):
        self.send_frame(1, json.dumps(request).encode())

    def receive(self):
        """The next text message."""
        opcode, message = 0, b""
        while True:
            first, second = self.take(2)
            size = second & 127
            if size == 126:
                size = struct.unpack(">H", self.take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self.take(8))[0]
            payload = self.take(size)
            if first & 15 == 8:
                raise Gone()
            if first & 15 == 9:
                self.send_frame(10, payload)
            if first & 15 > 8:
                continue
            # A message may come in several frames.
            opcode = first & 15 or opcode
            message += payload
            if first & 128 == 0:
                continue
            if opcode == 1:
                self.text_bytes += len(message)
                return json.loads(message)
            self.blocks.append(message)
            message = b""

    def until(self, accepts):
        """Receives until a message is accepted, and returns it."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            message = self.receive()
            self.messages.append(message)
            self.contents.update(message.get("contents", {}))
            if accepts(message):
                return message
        raise AssertionError(f"no such message came; the last were {self.messages[-5:]}")

    def until_message(self, kind):
        return self.until(lambda message: message["message"] == kind)

    def until_contents(self, name, accepts=lambda content: True):
        """Receives until the current state of these contents is accepted, and returns it."""
        if name not in self.contents or not accepts(self.contents[name]):
            self.until(lambda message: name in message.get("contents", {}) and accepts(message["contents"][name]))
        return self.contents[name]

    def until_printed(self, text):
        """Receives until the console has a line with this text, and returns the console's lines in one text."""
        return printed(self.until_contents("console", lambda console: text in printed(console)))

    def close(self):
        self.socket.close()


class Server:
    """`soarbox serve` on a free port."""

    def __init__(self, folder, *options, listen="127.0.0.1:0"):
        self.folder = pathlib.Path(folder)
        self.page = self.folder / "page"
        self.page.mkdir(exist_ok=True)
        (self.page / "index.html").write_text("<!doctype html><title>Soarbox</title>" + "page " * 200, encoding="utf-8")
        self.errors = open(self.folder / "server.err", "w+", encoding="utf-8")
        self.start([COMMAND, "serve", "--listen", listen, "--state", self.folder / "state", "--page", self.page, *options])

    def start(self, words):
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=self.errors, text=True,
                                        env={**os.environ, "XDG_STATE_HOME": str(self.folder / "state"), "BROWSER": "/bin/true"})
        self.lines = [self.process.stdout.readline()]
        found = re.search(r"http://([\d.:]+)/", self.lines[0])
        if not found:
            self.process.wait()
            self.close()
            raise AssertionError((self.folder / "server.err").read_text(encoding="utf-8"))
        self.host = found[1]
        self.port = int(self.host.rsplit(":", 1)[1])
        self.origin = "http://" + self.host

    def http(self, method, path, body=None, **headers):
        """Status, headers and body of one request."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE_S)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        named = {"Host": self.host, **{name.replace("_", "-"): value for name, value in headers.items()}}
        if body is not None:
            named["Content-Length"] = str(len(body))
        for name, value in named.items():
            connection.putheader(name, value)
        connection.endheaders(body)
        answer = connection.getresponse()
        got = answer.read()
        connection.close()
        return answer.status, answer.headers, got

    def json(self, method, path, body=None, **headers):
        status, _, got = self.http(method, path, body, **headers)
        return status, json.loads(got)

    def new_place(self, **headers):
        status, made = self.json("POST", "/api/places", b"", **headers)
        assert status == 200, made
        return made["place"]

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        code = self.process.wait(PATIENCE_S)
        self.close()
        return code

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.close()

    def close(self):
        self.process.stdout.close()
        self.errors.close()

    def engines(self):
        """The ids of the processes that the server has started."""
        # The system lists the processes of each thread.
        numbers = []
        for thread in pathlib.Path(f"/proc/{self.process.pid}/task").iterdir():
            numbers += (thread / "children").read_text(encoding="utf-8").split()
        return [int(number) for number in numbers]


class BrowserRun(Server):
    """`soarbox run X --browser` or `soarbox replay X --browser`."""

    def start(self, words):
        options = words[words.index("--page"):]
        super().start([COMMAND, *options[2:], "--browser", *options[:2]])
        self.token = re.search(r"#token=(\w+)", self.lines[0])[1]


class ServeCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def serve(self, *options, **named):
        server = Server(self.folder, *options, **named)
        self.addCleanup(lambda: server.process.poll() is None and server.kill())
        return server

    def page(self, server, place, **options):
        page = WebSocket(server, f"/api/p/{place}/run", **options)
        self.addCleanup(page.close)
        return page

    def opened(self, server, place, what, *panels):
        """A page that opens a run and requests these panels."""
        page = self.page(server, place)
        page.until_message("none")
        page.ask(request="open", what=what)
        begun = page.until(lambda message: message["message"] in ("hello", "error", "ended"))
        self.assertEqual(begun["message"], "hello", begun)
        page.ask(request="look", panels=list(panels))
        return page

    def wait_for(self, condition, what):
        end = time.monotonic() + PATIENCE_S
        while not condition() and time.monotonic() < end:
            time.sleep(0.05)
        self.assertTrue(condition(), what)
