# SPDX-License-Identifier: BSD-2-Clause
"""Plays many learners at once against a server, and measures what it costs (not a test: bench/README.md says how to run it).

usage: load.py [--learners N] [--seconds S] [--watchers N]

Each learner opens a lesson, looks at the panels that a page shows, types into the editor now and then, applies the solution half way, asks
why, and hints. Printed: how late the world's time is after the first quarter, in which all worlds begin (95 % of all ticks are no later), bytes
per second and learner, memory per run, and processor time.
"""
import argparse
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
    """What a process has for itself, shared pages counted by their share."""
    with open(f"/proc/{pid}/smaps_rollup", encoding="utf-8") as rollup:
        return sum(int(line.split()[1]) for line in rollup if line.startswith("Pss:")) / 1024


def cpu_s(pid):
    with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Learner(threading.Thread):
    def __init__(self, server, lesson, seconds):
        super().__init__(daemon=True)
        self.server, self.lesson, self.seconds = server, lesson, seconds
        self.lateness, self.bytes, self.fault = [], 0, None

    def run(self):
        try:
            self.learn()
        except (Gone, OSError, KeyError, IndexError) as fault:
            self.fault = repr(fault)

    def learn(self):
        page = WebSocket(self.server, f"/api/p/{self.server.new_place()}/run")
        page.ask(request="open", what="lesson:" + self.lesson)
        page.ask(request="look", panels=["agents", "mission", "edit", "mind", "why", "problems"])
        page.until_message("hello")
        edit = page.until_contents("edit", lambda edit: edit["files"])
        page.ask(request="edit", file=edit["files"][0]["file"])
        solution = "\n".join(file.read_text(encoding="utf-8") for file in (LESSONS / self.lesson / "solution").glob("*.soar"))
        begin, typed, applied, first = time.monotonic(), 0, False, None
        while time.monotonic() - begin < self.seconds:
            message = page.receive()
            now = time.monotonic() - begin
            if message["message"] == "flow" and not message["paused"]:
                # Against the best moment: that is when the page saw the world on time.
                behind = now - message["time_s"]
                # Once all have begun, which takes the processors a while; time that a world lost then it does not catch up with.
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--learners", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--watchers", type=int, default=0)
    options = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        server = Server(pathlib.Path(folder))
        learners = [Learner(server, NAMES[i % len(NAMES)], options.seconds) for i in range(options.learners)]
        for learner in learners:
            learner.start()
            time.sleep(0.05)
        watchers = []
        if options.watchers:
            place = server.new_place()
            page = WebSocket(server, f"/api/p/{place}/run")
            page.ask(request="open", what="scenario:soar_skirmish")
            page.until_message("hello")
            watchers = [Watcher(server, place, options.seconds) for _ in range(options.watchers)]
            for watcher in watchers:
                watcher.start()
        time.sleep(options.seconds * 0.9)
        engines = server.engines()
        runs_mb, server_mb = [memory_mb(pid) for pid in engines], memory_mb(server.process.pid)
        cores = (sum(map(cpu_s, engines)), cpu_s(server.process.pid))
        for thread in learners + watchers:
            thread.join()
        faults = [thread.fault for thread in learners + watchers if thread.fault]
        lateness = sorted(late for learner in learners for late in learner.lateness)
        if lateness:
            print(f"learners {options.learners}, seconds {options.seconds:g}, faults {len(faults)} {faults[:3]}")
            print(f"lateness of ticks: median {statistics.median(lateness) * 1000:.0f} ms, "
                  f"95 % {lateness[int(len(lateness) * 0.95)] * 1000:.0f} ms, most {lateness[-1] * 1000:.0f} ms")
            print(f"bytes per second and learner: {statistics.mean(learner.bytes for learner in learners) / options.seconds:.0f}")
        if runs_mb:
            print(f"memory per run: {statistics.mean(runs_mb):.1f} MB, most {max(runs_mb):.1f}; server {server_mb:.1f} MB")
        print(f"processor: runs {cores[0]:.1f} s, server {cores[1]:.1f} s of {options.seconds * 0.9:.0f} s")
        if watchers:
            print(f"watchers {len(watchers)}: {statistics.mean(watcher.blocks for watcher in watchers) / options.seconds:.1f} blocks per second each")
        server.kill()


if __name__ == "__main__":
    main()
