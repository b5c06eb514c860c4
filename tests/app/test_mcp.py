# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox mcp` as a coding assistant uses it: lines of JSON-RPC on standard input and output."""
import json
import os
import re
import select
import subprocess
import unittest

COMMAND = os.environ["SOARBOX"]


from soarbox_command import new_folder


class Assistant(unittest.TestCase):
    def setUp(self):
        self.folder = new_folder(self)
        (self.folder / "inside").mkdir()
        (self.folder / "secret.soar").write_text("# secret words\n")
        (self.folder / "inside" / "a.soar").write_text("sp {a (state <s> ^superstate nil) --> (<x> ^y z)}\n")
        (self.folder / "inside" / "link.soar").symlink_to(self.folder / "secret.soar")
        self.process = subprocess.Popen([COMMAND, "mcp", "--folder", self.folder / "inside"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.addCleanup(self.end)
        self.number = 0
        self.assertEqual("soarbox", self.ask("initialize", protocolVersion="2024-11-05", capabilities={})["serverInfo"]["name"])

    def end(self):
        self.process.stdin.close()
        self.assertEqual(0, self.process.wait(60))
        self.process.stdout.close()

    def send_line(self, line):
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()
        self.assertTrue(select.select([self.process.stdout], [], [], 240)[0], "no answer")
        return json.loads(self.process.stdout.readline())

    def answer(self, method, **params):
        self.number += 1
        answer = self.send_line(json.dumps({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params}).encode())
        self.assertEqual(self.number, answer["id"])
        return answer

    def ask(self, method, **params):
        return self.answer(method, **params)["result"]

    def call(self, tool, **arguments):
        """The answer of a tool, and the recording that it names."""
        result = self.ask("tools/call", name=tool, arguments=arguments)
        texts = [part["text"] for part in result["content"]]
        self.assertFalse(result["isError"], texts)
        return "\n".join(texts)

    def test_its_tools_describe_themselves_and_are_all_there(self):
        tools = self.ask("tools/list")["tools"]
        for tool in tools:
            self.assertEqual("object", tool["inputSchema"]["type"])
            self.assertTrue(tool["annotations"]["readOnlyHint"])
            answer = self.answer("tools/call", name=tool["name"], arguments={"path": 3, "source": 3, "recording": 3, "scenario": 3})
            if tool["inputSchema"]["required"]:
                self.assertIn("error", answer, tool["name"])

    def test_it_checks_rules_of_a_file_and_of_a_text(self):
        self.assertIn('"line":1', self.call("check_rules", path="a.soar"))
        text = self.call("check_rules", text="sp {b (state <s> ^superstate nil) --> (<s> ^operator <o> +)")
        self.assertIn('"severity":"error"', text)
        self.assertNotIn("soarbox-mcp-", text)

    def test_it_knows_percepts_with_units_and_commands(self):
        self.assertIn("^io.input-link.agent.range (number, m", self.call("list_percepts", filter="agent.r"))
        self.assertIn("^waypoint", self.call("list_commands", filter="move-to"))
        self.assertIn("soar_seek", self.call("list_scenarios"))

    def test_it_runs_and_asks_why_and_tries_another_future(self):
        text = self.call("run_scenario", scenario="soar_seek", seconds=4)
        recording = text.rsplit("recording: ", 1)[1]
        self.assertIn('"event"', text)
        why = self.call("why", source=recording, at=2)
        self.assertIn("seek", why)
        stack = self.call("inspect", source=recording, view="stack", at=2)
        self.assertIn("S1", stack)
        self.assertIn("seek", self.call("read_recording", recording=recording, to=1))
        rules = self.call("inspect", source="soar_seek", view="rules", at=1)
        name = next(word for word in rules.split() if "*" in word)
        future = self.call("try_future", recording=recording, at=1, seconds=2,
                           rules="sp {%s (state <s> ^superstate nil) --> (<s> ^idle yes)}" % name)
        self.assertIn("recording: ", future)
        self.assertRegex(future, "differ|tick")

    def test_lesson_5_is_solved_and_graded_by_tools_alone(self):
        self.assertIn("Commands and their answers", self.call("list_lessons"))
        lesson = self.call("read_lesson", lesson=5)
        self.assertIn("must not try the hut twice", lesson)
        starter = lesson.split("climber.soar:\n", 1)[1].split("scenario.toml:\n")[0]
        self.assertIn("climber*propose*hut", starter)
        graded = self.call("grade_lesson", lesson=5, rules=starter)
        self.assertIn("no rule made ^closed of it", graded)
        self.assertIn("panel Senses", self.call("lesson_hint", lesson=5))
        answer = starter + """
sp {climber*apply*learn
   (state <s> ^operator <o> ^io.output-link.move-to <command>)
   (<o> ^name go ^where <name>)
   (<command> ^waypoint <name> ^reason <reason>)
-->
   (<s> ^closed <name>)}
"""
        self.assertNotIn('"severity":"error"', self.call("check_rules", text=answer))
        self.assertIn("Passed", self.call("grade_lesson", lesson=5, rules=answer))
        self.assertIn("error", self.answer("tools/call", name="read_lesson", arguments={"lesson": 99}))

    def test_rules_are_formatted_and_have_a_datamap(self):
        text = self.call("format_rules", text="sp {b\n(state <s> ^superstate nil)\n-->\n(<s> ^here yes)}")
        self.assertIn("sp {b\n   (state <s> ^superstate nil)\n-->\n", text)
        (self.folder / "inside" / "b.soar").write_text("sp {b (state <s> ^superstate nil ^colour red) --> (<s> ^here yes)}\n")
        self.assertIn("colour", self.call("make_datamap", path="b.soar"))
        self.assertEqual({"a.soar", "b.soar", "link.soar"}, {path.name for path in (self.folder / "inside").iterdir()})
        self.assertIn("error", self.answer("tools/call", name="make_datamap", arguments={"path": "../secret.soar"}))

    def test_prompts_name_tools_that_exist(self):
        prompts = self.ask("prompts/list")["prompts"]
        self.assertGreaterEqual({prompt["name"] for prompt in prompts}, {"explain_agent", "find_mistake", "write_agent", "solve_lesson"})
        tools = {tool["name"] for tool in self.ask("tools/list")["tools"]}
        for prompt in prompts:
            given = {one["name"]: "the " + one["name"] for one in prompt["arguments"]}
            [message] = self.ask("prompts/get", name=prompt["name"], arguments=given)["messages"]
            text = message["content"]["text"]
            self.assertNotIn("{", text)
            for value in given.values():
                self.assertIn(value, text)
            named = set(re.findall(r"[a-z]+_[a-z]+", text))
            self.assertLessEqual(named, tools, prompt["name"])
        self.assertIn("lesson is missing", json.dumps(self.answer("prompts/get", name="solve_lesson")))
        self.assertIn("no prompt", json.dumps(self.answer("prompts/get", name="other")))

    def test_resources_are_read(self):
        for resource in self.ask("resources/list")["resources"]:
            [content] = self.ask("resources/read", uri=resource["uri"])["contents"]
            self.assertEqual(content["uri"], resource["uri"])
            self.assertGreater(len(content["text"]), 200, resource["uri"])
        self.assertEqual(self.ask("resources/templates/list")["resourceTemplates"][0]["uriTemplate"], "soarbox://lesson/{number}")
        [lesson] = self.ask("resources/read", uri="soarbox://lesson/5")["contents"]
        self.assertIn("climber*propose*hut", lesson["text"])
        for uri in ("soarbox://lesson/99", "soarbox://lesson/x", "file:///etc/passwd"):
            self.assertIn("error", self.answer("resources/read", uri=uri), uri)

    def test_nothing_outside_of_its_folder_is_read(self):
        for path in ("../secret.soar", str(self.folder / "secret.soar"), "link.soar", "/etc/passwd", "--json"):
            answer = self.answer("tools/call", name="check_rules", arguments={"path": path})
            self.assertIn("error", answer, path)
            self.assertNotIn("secret words", json.dumps(answer))
        self.assertEqual({"a.soar", "link.soar"}, {path.name for path in (self.folder / "inside").iterdir()})

    def test_damaged_messages_are_answered(self):
        for line in (b"{", b"[]", b"3", b'{"id":1}', b'{"id":1,"method":3}', b"\xff\xfe", b'{"id":"x","method":"no"}',
                     b'{"id":1,"method":"tools/call"}', b'{"id":1,"method":"tools/call","params":{"name":"why","arguments":[]}}'):
            self.assertIn("error", self.send_line(line), line)
        self.assertEqual({}, self.ask("ping"))
