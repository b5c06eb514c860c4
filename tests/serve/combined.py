# SPDX-License-Identifier: BSD-2-Clause
"""Attacks a server in all known ways at once while a class learns, and measures the effect on the class.

usage: combined.py [--seconds S] [--learners N]

Prints how long another page waits for an answer, the ticks that the worlds of the class reached, and the maximum memory and number of
processes of the server. test_attack.py runs the same for a few seconds, with limits that hold on any machine.
"""
import argparse
import io
import json
import multiprocessing
import os
import pathlib
import resource
import socket
import statistics
import tempfile
import threading
import time
import zipfile

from web_client import Gone, Server, WebSocket

WORLD = "scenario:soar_hallway"


def status_mb(pid, what):
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    return next(int(line.split()[1]) for line in status.splitlines() if line.startswith(what + ":")) / 1024


def memory_mb(pid):
    return status_mb(pid, "VmRSS")


def most_memory_mb(pid):
    """Memory limit of a server. A build that checks memory (it reserves terabytes of addresses) keeps freed memory for a while."""
    return 300 if status_mb(pid, "VmSize") < 1_000_000 else 1_500


def cpu_s(pid):
    """Processor time of a process, in seconds."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def archive_of(count, size):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as writing:
        for i in range(count):
            writing.writestr(str(i), os.urandom(size))
    return packed.getvalue()


class Attackers:
    """Threads that attack until they are stopped. They continue after the server has refused something or closed a connection."""

    def __init__(self, server, big_recording):
        self.server, self.is_over, self.threads = server, threading.Event(), []
        self.rounds, self.places = {}, []
        self.archive, self.big_recording = archive_of(256, 1_000), big_recording
        self.frames = {
            "keys": WebSocket.frame(1, json.dumps({f"{i:05}": 0 for i in range(80_000)}).encode()),
            "deep": WebSocket.frame(1, b"[" * 900_000),
            "long": WebSocket.frame(1, json.dumps({"request": "x", "a": "b" * 1_000_000}).encode()),
            "pings": WebSocket.frame(9, b"x" * 100) * 1000,
        }

    def work(self, is_over, rounds):
        """Runs in a separate process, so that attacks do not delay the measurements. Sends the number of rounds at the end."""
        threading.Thread(target=lambda: (is_over.wait(), self.is_over.set()), daemon=True).start()
        self.start()
        for thread in self.threads:
            thread.join()
        rounds.send(self.rounds)

    def start(self):
        for name in ("keys", "deep", "long", "pings"):
            self.attack(name, lambda name=name: self.flood(self.frames[name]))
        for attack in (self.open, self.hang, self.folders, self.archives, self.download, self.pages, self.tokens):
            self.attack(attack.__name__, attack)

    def attack(self, name, once):
        def again():
            while not self.is_over.is_set():
                self.rounds[name] = self.rounds.get(name, 0) + 1
                try:
                    once()
                except (Gone, OSError, ValueError):
                    pass
                self.is_over.wait(0.01)
        thread = threading.Thread(target=again, daemon=True)
        thread.start()
        self.threads.append(thread)

    def place(self):
        """A new place. If the server refuses to create more for this address: one of the existing places."""
        status, made = self.server.json("POST", "/api/places", b"")
        if status == 200:
            self.places.append(made["place"])
        elif not self.places:
            raise Gone()
        return made["place"] if status == 200 else self.places[sum(self.rounds.values()) % len(self.places)]

    def page(self):
        page = WebSocket(self.server, f"/api/p/{self.place()}/run")
        if page.status != 101:
            page.close()
            raise Gone()
        page.socket.settimeout(5)
        return page

    def flood(self, frame):
        page = self.page()
        try:
            for _ in range(20):
                page.socket.sendall(frame)
        finally:
            page.close()

    def open(self):
        page = self.page()
        for i in range(200):
            page.ask(request="open", what=WORLD if i % 2 else "scenario:thesis")
        self.is_over.wait(2)
        page.close()

    def hang(self):
        page = self.page()
        page.ask(request="open", what=WORLD)
        mind = page.until_message("hello")["minds"][0]
        for _ in range(20):
            page.ask(request="console", agent=mind, line="run 100000000")
        self.is_over.wait(3)
        page.close()

    def folders(self):
        place = self.place()
        for i in range(50):
            for method, body in (("PUT", b"x"), ("DELETE", None)):
                self.server.http(method, f"/api/p/{place}/files/{i}/a/b/c/d/e/f/x", body)

    def archives(self):
        place = self.place()
        for _ in range(5):
            self.server.http("POST", f"/api/p/{place}/zip", self.archive)
            self.server.http("GET", f"/api/p/{place}/zip")

    def download(self):
        sleepers = []
        try:
            for _ in range(40):
                sleepers.append(socket.create_connection(("127.0.0.1", self.server.port), timeout=5))
                sleepers[-1].sendall(f"GET {self.big_recording} HTTP/1.1\r\nHost: {self.server.host}\r\n\r\n".encode())
            self.is_over.wait(2)
        finally:
            for sleeper in sleepers:
                sleeper.close()

    def pages(self):
        pages = [self.page() for _ in range(20)]
        self.is_over.wait(1)
        for page in pages:
            page.close()

    def tokens(self):
        for _ in range(20):
            self.server.http("POST", "/api/places", b"", Authorization="Bearer wrong")


class Learner(threading.Thread):
    """A learner of the class: watches a run, and types."""

    def __init__(self, server, place):
        super().__init__(daemon=True)
        self.server, self.place, self.is_over = server, place, threading.Event()
        self.tick, self.answers, self.refusals, self.fault = 0, [], [], None

    def run(self):
        try:
            page = WebSocket(self.server, f"/api/p/{self.place}/run")
            page.ask(request="open", what="lesson:01-a-rule")
            page.until_message("hello")
            page.ask(request="look", panels=["agents", "edit"])
            while not self.is_over.is_set():
                begin = time.monotonic()
                for what, is_paused in (("pause", True), ("go-on", False)):
                    page.ask(request="flow", what=what)
                    page.until(lambda message, is_paused=is_paused: message["message"] == "flow" and message["paused"] == is_paused)
                self.answers.append(time.monotonic() - begin)
                end = begin + 1
                while time.monotonic() < end:
                    message = page.receive()
                    if message["message"] == "flow":
                        self.tick = message["tick"]
                    if message["message"] == "error":
                        self.refusals.append(message)
            page.close()
        except (Gone, OSError) as fault:
            self.fault = repr(fault)


class Combined:
    """A server with a class, which is attacked for some seconds."""

    def __init__(self, folder, learners):
        self.folder = pathlib.Path(folder)
        names = self.folder / "names.txt"
        names.write_text("".join(f"learner {i}\n" for i in range(learners)), encoding="utf-8")
        self.server = Server(self.folder, "--class", names, "--hang", "10")
        links = [self.server.process.stdout.readline().strip() for _ in range(learners + 1)]
        self.places = [link.rsplit(": ", 1)[1].removeprefix(self.server.origin).split("/")[2] for link in links[1:]]
        place = self.server.new_place()
        recordings = self.folder / "state" / "places" / place / "state" / "soarbox" / "recordings"
        recordings.mkdir(parents=True)
        (recordings / "big.soarrec").write_bytes(os.urandom(1 << 20) * 16)
        self.attackers = Attackers(self.server, f"/api/p/{place}/recordings/big.soarrec")
        self.learners = [Learner(self.server, place) for place in self.places]
        self.most_memory_mb = most_memory_mb(self.server.process.pid)
        self.waits, self.memory_mb, self.processes, self.rounds = [], 0, 0, {}

    def run(self, seconds, least_answers=0):
        """Attacks for at least this time, and until each learner has got `least_answers` answers."""
        forks = multiprocessing.get_context("fork")
        is_over, (received, sent) = forks.Event(), forks.Pipe(False)
        attacking = forks.Process(target=self.attackers.work, args=(is_over, sent), daemon=True)
        attacking.start()
        for learner in self.learners:
            learner.start()
        end = time.monotonic() + seconds
        while time.monotonic() < end or any(len(learner.answers) < least_answers and learner.is_alive() for learner in self.learners):
            begin = time.monotonic()
            status = self.server.http("GET", f"/api/p/{self.places[len(self.waits) % len(self.places)]}")[0]
            self.waits.append((time.monotonic() - begin, status))
            self.memory_mb = max(self.memory_mb, memory_mb(self.server.process.pid))
            self.processes = max(self.processes, len(self.server.engines()))
            time.sleep(0.05)
        is_over.set()
        self.rounds = received.recv()
        attacking.join()
        for learner in self.learners:
            learner.is_over.set()
            learner.join()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--learners", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=300)
    options = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        combined = Combined(folder, options.learners)
        combined.run(options.seconds)
        waits = sorted(wait for wait, _ in combined.waits)
        answers = sorted(answer for learner in combined.learners for answer in learner.answers)
        print(f"{options.seconds:g} s; rounds of attacks: {combined.rounds}")
        print(f"another page's request: median {statistics.median(waits) * 1000:.0f} ms, 95 % {waits[int(len(waits) * 0.95)] * 1000:.0f} ms, "
              f"most {waits[-1] * 1000:.0f} ms, {len(waits)} requests, refused {sum(status != 200 for _, status in combined.waits)}")
        print(f"a learner's two requests: median {statistics.median(answers) * 1000:.0f} ms, most {answers[-1] * 1000:.0f} ms; ticks "
              f"{[learner.tick for learner in combined.learners]}, refused {sum(len(learner.refusals) for learner in combined.learners)}, "
              f"faults {[learner.fault for learner in combined.learners if learner.fault]}")
        print(f"server: at most {combined.memory_mb:.0f} MB, {combined.processes} processes")
        combined.server.kill()


if __name__ == "__main__":
    main()
