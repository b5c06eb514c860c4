# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox dap` as an editor's debugger uses it."""
import json
import pathlib
import re
import subprocess
import unittest

from editor_client import COMMAND, Channel
from soarbox_command import Run, end_with, new_folder

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent

# It goes from 1 to 3, with one operator for each step.
COUNTER = """sp {propose*initialize
   (state <s> ^superstate nil -^count)
-->
   (<s> ^operator.name initialize)
}

sp {apply*initialize
   (state <s> ^operator.name initialize)
-->
   (<s> ^count 1)
}

sp {propose*add
   (state <s> ^count {<c> < 3})
-->
   (<s> ^operator <o> +)
   (<o> ^name add)
}

sp {apply*add
   (state <s> ^operator.name add ^count <c>)
-->
   (<s> ^count <c> - (+ <c> 1))
}

sp {done
   (state <s> ^count 3)
-->
   (halt)
}
"""


class Debugger(unittest.TestCase):
    def setUp(self):
        self.rules = new_folder(self) / "counter.soar"
        self.rules.write_text(COUNTER)
        self.channel = Channel("dap")
        self.addCleanup(self.channel.close)
        self.number = 0
        self.events = []
        self.assertTrue(self.ask("initialize", adapterID="soarbox")["supportsStepBack"])
        self.wait_for("initialized")

    def receive(self):
        message = self.channel.receive(120)
        self.assertIsNotNone(message, "the debugger is silent")
        return message

    def answer(self, command, **arguments):
        self.number += 1
        self.channel.send({"seq": self.number, "type": "request", "command": command, "arguments": arguments})
        while (message := self.receive())["type"] != "response":
            self.events.append(message)
        self.assertEqual((self.number, command), (message["request_seq"], message["command"]))
        return message

    def ask(self, command, **arguments):
        answer = self.answer(command, **arguments)
        self.assertTrue(answer["success"], answer.get("message"))
        return answer["body"]

    def wait_for(self, name):
        while not any(event["event"] == name for event in self.events):
            self.events.append(self.receive())
        found = next(event for event in self.events if event["event"] == name)
        self.events.remove(found)
        return found.get("body")

    def begin(self, **arguments):
        self.ask("launch", **arguments)
        self.ask("configurationDone")
        self.assertEqual("entry", self.wait_for("stopped")["reason"])

    def step(self, command, **arguments):
        self.ask(command, threadId=1, **arguments)
        return self.wait_for("stopped")

    def frames(self):
        return self.ask("stackTrace", threadId=1)["stackFrames"]

    def variables(self, scope):
        scopes = self.ask("scopes", frameId=self.frames()[-1]["id"])["scopes"]
        reference = next(one["variablesReference"] for one in scopes if one["name"].startswith(scope))
        return {one["name"]: one for one in self.ask("variables", variablesReference=reference)["variables"]}

    def test_rules_alone_go_by_phases_and_decisions(self):
        self.begin(program=str(self.rules), world=False)
        self.assertEqual(["counter"], [one["name"] for one in self.ask("threads")["threads"]])
        seen = [self.step("stepIn", granularity="instruction")["description"] for _ in range(5)]
        self.assertEqual(["before propose", "before decide", "before apply", "before output", "before input"],
                         [one.split(", ")[1] for one in seen])
        self.assertEqual("1", self.variables("State")["^count"]["value"])
        self.step("stepIn")
        self.assertEqual("S1: add", self.frames()[0]["name"])
        self.assertIn("^name", self.variables("Operator"))

    def test_a_breakpoint_in_a_rules_line_stops_there_and_its_place_is_shown(self):
        self.ask("launch", program=str(self.rules), world=False)
        marks = self.ask("setBreakpoints", source={"path": str(self.rules)}, breakpoints=[{"line": 23}, {"line": 6}])["breakpoints"]
        self.assertEqual([True, False], [one["verified"] for one in marks])
        self.assertEqual(20, marks[0]["line"])
        self.ask("configurationDone")
        self.wait_for("stopped")
        self.ask("continue", threadId=1)
        stopped = self.wait_for("stopped")
        self.assertEqual("breakpoint", stopped["reason"])
        self.assertIn("apply*add fired", stopped["text"])
        self.assertEqual((str(self.rules), 20), (self.frames()[0]["source"]["path"], self.frames()[0]["line"]))
        self.assertEqual("2", self.variables("State")["^count"]["value"])

    def mark(self, *marks):
        return self.ask("setBreakpoints", source={"path": str(self.rules)}, breakpoints=list(marks))["breakpoints"]

    def test_a_breakpoint_stops_only_if_its_condition_holds(self):
        self.begin(program=str(self.rules), world=False)
        self.assertTrue(self.mark({"line": 20, "condition": "count = 2"})[0]["verified"])
        self.assertIn("apply*add fired", self.step("continue")["text"])
        self.assertEqual("2", self.variables("State")["^count"]["value"])
        self.ask("restart")
        self.wait_for("stopped")
        self.mark({"line": 20, "condition": "count > 5"})
        self.assertEqual("the run is over", self.step("continue")["text"])
        self.assertFalse(self.mark({"line": 20, "condition": "prnt s1 > 5"})[0]["verified"])

    def test_a_condition_holds_in_a_world_as_well(self):
        (self.rules.parent / "scenario.toml").write_text('[[agent]]\nname = "walker"\nbody = "runner"\nrules = "counter.soar"\n')
        self.begin(program=str(self.rules.parent), seconds=5)
        self.mark({"line": 20, "condition": "count > 1"})
        self.assertIn("walker: rule apply*add fired", self.step("continue")["text"])
        self.mark({"line": 20, "condition": "count > 5"})
        self.ask("restart")
        self.wait_for("stopped")
        self.assertEqual("the run is over", self.step("continue")["text"])

    def test_a_log_point_prints_values_and_does_not_stop(self):
        self.begin(program=str(self.rules), world=False)
        self.mark({"line": 20, "logMessage": "counted to {count}{no.such.thing}."})
        self.assertEqual("the run is over", self.step("continue")["text"])
        printed = [event["body"] for event in self.events if event["event"] == "output" and event["body"].get("line")]
        self.assertEqual(["counted to 2.\n", "counted to 3.\n"], [one["output"] for one in printed])
        self.assertEqual((str(self.rules), 20), (printed[0]["source"]["path"], printed[0]["line"]))

    def test_operators_elements_and_the_end_stop_it(self):
        self.begin(program=str(self.rules), world=False)
        marks = self.ask("setFunctionBreakpoints", breakpoints=[{"name": "operator add"}, {"name": "element ^count 3"}, {"name": "nonsense"}])
        self.assertEqual([True, True, False], [one["verified"] for one in marks["breakpoints"]])
        texts = []
        for _ in range(3):
            self.ask("continue", threadId=1)
            texts.append(self.wait_for("stopped")["text"])
        self.assertIn("operator add", texts[0])
        self.assertTrue(any("^count 3" in one for one in texts), texts)
        self.ask("continue", threadId=1)
        self.assertEqual("the run is over", self.wait_for("stopped")["text"])

    def test_the_console_takes_soars_commands_and_why(self):
        self.begin(program=str(self.rules), world=False)
        self.step("stepIn")
        self.step("stepIn")
        frame = self.frames()[0]["id"]
        self.assertIn("^count", self.ask("evaluate", expression="print s1", context="repl", frameId=frame)["result"])
        why = self.ask("evaluate", expression="why add", context="watch", frameId=frame)
        tree = self.ask("variables", variablesReference=why["variablesReference"])["variables"]
        self.assertIn("propose*add", json.dumps(tree))
        self.assertEqual("1", self.ask("evaluate", expression="^count", context="hover", frameId=frame)["result"])
        self.assertFalse(self.answer("evaluate", expression="no-such-command", context="repl", frameId=frame)["success"])
        self.assertIn("print", [one["label"] for one in self.ask("completions", text="pri", column=4, frameId=frame)["targets"]])

    def test_a_world_goes_by_ticks_and_back_to_the_same(self):
        self.begin(program="soar_seek", seconds=5)
        first = self.step("next")["description"]
        self.assertIn("tick 1,", first)
        states = []
        for _ in range(20):
            self.step("next")
            percepts = self.variables("Percepts")
            states.append((percepts["^time"]["value"], self.ask("evaluate", expression="io.input-link.self.position.x", context="watch")["result"]))
        for _ in range(5):
            self.step("stepBack")
        percepts = self.variables("Percepts")
        self.assertEqual(states[-6], (percepts["^time"]["value"], self.ask("evaluate", expression="io.input-link.self.position.x", context="watch")["result"]))
        self.step("reverseContinue")
        self.assertFalse(self.answer("stepBack", threadId=1)["success"])
        self.assertIn("seek", self.ask("evaluate", expression="why", context="repl")["result"] or "seek")

    def test_a_recording_is_debugged_too(self):
        recording = self.rules.parent / "run.soarrec"
        Run("run", "soar_seek", "--headless", "--seconds", 2, "--record", recording, code=0)
        self.begin(program=str(recording))
        self.assertIn("tick 1,", self.step("next")["description"])
        self.ask("continue", threadId=1)
        self.assertIn("tick 60,", self.wait_for("stopped")["description"])

    def test_it_attaches_to_a_kernel_which_goes_on_without_it(self):
        kernel = subprocess.Popen([COMMAND, "kernel", "--port", "0", self.rules], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(kernel.stdout.close)
        end_with(self, kernel)
        self.assertIn("agent counter", kernel.stdout.readline())
        port = int(re.search(r"127\.0\.0\.1:(\d+)", kernel.stdout.readline()).group(1))
        self.ask("attach", port=port)
        self.ask("configurationDone")
        self.wait_for("stopped")
        self.step("stepIn")
        self.step("stepIn")
        self.assertEqual("S1: add", self.frames()[0]["name"])
        self.ask("disconnect")
        self.assertEqual(0, self.channel.process.wait(30))
        self.assertIsNone(kernel.poll())

    def test_damaged_messages_are_answered(self):
        for command, arguments in (("launch", {}), ("launch", {"program": 3}), ("launch", {"program": "no_such"}), ("next", {}),
                                   ("stackTrace", {"threadId": -1}), ("scopes", {"frameId": 99}), ("variables", {"variablesReference": 7}),
                                   ("evaluate", {"expression": []}), ("setBreakpoints", {}), ("attach", {"port": 1}), ("nonsense", {})):
            self.assertFalse(self.answer(command, **arguments)["success"], command)
        self.channel.send_bytes(b"Content-Length: 3\r\n\r\n{{{Content-Length: x\r\n\r\n")
        self.channel.send({"seq": 99, "type": "request", "command": "launch", "arguments": []})
        while (message := self.receive())["type"] != "response":
            pass
        self.assertFalse(message["success"])
        self.ask("threads")
