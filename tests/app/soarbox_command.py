# SPDX-License-Identifier: BSD-2-Clause
"""Runs the real soarbox command and reads its output."""
import json
import os
import pathlib
import resource
import socket
import subprocess
import tempfile
import time
import unittest

COMMAND = os.environ["SOARBOX"]
THESIS = pathlib.Path(__file__).resolve().parent.parent / "thesis"

# The script of an agent that walks along the x axis.
WALKER = """
function Agent_Initialize(agent)
    agent:SetTarget(Vector.new(50, 0, 0));
end
function Agent_Update(agent, deltaTimeInMillis, command)
    agent:ApplyForce(agent:ForceToPosition(agent:GetTarget()) * 50);
end
"""

PAGE = pathlib.Path(__file__).resolve().parents[2] / "web" / "dist" / "page" / "report_scene.js"


def page_missing():
    """The reason why reports cannot be tested here; empty: they can. Continuous integration builds the page first."""
    return "" if PAGE.exists() or os.environ.get("CI") == "true" else "the page of reports is not built: ./dev test builds it"


def limit_memory(process_id, memory_bytes):
    resource.prlimit(process_id, resource.RLIMIT_AS, (memory_bytes, memory_bytes))


class Run:
    """One finished run of the command. `code`: its required exit code, if any; `memory_bytes`: its memory limit."""

    def __init__(self, *arguments, code=None, display=False, limit_s=240, cwd=None, memory_bytes=None, variables=None):
        environment = {**os.environ, **(variables or {})}
        if not display:
            environment.pop("DISPLAY", None)
        done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=limit_s,
                              env=environment, cwd=cwd, check=False,
                              preexec_fn=memory_bytes and (lambda: limit_memory(0, memory_bytes)))
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr
        if code not in (None, self.code):
            raise AssertionError(f"{arguments} ended with {self.code}, not with {code}:\n{self.out[-5000:]}{self.err}")
        self.events = [json.loads(line) for line in self.out.splitlines() if line.startswith("{")]

    def of(self, kind, **fields):
        """The events of a kind with these values of fields."""
        return [event for event in self.events
                if event["event"] == kind and all(event.get(key) == value for key, value in fields.items())]

    def diagnostics(self):
        return [event["diagnostic"] for event in self.events if "diagnostic" in event]


def new_folder(case):
    """A folder that is removed after the test, or after the class of tests."""
    folder = tempfile.TemporaryDirectory()
    (case.addClassCleanup if isinstance(case, type) else case.addCleanup)(folder.cleanup)
    return pathlib.Path(folder.name).resolve()


def end_with(case, process):
    """Ends the process after the test."""
    case.addCleanup(process.wait)
    case.addCleanup(process.kill)
    return process


def wait_until(holds, what="the fact", limit_s=120):
    """Waits until `holds` returns a true value, and returns it. Fails after `limit_s`."""
    end = time.monotonic() + limit_s
    while not (found := holds()):
        if time.monotonic() > end:
            raise AssertionError(f"{what} did not come in {limit_s} s")
        time.sleep(0.02)
    return found


def free_port():
    """A TCP port of this machine on which no program listens."""
    with socket.socket() as there:
        there.bind(("127.0.0.1", 0))
        return there.getsockname()[1]


def start_kernel():
    """A kernel in a separate process, and its port."""
    port = free_port()
    kernel = subprocess.Popen([COMMAND, "kernel", "--port", str(port)], stdout=subprocess.PIPE, text=True)
    assert "listens" in kernel.stdout.readline()
    return kernel, port


def end(process):
    process.kill()
    process.wait()
    process.stdout.close()


def run_json(scenario, *arguments, **options):
    return Run("run", scenario, "--headless", "--json", *arguments, **options)


class ScenarioCase(unittest.TestCase):
    """Test case that writes a scenario into a temporary folder."""

    def setUp(self):
        self.folder = new_folder(self)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path
