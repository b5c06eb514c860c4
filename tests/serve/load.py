# SPDX-License-Identifier: BSD-2-Clause
"""Simulates many learners of a server, and measures the load (not a test: docs/serve.md describes how to run it).

usage: load.py [--learners N] [--seconds S] [--streams N] [--stream-seconds S]

The server allows one run for each learner. Each learner opens a lesson, requests the panels that a page shows, types into the editor from time to
time, applies the solution in the middle, and requests *Why* and hints. After all have begun, the server must refuse one more learner. Afterwards
the learners leave, and pages watch one run of soar_skirmish.

Prints the delay of the worlds after the first quarter, in which all worlds begin (95 % of all ticks are no later), the waiting times of requests,
the answer to the refused learner, bytes per second and learner, memory per run, processor time, and the number of browsers that one core of the
server can serve.
"""
import argparse
import contextlib
import os
import pathlib
import resource
import statistics
import tempfile
import threading
import time

from web_client import LESSONS, Gone, Server, WebSocket

NAMES = sorted(path.name for path in LESSONS.iterdir() if (path / "lesson.toml").exists())


def memory_mb(pid):
    """The memory of a process, with shared pages counted proportionally."""
    with open(f"/proc/{pid}/smaps_rollup", encoding="utf-8") as rollup:
        return sum(int(line.split()[1]) for line in rollup if line.startswith("Pss:")) / 1024


def cpu_s(pid):
    with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Learner(threading.Thread):
    def __init__(self, server, lesson, seconds, source):
        super().__init__(daemon=True)
        self.server, self.lesson, self.seconds, self.source = server, lesson, seconds, source
        self.lateness, self.bytes, self.fault = [], 0, None

    def run(self):
        try:
            self.learn()
        except (Gone, OSError, KeyError, IndexError) as fault:
            self.fault = repr(fault)

    def learn(self):
        page = WebSocket(self.server, f"/api/p/{self.server.new_place()}/run", source=self.source)
        page.ask(request="open", what="lesson:" + self.lesson)
        page.until_message("hello")
        page.ask(request="look", panels=["agents", "mission", "edit", "mind", "why", "problems"])
        edit = page.until_contents("edit", lambda edit: edit["files"])
        page.ask(request="edit", file=edit["files"][0]["file"])
        solution = "\n".join(file.read_text(encoding="utf-8") for file in (LESSONS / self.lesson / "solution").glob("*.soar"))
        begin, typed, applied, first = time.monotonic(), 0, False, None
        while time.monotonic() - begin < self.seconds:
            message = page.receive()
            now = time.monotonic() - begin
            if message["message"] == "flow" and not message["paused"]:
                # Delays are relative to the smallest one.
                behind = now - message["time_s"]
                # Ignores the first quarter, in which all worlds start: a world does not make up for time that it loses then.
                if now > self.seconds / 4:
                    first = behind if first is None else min(first, behind)
                    self.lateness.append(behind)
            if now - typed > 3:
                typed = now
                page.ask(request="edit-text", what="type", text=solution[:int(len(solution) * min(1, now / self.seconds))])
                page.ask(request="ask", about="agent")
            if now > self.seconds / 2 and not applied:
                applied = True
                page.ask(request="edit-text", what="apply", text=solution)
                page.ask(request="lesson", what="hint")
        self.lateness = [late - first for late in self.lateness]
        self.bytes = sum(map(len, page.blocks)) + page.text_bytes
        page.close()


class Watcher(threading.Thread):
    def __init__(self, server, place, seconds):
        super().__init__(daemon=True)
        self.server, self.place, self.seconds, self.blocks, self.fault = server, place, seconds, 0, None

    def run(self):
        try:
            page = WebSocket(self.server, f"/api/p/{self.place}/run")
            end = time.monotonic() + self.seconds
            while time.monotonic() < end:
                page.receive()
            self.blocks = len(page.blocks)
            page.close()
        except (Gone, OSError) as fault:
            self.fault = repr(fault)


class Asker(threading.Thread):
    """A separate page that repeatedly requests its place and the start page, and measures the time of each answer."""

    def __init__(self, server):
        super().__init__(daemon=True)
        self.server, self.is_over, self.waits_s, self.statuses = server, threading.Event(), [], set()

    def run(self):
        paths = ("/api/p/" + self.server.new_place(), "/")
        while not self.is_over.wait(0.2):
            for path in paths:
                begin = time.monotonic()
                self.statuses.add(self.server.http("GET", path)[0])
                self.waits_s.append(time.monotonic() - begin)


def describe(what, seconds):
    """The distribution of times, in milliseconds."""
    seconds = sorted(seconds)
    return (f"{what}: median {statistics.median(seconds) * 1000:.0f} ms, 95 % {seconds[int(len(seconds) * 0.95)] * 1000:.0f} ms, "
            f"most {seconds[-1] * 1000:.0f} ms")


def what_the_next_is_told(server):
    """The server's answer to one learner too many."""
    page = WebSocket(server, f"/api/p/{server.new_place()}/run")
    if page.status == 101:
        page.close()
        return "101: it was let in"
    page.socket.settimeout(5)
    try:
        while True:
            page.fill()
    except (Gone, OSError):
        page.close()
    return f"{page.status} {page.held.decode(errors='replace').strip()}"


def measure_streams(server, count, seconds):
    """The number of pages that one core of the server can serve with one run, computed from the cost of `count` pages."""
    place = server.new_place()
    page = WebSocket(server, f"/api/p/{place}/run")
    page.ask(request="open", what="scenario:soar_skirmish")
    page.until_message("hello")
    watchers = [Watcher(server, place, seconds + 2) for _ in range(count)]
    for watcher in watchers:
        watcher.start()
    time.sleep(2)
    begin, before_s = time.monotonic(), cpu_s(server.process.pid)
    time.sleep(seconds)
    share = (cpu_s(server.process.pid) - before_s) / (time.monotonic() - begin)
    for watcher in watchers:
        watcher.join()
    page.close()
    faults = [watcher.fault for watcher in watchers if watcher.fault]
    blocks = statistics.mean(watcher.blocks for watcher in watchers) / (seconds + 2)
    print(f"streams: {count} with {blocks:.1f} blocks per second each took {share:.3f} of a core of the server, faults {len(faults)} {faults[:3]}")
    if share > 0:
        print(f"one core carries {count / share:.0f} browsers' streams of soar_skirmish, by this share")


@contextlib.contextmanager
def served(*options):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        server = Server(pathlib.Path(folder), *options)
        yield server
        server.kill()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--learners", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--streams", type=int, default=100)
    parser.add_argument("--stream-seconds", type=float, default=20)
    options = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
    if options.learners:
        with served("--sessions", str(options.learners)) as server:
            measure_learners(server, options.learners, options.seconds)
    if options.streams:
        with served() as server:
            measure_streams(server, options.streams, options.stream_seconds)


def measure_learners(server, count, seconds):
    # From several addresses, because one address may not have all runs of a server.
    learners = [Learner(server, NAMES[i % len(NAMES)], seconds, f"127.0.0.{2 + i % 4}") for i in range(count)]
    for learner in learners:
        learner.start()
        time.sleep(0.05)
    time.sleep(seconds * 0.3)
    asker = Asker(server)
    asker.start()
    told = what_the_next_is_told(server)
    time.sleep(seconds * 0.6)
    engines = server.engines()
    runs_mb, server_mb = [memory_mb(pid) for pid in engines], memory_mb(server.process.pid)
    cores = (sum(map(cpu_s, engines)), cpu_s(server.process.pid))
    asker.is_over.set()
    for thread in [asker, *learners]:
        thread.join()
    faults = [learner.fault for learner in learners if learner.fault]
    print(f"learners {count}, seconds {seconds:g}, runs {len(engines)}, faults {len(faults)} {faults[:3]}")
    lateness = [late for learner in learners for late in learner.lateness]
    if lateness:
        print(describe("lateness of ticks", lateness))
        print(f"bytes per second and learner: {statistics.mean(learner.bytes for learner in learners) / seconds:.0f}")
    if asker.waits_s:
        print(describe("requests of another page wait", asker.waits_s) + f" ({len(asker.waits_s)} requests, statuses {sorted(asker.statuses)})")
    print(f"learner {count + 1} is told: {told}")
    if runs_mb:
        print(f"memory per run: {statistics.mean(runs_mb):.1f} MB, most {max(runs_mb):.1f}; server {server_mb:.1f} MB")
    print(f"processor: runs {cores[0]:.1f} s, server {cores[1]:.1f} s of {seconds * 0.9:.0f} s")


if __name__ == "__main__":
    main()
