# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox dap` for scripts in Lua, as an editor's debugger uses it, and `soarbox run --profile`."""
import re
import unittest

from editor_client import Channel
from soarbox_command import Run, new_folder

SANDBOX = """function Sandbox_Initialize(sandbox)
    local wanted = 2
    Sandbox.CreateAgent(sandbox, "Walker.lua")
    started = wanted
end

function Sandbox_Update(sandbox, milliseconds)
    ticks = (ticks or 0) + 1
end
"""
WALKER = """require "Steps"

state = { name = "walking", since = 0 }

local function Far(agent)
    local place = agent:GetPosition()
    return place.x > 2
end

function Agent_Update(agent, milliseconds)
    state.since = state.since + 1
    local next_x = Step(state.since)
    agent:SetPosition(Vector.new(next_x, 0, 0))
    if Far(agent) then
        state = { name = "resting", since = 0 }
    end
    if broken then
        print(broken.field.other)
    end
end
"""
STEPS = """function Step(count)
    local length = 0.5
    return count * length
end
"""


class LuaDebugger(unittest.TestCase):
    def setUp(self):
        self.folder = new_folder(self)
        self.walker, self.steps, self.sandbox = (self.folder / name for name in ("Walker.lua", "Steps.lua", "Sandbox.lua"))
        self.walker.write_text(WALKER)
        self.steps.write_text(STEPS)
        self.sandbox.write_text(SANDBOX)
        self.channel = Channel("dap")
        self.addCleanup(self.channel.close)
        self.number = 0
        self.events = []
        self.ask("initialize", adapterID="soarbox")
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

    def wait_for(self, name, is_it=lambda body: True):
        def found():
            return next((event for event in self.events if event["event"] == name and is_it(event.get("body"))), None)
        while found() is None:
            self.events.append(self.receive())
        event = found()
        self.events.remove(event)
        return event.get("body")

    def launch(self, **arguments):
        self.ask("launch", program=str(self.folder), seconds=5, **arguments)

    def begin(self, **arguments):
        self.launch(**arguments)
        self.ask("configurationDone")
        return self.wait_for("stopped")

    def mark(self, file, *lines):
        marks = [{"line": line} if isinstance(line, int) else line for line in lines]
        return self.ask("setBreakpoints", source={"path": str(file)}, breakpoints=marks)["breakpoints"]

    def go(self, command="continue", thread=1):
        self.ask(command, threadId=thread)
        return self.wait_for("stopped")

    def place(self, thread):
        top = self.frames(thread)[0]
        return top["source"]["name"], top["line"], top["name"]

    def frames(self, thread):
        return self.ask("stackTrace", threadId=thread)["stackFrames"]

    def scope(self, frame, name):
        scopes = {one["name"]: one["variablesReference"] for one in self.ask("scopes", frameId=frame)["scopes"]}
        return self.unfold(scopes[name])

    def unfold(self, reference):
        return {one["name"]: one for one in self.ask("variables", variablesReference=reference)["variables"]}

    def value(self, expression, frame, context="watch"):
        return self.ask("evaluate", expression=expression, context=context, frameId=frame)["result"]

    def thread(self, name):
        return next(one["id"] for one in self.ask("threads")["threads"] if one["name"] == name)

    def test_it_stops_at_a_line_and_shows_calls_and_variables(self):
        self.begin()
        marks = self.mark(self.steps, 3, 40)
        self.assertEqual([(True, 3), (False, 40)], [(one["verified"], one["line"]) for one in marks])
        stopped = self.go()
        self.assertEqual(("breakpoint", self.thread("Walker-1")), (stopped["reason"], stopped["threadId"]))
        self.assertIn("Steps.lua:3: breakpoint", stopped["text"])
        frames = self.frames(stopped["threadId"])
        self.assertEqual([("Step", 3, str(self.steps)), ("Agent_Update", 12, str(self.walker))],
                         [(one["name"], one["line"], one["source"]["path"]) for one in frames])
        local = self.scope(frames[0]["id"], "Locals")
        self.assertEqual({"count": "1", "length": "0.5"}, {name: one["value"] for name, one in local.items()})
        outer = self.scope(frames[1]["id"], "Globals")
        self.assertEqual(["state"], list(outer))
        self.assertEqual('"walking"', self.unfold(outer["state"]["variablesReference"])["name"]["value"])
        self.assertEqual("0.5", self.value("count * length", frames[0]["id"]))
        self.assertEqual('"walking"', self.value("state.name", frames[1]["id"], "hover"))
        self.assertEqual("0", self.value("agent:GetPosition().x", frames[1]["id"]))
        refused = self.answer("evaluate", expression="Step(3)", context="watch", frameId=frames[0]["id"])
        self.assertIn("Step is a function of a script", refused["message"])

    def test_it_steps_over_into_and_out(self):
        self.begin()
        self.mark(self.walker, 12)
        thread = self.go()["threadId"]
        seen = [self.place(thread)]
        for command in ("stepIn", "next", "stepOut", "next", "stepIn", "stepOut"):
            self.go(command, thread)
            seen.append(self.place(thread))
        self.assertEqual([("Walker.lua", 12, "Agent_Update"), ("Steps.lua", 2, "Step"), ("Steps.lua", 3, "Step"),
                          ("Walker.lua", 13, "Agent_Update"), ("Walker.lua", 14, "Agent_Update"), ("Walker.lua", 6, "Far"),
                          ("Walker.lua", 14, "Agent_Update")], seen)
        # The end of the call leads to the next tick.
        self.mark(self.walker)
        self.go("stepOut", thread)
        self.assertEqual(("Walker.lua", 11, "Agent_Update"), self.place(thread))
        self.assertEqual("1", self.value("state.since", self.frames(thread)[0]["id"]))

    def test_conditions_and_breakpoints_in_the_set_up(self):
        self.launch(stopOnEntry=False)
        self.mark(self.sandbox, 4)
        self.mark(self.walker, {"line": 12, "condition": "state.since == 3"})
        self.ask("configurationDone")
        stopped = self.wait_for("stopped")
        self.assertEqual(("Sandbox.lua", 4, "Sandbox_Initialize"), self.place(stopped["threadId"]))
        self.assertEqual("2", self.scope(self.frames(stopped["threadId"])[0]["id"], "Locals")["wanted"]["value"])
        stopped = self.go()
        frame = self.frames(stopped["threadId"])[0]["id"]
        self.assertEqual("3", self.value("state.since", frame))
        self.assertIn("tick 3,", stopped["description"])
        # Back to the beginning of this tick, and there again.
        self.ask("stepBack", threadId=stopped["threadId"])
        self.assertIn("tick 2,", self.wait_for("stopped")["description"])
        again = self.go()
        self.assertIn("tick 3,", again["description"])
        self.assertEqual("3", self.value("state.since", self.frames(again["threadId"])[0]["id"]))

    def test_a_log_point_prints_values_and_does_not_stop(self):
        self.begin()
        self.mark(self.steps, {"line": 3, "logMessage": "{count} steps of {length}, {unknown.field}", "condition": "count < 4"})
        self.assertEqual("the run is over", self.go()["text"])
        printed = [event["body"]["output"] for event in self.events if event["event"] == "output" and "steps of" in event["body"]["output"]]
        self.assertEqual(["1 steps of 0.5", "2 steps of 0.5", "3 steps of 0.5"], [one.split(",")[0] for one in printed[:3]])
        self.assertIn("a nil value has no fields", printed[0].split(", ", 1)[1])

    def test_the_console_reaches_a_script_between_two_ticks(self):
        self.begin()
        walker, sandbox = self.thread("Walker-1"), self.thread("sandbox")
        self.go("next", walker)
        frame = self.frames(walker)[0]["id"]
        self.assertEqual("1", self.value("state.since", frame, "repl"))
        self.assertEqual("1", self.scope(self.frames(sandbox)[0]["id"], "Globals")["ticks"]["value"])
        self.assertIn("next tick", self.value("state.since = 2", frame, "repl"))
        self.assertIn("next tick", self.value("Step(8)", frame, "repl"))
        self.go("next", walker)
        self.wait_for("output", lambda body: re.search(r"\b4\b", body["output"]))
        self.assertEqual("3", self.value("state.since", self.frames(walker)[0]["id"]))
        # Typed commands are inputs: they are applied again after a step back.
        self.go("next", walker)
        self.go("stepBack", walker)
        self.assertEqual("3", self.value("state.since", self.frames(walker)[0]["id"]))

    def test_it_stops_at_errors_and_the_run_goes_on(self):
        self.begin()
        self.ask("setExceptionBreakpoints", filters=["scripts"])
        walker = self.thread("Walker-1")
        self.value("broken = {}", self.frames(walker)[0]["id"], "repl")
        stopped = self.go()
        self.assertEqual("exception", stopped["reason"])
        self.assertIn("attempt to index field 'field'", stopped["text"])
        self.assertEqual(("Walker.lua", 18, "Agent_Update"), self.place(walker))
        self.assertEqual("{}", self.value("broken", self.frames(walker)[0]["id"]))
        self.ask("setExceptionBreakpoints", filters=[])
        self.assertEqual("the run is over", self.go()["text"])

    def test_disconnecting_in_the_middle_of_a_tick_ends_it(self):
        self.begin()
        self.mark(self.steps, 2)
        self.go()
        self.ask("disconnect")
        self.assertEqual(0, self.channel.process.wait(60))

    def test_soars_breakpoints_work_beside_those_of_scripts(self):
        self.mark(self.walker, 999)
        self.begin()
        self.assertEqual(["sandbox", "Walker-1"], [one["name"] for one in self.ask("threads")["threads"]])
        self.assertEqual("the run is over", self.go()["text"])


class Profile(unittest.TestCase):
    def test_calls_per_tick_are_counted_and_the_run_stays_the_same(self):
        folder = new_folder(self)
        for name, text in (("Sandbox.lua", SANDBOX), ("Walker.lua", WALKER), ("Steps.lua", STEPS)):
            (folder / name).write_text(text)
        plain = Run("run", folder, "--headless", "--seconds", 2, code=0)
        profiled = Run("run", folder, "--headless", "--seconds", 2, "--profile", code=0)
        self.assertEqual(plain.out, profiled.out)
        rows = {name: calls for calls, name in re.findall(r"^ *([0-9.]+) .* (\S+ \(\S+\))$", profiled.err, re.MULTILINE)}
        self.assertEqual("1.00", rows["Step (Steps.lua:1)"])
        self.assertEqual("1.00", rows["Far (Walker.lua:5)"])
        self.assertEqual("1.00", rows["Sandbox_Update (Sandbox.lua:7)"])
        self.assertIn("for each of 60 ticks", profiled.err)


if __name__ == "__main__":
    unittest.main()
