# SPDX-License-Identifier: BSD-2-Clause
"""Minds in another process, debuggers at a running world, and hostile clients, all through the real command."""
import json
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from protocol_client import Client, Refused, debugger_attach, debugger_start, frame
from soarbox_command import COMMAND, free_port, run_json
from test_soar_typos import TOWER


# Makes one small decision and gives one command with a parameter for each new reading. Finished commands are removed.
SEEKER_RULES = """
sp {propose*advance (state <s> ^superstate nil ^io.input-link.range { <r> >= 12.0 })
   --> (<s> ^operator <o> + =) (<o> ^name advance ^speed <r>)}
sp {propose*hold (state <s> ^superstate nil ^io.input-link.range { <r> < 12.0 >= 4.0 })
   --> (<s> ^operator <o> + =) (<o> ^name hold ^speed 0.0)}
sp {propose*retreat (state <s> ^superstate nil ^io.input-link.range { <r> < 4.0 })
   --> (<s> ^operator <o> + =) (<o> ^name retreat ^speed (- 4.0 <r>))}
sp {apply*send (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name { <name> << advance hold retreat >> } ^speed <v>) --> (<out> ^<name> <cmd>) (<cmd> ^speed <v>)}
sp {apply*drop (state <s> ^operator.name ^io.output-link <out>) (<out> ^<name> <cmd>) (<cmd> ^status complete)
   --> (<out> ^<name> <cmd> -)}
"""


class Process:
    """A running soarbox command. Its output is read line by line."""

    def __init__(self, *arguments, environment=None):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"} | (environment or {})
        self.process = subprocess.Popen([COMMAND, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, env=environment)
        self.lines = []
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            self.lines.append(line)

    def wait_for(self, wanted, limit_s=60.0):
        """Waits for the first line that the predicate accepts, and returns it."""
        until = time.monotonic() + limit_s
        seen = 0
        while time.monotonic() < until:
            while seen < len(self.lines):
                if wanted(self.lines[seen]):
                    return self.lines[seen]
                seen += 1
            if self.process.poll() is not None and not self.reader.is_alive() and seen == len(self.lines):
                break
            time.sleep(0.02)
        raise AssertionError("the line did not come; last lines: " + "".join(self.lines[-5:]))

    def events(self, kind):
        found = [json.loads(line) for line in list(self.lines) if line.startswith("{")]
        return [event for event in found if event["event"] == kind]

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)
        return self.finish()

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
        self.finish()

    def finish(self, limit_s=60.0):
        code = self.process.wait(limit_s)
        self.reader.join(limit_s)
        self.process.stdout.close()
        self.process.stderr.close()
        return code


def is_event(kind):
    return lambda line: line.startswith("{") and json.loads(line)["event"] == kind


class Case(unittest.TestCase):
    def start(self, *arguments, environment=None):
        process = Process(*arguments, environment=environment)
        self.addCleanup(process.kill)
        return process

    def start_kernel(self, port):
        kernel = self.start("kernel", "--port", port)
        kernel.wait_for(lambda line: f"listens on 127.0.0.1:{port}" in line)
        return kernel


class Secret(Case):
    """A kernel that requires a secret of its clients."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "secret"
        self.file.write_text("open sesame\nnot this line\n", encoding="utf-8")
        self.port = free_port()
        kernel = self.start("kernel", "--port", self.port, "--secret-file", self.file)
        kernel.wait_for(lambda line: f"listens on 127.0.0.1:{self.port}, for clients that show its secret" in line)

    def run_there(self, **environment):
        return subprocess.run([COMMAND, "run", "thesis", "--headless", "--seconds", "1", "--kernel", f"127.0.0.1:{self.port}"],
                              capture_output=True, text=True, timeout=120, check=False, env=os.environ | environment)

    def test_a_client_with_the_secret_is_served(self):
        with Client(self.port) as client:
            client.call("soarbox_secret", secret="open sesame")
            self.assertEqual(debugger_start(client), [])

    def test_a_client_without_it_is_told_and_nothing_is_carried_out(self):
        for first in (("version", {}), ("create_agent", {"name": "spy"}), ("soarbox_secret", {"secret": "open"}),
                      ("soarbox_secret", {"secret": ""}), ("soarbox_secret", {})):
            with self.subTest(first=first), Client(self.port) as client:
                wanted = "does not accept this secret" if "secret" in first[1] else "requires a secret"
                with self.assertRaisesRegex(Refused, wanted):
                    client.call(first[0], **first[1])
                with self.assertRaises(OSError):
                    for _ in range(100):
                        client.call("version")
        with Client(self.port) as client:
            client.call("soarbox_secret", secret="open sesame")
            self.assertEqual(client.agents(), [])

    def test_silent_clients_keep_nobody_out(self):
        silent = [socket.create_connection(("127.0.0.1", self.port)) for _ in range(200)]
        with Client(self.port) as client:
            client.call("soarbox_secret", secret="open sesame")
            self.assertEqual(client.agents(), [])
        for each in silent:
            each.close()

    def test_our_clients_take_it_from_the_environment(self):
        run = self.run_there(SOARBOX_KERNEL_SECRET="open sesame")
        self.assertEqual(run.returncode, 0, run.stderr)
        run = self.run_there(SOARBOX_KERNEL_SECRET_FILE=str(self.file))
        self.assertEqual(run.returncode, 0, run.stderr)
        run = self.run_there()
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("This kernel requires a secret", run.stderr)
        run = self.run_there(SOARBOX_KERNEL_SECRET="wrong")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("does not accept this secret", run.stderr)

    def test_a_secret_shown_to_a_kernel_that_requires_none_does_no_harm(self):
        self.port = free_port()
        self.start_kernel(self.port)
        run = self.run_there(SOARBOX_KERNEL_SECRET="open sesame")
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_file_without_a_secret_starts_no_kernel(self):
        self.file.write_text("\n", encoding="utf-8")
        for file in (self.file, self.file.parent / "missing"):
            done = subprocess.run([COMMAND, "kernel", "--port", "0", "--secret-file", str(file)], capture_output=True, text=True,
                                  timeout=60, check=False)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn(str(file), done.stderr)


class RemoteMinds(Case):
    def test_a_run_over_a_socket_equals_the_run_in_process_and_leaves_the_kernel_empty(self):
        port = free_port()
        self.start_kernel(port)
        arguments = ("--seconds", 20, "--every-command", "--seed", 7)
        near = run_json("thesis", *arguments)
        far = run_json("thesis", *arguments, "--kernel", f"127.0.0.1:{port}")
        self.assertEqual((near.code, far.code), (0, 0), far.err)
        self.assertGreater(len(near.of("command")), 1000)
        self.assertEqual(near.of("command"), far.of("command"))
        self.assertEqual(near.of("end"), far.of("end"))
        with Client(port) as client:
            self.assertEqual(client.agents(), [])

    def test_rules_that_multiply_are_told_of_wherever_the_kernel_is(self):
        port = free_port()
        self.start_kernel(port)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "tower.soar").write_text(TOWER, encoding="utf-8")
            (folder / "scenario.toml").write_text('[[agent]]\nrules = "tower.soar"\n' * 2, encoding="utf-8")
            run = run_json(folder, "--seconds", 1, "--kernel", f"127.0.0.1:{port}")
        self.assertEqual(run.code, 0, run.err)
        told = [event["diagnostic"] for event in run.of("diagnostic")]
        told = [warning["line"] for warning in told if "tests ^holds 6 times" in warning["message"]]
        self.assertEqual(told, [2], run.out)

    def test_a_host_loop_gives_the_same_commands_over_a_socket_as_in_process(self):
        port = free_port()
        self.start_kernel(port)
        with tempfile.TemporaryDirectory() as folder:
            rules = pathlib.Path(folder) / "seeker.soar"
            rules.write_text(SEEKER_RULES, encoding="utf-8")

            def loop(*arguments):
                done = subprocess.run([os.environ["SOARBOX_HOST_LOOP"], rules, "3", "40", *map(str, arguments)],
                                      capture_output=True, text=True, timeout=120, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                return done.stdout.splitlines()

            near, far = loop(), loop("127.0.0.1", port)
        self.assertEqual(len(near), 3 * 40)
        self.assertTrue({"advance", "hold", "retreat"} <= {line.split()[2] for line in near})
        self.assertEqual(near, far)

    def test_minds_that_lose_their_kernel_stand_still_and_come_back_with_the_next_one(self):
        port = free_port()
        kernel = self.start_kernel(port)
        run = self.start("run", "thesis", "--headless", "--json", "--every-command", "--seconds", 60, "--speed", 4,
                         "--report", 0.5, "--kernel", f"127.0.0.1:{port}")
        run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > 3)
        kernel.kill()
        lost = json.loads(run.wait_for(is_event("lost")))
        self.assertIn(f"127.0.0.1:{port}", lost["text"])
        run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > lost["time"] + 4)
        self.start_kernel(port)
        back = json.loads(run.wait_for(is_event("back")))
        run.wait_for(lambda line: is_event("command")(line) and json.loads(line)["time"] > back["time"])
        run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > back["time"] + 4)
        self.assertEqual(run.interrupt(), 0)

        commands = [event["time"] for event in run.events("command")]
        self.assertFalse([at for at in commands if lost["time"] < at < back["time"]])
        states = [event for event in run.events("state")]
        while_lost = [state for state in states if lost["time"] + 1 < state["time"] < back["time"]]
        after = [state for state in states if state["time"] > back["time"] + 3]

        def moved(first, last, soar):
            """The distance that each agent with this kind of mind moved between two reports."""
            there = {agent["name"]: agent["position"] for agent in last["agents"]}
            return [sum((a - b) ** 2 for a, b in zip(agent["position"], there[agent["name"]])) ** 0.5
                    for agent in first["agents"] if ("soar" in agent["kind"]) == soar]

        self.assertLess(sorted(moved(while_lost[0], while_lost[-1], True))[-2], 0.2, "all stand but who is pushed")
        self.assertGreater(max(moved(while_lost[0], while_lost[-1], False)), 0.2, "the world goes on")
        self.assertGreater(max(moved(while_lost[-1], after[-1], True)), 1, "the minds act again")

    def test_the_next_kernel_keeps_the_limits_of_a_strangers_rules_too(self):
        with tempfile.TemporaryDirectory() as place:
            folder, outside = pathlib.Path(place) / "scenario", pathlib.Path(place) / "outside"
            folder.mkdir()
            (folder / "hero.soar").write_text(f"output command-to-file {outside} echo hello\n{SEEKER_RULES}",
                                              encoding="utf-8")
            (folder / "scenario.toml").write_text('[[agent]]\nname = "hero"\nrules = "hero.soar"\n', encoding="utf-8")
            port = free_port()
            kernel = self.start_kernel(port)
            run = self.start("run", folder, "--headless", "--json", "--seconds", 60, "--speed", 4, "--report", 0.5,
                             "--kernel", f"127.0.0.1:{port}")
            run.wait_for(is_event("state"))
            kernel.kill()
            run.wait_for(is_event("lost"))
            self.start_kernel(port)
            back = json.loads(run.wait_for(is_event("back")))
            run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > back["time"] + 1)
            run.interrupt()
            self.assertFalse(outside.exists())

    def test_a_kernel_that_hangs_is_given_up_and_the_world_goes_on(self):
        port = free_port()
        kernel = self.start_kernel(port)
        run = self.start("run", "thesis", "--headless", "--json", "--every-command", "--seconds", 600, "--speed", 2,
                         "--report", 0.5, "--kernel", f"127.0.0.1:{port}", "--kernel-limit", 0.5)
        run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > 3)
        kernel.process.send_signal(signal.SIGSTOP)
        # The kernel is stopped meanwhile. The world waits for it no longer than the limit.
        lost = json.loads(run.wait_for(is_event("lost")))
        run.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > lost["time"] + 6)
        kernel.process.send_signal(signal.SIGCONT)
        back = json.loads(run.wait_for(is_event("back")))
        run.wait_for(lambda line: is_event("command")(line) and json.loads(line)["time"] > back["time"])
        commands = [event["time"] for event in run.events("command")]
        self.assertFalse([at for at in commands if lost["time"] < at < back["time"]])
        self.assertEqual(run.interrupt(), 0)

    def test_names_that_another_run_uses_in_that_kernel_are_told(self):
        port = free_port()
        self.start_kernel(port)
        first = self.start("run", "thesis", "--headless", "--json", "--speed", 1, "--kernel", f"127.0.0.1:{port}")
        first.wait_for(is_event("command"))
        second = run_json("thesis", "--seconds", 1, "--kernel", f"127.0.0.1:{port}", code=1)
        self.assertIn("already has an agent named", second.out)
        self.assertEqual(first.interrupt(), 0)


class Pieces(Case):
    def test_a_client_that_sends_lengths_by_themselves_waits_for_no_delayed_acknowledgement(self):
        port = free_port()
        self.start_kernel(port)
        call = frame('<sml doctype="call" id="1" smlversion="9.6.3"><command name="version"></command></sml>')
        with socket.create_connection(("127.0.0.1", port), timeout=100) as client:
            took = []
            for _ in range(100):
                begun = time.monotonic()
                client.sendall(call[:4])
                client.sendall(call[4:])
                self.assertIn(b"9.6.3", client.recv(4096))
                took.append(time.monotonic() - begun)
            # A delayed acknowledgement would come after 40 ms in each call, on any machine.
            self.assertLess(min(took), 0.035)


class Trace(Case):
    def test_trace_that_a_client_does_not_take_is_dropped_and_counted(self):
        port = free_port()
        self.start_kernel(port)
        with Client(port) as watcher, Client(port) as user:
            user.call("create_agent", name="hal")
            user.line("hal", "sp {begin (state <s> ^superstate nil -^count) --> (<s> ^operator <o> +) (<o> ^name begin)}")
            user.line("hal", "sp {begun (state <s> ^operator.name begin) --> (<s> ^count 0)}")
            user.line("hal", "sp {propose (state <s> ^superstate nil ^count <c>) --> (<s> ^operator <o> +) (<o> ^name say)}")
            user.line("hal", "sp {say (state <s> ^operator.name say ^count <c>) --> (<s> ^count <c> - (+ <c> 1)) (write |%s|)}"
                      % ("x" * 20_000))
            watcher.register("print", agent="hal")
            user.line("hal", "run -d 1500")
            watcher.listen(3)
            taken = len(watcher.heard("print"))
            user.line("hal", "run -d 1")
            watcher.listen(1)
            told = [text for document in watcher.heard("print") for text in document.itertext() if "were dropped here" in text]
            self.assertEqual(len(told), 1)
            dropped = int(told[0].split("--- ")[1].split()[0])
            self.assertAlmostEqual(taken + dropped, 1500, delta=3)


class Watched(Case):
    """A world that runs in real time and accepts debuggers."""

    def setUp(self):
        self.port = free_port()
        self.world = self.start("run", "thesis", "--headless", "--json", "--seconds", 600, "--speed", 1, "--report", 0.25,
                                "--port", self.port)
        self.world.wait_for(is_event("state"))

    def world_time(self):
        return self.world.events("state")[-1]["time"]

    def check_goes_on(self, seconds=2.0):
        """Checks that the world continues during the attack."""
        until = self.world_time() + seconds
        self.world.wait_for(lambda line: '"state"' in line and json.loads(line)["time"] > until, 120)

    def check_served(self):
        with Client(self.port) as client:
            self.assertEqual(client.text("version"), "9.6.3")
            self.assertEqual(len(client.agents()), 5)

    def step(self, client, agent):
        """Runs one decision. While the world runs the agent, the command is refused, as in Soar; then it is sent again."""
        for _ in range(50):
            try:
                return client.line(agent, "run -d 1 --self")
            except Refused as refused:
                self.assertIn("already running", str(refused))
                client.listen(0.01)
        return "never"

    def test_a_debugger_attaches_traces_stops_steps_reads_and_leaves(self):
        with Client(self.port) as client:
            agents = debugger_start(client)
            self.assertEqual(len(agents), 5)
            agent = agents[0]
            debugger_attach(client, agent)
            client.line(agent, "watch 1")
            client.line(agent, "sp {watched*note (state <s> ^superstate nil ^io.input-link.distance) --> (<s> ^noted yes)}")
            self.assertEqual(client.text("is_production_loaded", agent=agent, name="watched*note"), "true")
            client.listen(1.5)
            self.assertTrue(client.heard("print"))
            self.assertTrue(client.heard("after-decision-cycle"))
            traces = [document.find("trace") for document in client.heard("xml-trace-output")]
            self.assertTrue([trace for trace in traces if trace is not None and trace.findall("*")])
            self.assertRegex(client.line(agent, "print s1"), r"\^noted yes")
            self.assertIn("distance", client.line(agent, "print --depth 2 i2"))
            response = client.call("cmdline", agent=agent, line="print s1")
            self.assertTrue([wme for wme in response.iter("wme") if wme.get("attr") == "noted"])

            client.line(agent, "production break --set watched*note")
            self.assertIn("watched*note", client.line(agent, "production break"))
            client.line(agent, "production break --clear watched*note")
            client.line(agent, "stop-soar")
            before = int(client.text("get_run_state", agent=agent, value="decision"))
            self.assertRegex(self.step(client, agent), r"decision cycle")
            self.assertGreater(int(client.text("get_run_state", agent=agent, value="decision")), before)
            with self.assertRaises(Refused):
                client.line(agent, "no-such-command")
            self.assertTrue(client.line(agent, "print --stack"))
            self.assertTrue(client.line(agent, "stats"))
        self.check_goes_on()
        self.check_served()
        self.assertEqual(self.world.interrupt(), 0)

    def test_what_could_not_be_noted_as_an_input_of_the_run_is_refused(self):
        with Client(self.port) as client:
            agent = client.agents()[0]
            calls = {
                "create_agent": {"name": "stowaway"},
                "destroy_agent": {"agent": agent},
                "input": {"agent": agent},
                "shutdown": {},
                "fire_event": {"eventid": "system-stop"},
                "register_for_event": {"eventid": "rhs-user-function", "name": "guess"},
            }
            for call, arguments in calls.items():
                with self.subTest(call), self.assertRaisesRegex(Refused, "live in a simulation"):
                    client.call(call, **arguments)
            client.line(agent, "wm add s1 told yes")
            self.assertIn("^told yes", client.line(agent, "print s1"))
        self.check_goes_on()
        self.check_served()

    def test_hostile_documents_hurt_nobody_else(self):
        call = '<sml doctype="call" id="1" smlversion="9.6.3"><command name="version"></command></sml>'
        deep = "<a>" * 100_000 + "</a>" * 100_000
        hostile = {
            "truncated frame": struct_length(5000) + b"<sml doctype",
            "oversized length": b"\xff\xff\xff\xff" + call.encode(),
            "100,000 levels": frame(deep),
            "malformed": frame("<sml doctype='call'><command></sml>"),
            "garbage": bytes(range(256)) * 64,
            "numeric reference": frame(call.replace("version\"></", "version\">&#65;</")),
            "endless reference": frame("<sml>&#" + "9" * 100_000),
            "call without id": frame(call.replace(' id="1"', "")),
            "call without doctype": frame(call.replace(' doctype="call"', "")),
            "run state of nobody": frame(call.replace("version", "get_run_state")),
            "empty message": frame(""),
            "doctype": frame('<!DOCTYPE a [<!ENTITY b "bb"><!ENTITY c "&b;&b;">]><sml>&c;</sml>'),
            "left in the middle": frame(call)[:-20],
        }
        for name, data in hostile.items():
            with self.subTest(name):
                with socket.create_connection(("127.0.0.1", self.port), timeout=100) as bad:
                    bad.sendall(data)
                    time.sleep(0.1)
                    self.check_served()
                self.check_served()
        self.check_goes_on()

    def test_a_client_that_traces_and_never_reads_does_not_slow_the_world(self):
        with Client(self.port) as silent:
            for agent in silent.agents():
                silent.register("print", agent=agent)
                silent.register("xml-trace-output", agent=agent)
                silent.line(agent, "watch 5")
            self.check_goes_on(4.0)
            self.check_served()
        self.check_goes_on()

    def test_a_hundred_clients_at_once_are_served(self):
        clients = [Client(self.port) for _ in range(100)]
        try:
            for client in clients:
                self.assertEqual(client.text("version"), "9.6.3")
            self.check_goes_on()
            for client in clients:
                self.assertEqual(len(client.agents()), 5)
        finally:
            for client in clients:
                client.close()
        self.check_served()


def struct_length(length):
    return length.to_bytes(4, "big")
