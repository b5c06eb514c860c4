# SPDX-License-Identifier: BSD-2-Clause
"""Edits of rules and scripts while the world runs."""
import json
import math
import os
import signal
import subprocess
import tempfile

from soarbox_command import COMMAND, ScenarioCase, run_json
from test_soar_authors import WORLD

COUNT = """
sp {hero*begin (state <s> ^superstate nil -^heard) --> (<s> ^operator <o> +) (<o> ^name begin)}
sp {hero*began (state <s> ^operator.name begin) --> (<s> ^heard 0)}
sp {hero*propose (state <s> ^superstate nil ^heard <n> ^io.input-link.time <t>) --> (<s> ^operator <o> + =) (<o> ^name count ^time <t>)}
sp {hero*count (state <s> ^operator <o> ^heard <n>) (<o> ^name count ^time <t>) --> (<s> ^heard <n> - (+ <n> 1))}
sp {hero*tell (state <s> ^superstate nil ^heard <n>) --> (write |old | <n> (crlf))}
"""


class LiveEditCase(ScenarioCase):
    """A world that runs while its files are edited."""

    EDITED_AT, GOES_ON = 30, 60

    def run_and_edit(self, edit, rules=COUNT, until=bool, goes_on=GOES_ON):
        """Edits after a second of world time, waits until `until` is true for the run's error output, and ends the run `goes_on`
        ticks later. Without such output the run ends after four minutes of world time."""
        if rules is not None:
            self.write("hero.soar", rules)
            self.write("scenario.toml", WORLD)
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        events, edited, ends_at = [], False, None
        with tempfile.TemporaryFile("w+", encoding="utf-8") as errors:
            with subprocess.Popen([COMMAND, "run", str(self.folder), "--headless", "--json", "--speed", "2", "--seconds", "240",
                                   "--report", "0.1", "--watch"], stdout=subprocess.PIPE, stderr=errors, text=True, env=environment) as run:
                for line in run.stdout:
                    events.append(json.loads(line))
                    tick = events[-1].get("tick", 0)
                    if not edited and tick >= self.EDITED_AT:
                        edited = True
                        edit()
                    elif edited and ends_at is None and until(os.pread(errors.fileno(), 1 << 20, 0).decode(errors="replace")):
                        ends_at = tick + goes_on
                    elif ends_at is not None and tick >= ends_at:
                        # Sends only one signal: a second one would end it in the middle of its output.
                        ends_at = math.inf
                        run.send_signal(signal.SIGINT)
            errors.seek(0)
            err = errors.read()
        self.events = events
        self.last_tick = max((event["tick"] for event in events if event["event"] == "log"), default=0)
        self.end_tick = max(event.get("tick", 0) for event in events)
        return [event["text"] for event in events if event["event"] == "log"], err, events[-1]


class LiveEdits(LiveEditCase):
    def test_replace_rules_and_keep_working_memory(self):
        texts, err, _ = self.run_and_edit(lambda: self.write("hero.soar", COUNT.replace("|old |", "|new |")))
        self.assertIn("hero.soar: note: reloaded\n", err)
        old = [int(text.split()[1]) for text in texts if text.startswith("old ")]
        new = [int(text.split()[1]) for text in texts if text.startswith("new ")]
        self.assertTrue(old and new, texts)
        # It continues to count from the same number: nothing was lost.
        self.assertIn(new[0] - old[-1], (0, 1))
        self.assertFalse(any(text.startswith("old ") for text in texts[texts.index(f"new {new[0]}"):]))

    def test_of_a_script_keep_what_the_agent_has_come_to_know(self):
        body = """
local count, names = 0, {};
local kWord = "old";
total = 0;
local function Say(text) print(kWord .. " " .. text); end
function Agent_Initialize(agent) names.first = "anna"; end
function Agent_Update(agent)
    count = count + 1;
    total = total + 2;
    Say(count .. " " .. total .. " " .. tostring(names.first));
end
"""
        self.write("Body.lua", body)
        self.write("Sandbox.lua", "function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'Body.lua') end")
        texts, err, end = self.run_and_edit(lambda: self.write("Body.lua", body.replace('"old"', '"new"')), None)
        self.assertIn("Body.lua: note: reloaded", err)
        self.assertEqual(end["problems"], 0)
        told = [text.split(": ", 1)[1].split() for text in texts]
        # It continues to count from the same number, with the changed word.
        self.assertEqual([int(words[1]) for words in told], list(range(1, len(told) + 1)))
        self.assertEqual([int(words[2]) for words in told], list(range(2, 2 * len(told) + 2, 2)))
        self.assertEqual({words[3] for words in told}, {"anna"})
        words = [words[0] for words in told]
        self.assertEqual((words[0], words[-1]), ("old", "new"))
        self.assertEqual(words, sorted(words, reverse=True))

    def test_of_a_script_that_another_one_requires_arrive_too_and_its_errors_name_it(self):
        lib = "function Lib_Word()\n    return 'old';\nend\n"
        self.write("Lib.lua", lib)
        self.write("Sandbox.lua", "require 'Lib'\nfunction Sandbox_Update() print(Lib_Word()) end")
        texts, err, _ = self.run_and_edit(lambda: self.write("Lib.lua", lib.replace("'old'", "'new'")), None)
        self.assertIn("Lib.lua: note: reloaded", err)
        words = [text.split(": ", 1)[1] for text in texts]
        self.assertEqual((words[0], words[-1]), ("old", "new"))
        self.write("Lib.lua", lib)
        self.run_and_edit(lambda: self.write("Lib.lua", "\n" + lib.replace("'old'", "nothing.word")), None)
        error = [event["diagnostic"] for event in self.events if event["event"] == "diagnostic"][0]
        self.assertIn("attempt to index global 'nothing'", error["message"])
        self.assertEqual((error["file"].rpartition("/")[2], error["line"]), ("Lib.lua", 3))
        self.assertIn("called from Sandbox.lua:2", error["hint"])

    def test_of_a_file_that_another_one_sources_arrive_too(self):
        (self.folder / "parts" / "deep").mkdir(parents=True)
        rules = COUNT.split("sp {hero*tell")
        top, tell = rules[0] + "source parts/tell.soar\n", "sp {hero*tell" + rules[1]

        def edit():
            self.write("parts/deep/tell.soar", tell.replace("|old |", "|new |"))
        self.write("parts/tell.soar", "source deep/tell.soar\n")
        self.write("parts/deep/tell.soar", tell)
        texts, err, _ = self.run_and_edit(edit, top)
        self.assertIn("parts/deep/tell.soar: note: reloaded", err)
        self.assertTrue(texts[0].startswith("old ") and texts[-1].startswith("new "), texts)
        self.assertEqual([int(text.split()[1]) for text in texts], sorted(int(text.split()[1]) for text in texts))

    def test_that_take_a_rule_out_of_a_sourced_file_excise_it(self):
        rules = COUNT.split("sp {hero*tell")
        self.write("tell.soar", "sp {hero*tell" + rules[1])
        texts, err, _ = self.run_and_edit(lambda: self.write("tell.soar", "# nothing\n"), rules[0] + "source tell.soar\n")
        self.assertIn("tell.soar: note: reloaded", err)
        self.assertTrue(1 < self.last_tick < self.end_tick - self.GOES_ON / 2, "nothing is told after the edit")

    def test_that_put_something_else_in_place_of_a_file_are_told_once(self):
        def folder():
            (self.folder / "hero.soar").unlink()
            (self.folder / "hero.soar").mkdir()
        for edit, said in ((folder, "this is a folder now"), (lambda: (self.folder / "hero.soar").unlink(), "this file is gone")):
            texts, err, _ = self.run_and_edit(edit)
            if edit is folder:
                (self.folder / "hero.soar").rmdir()
            self.assertEqual(err.count(f"hero.soar: warning: {said}\n   note: the previous version keeps running\n"), 1, err)
            old = [int(text.split()[1]) for text in texts if text.startswith("old ")]
            self.assertGreater(old[-1], 40, "the rules go on to the end")

    def test_that_do_not_parse_change_nothing_and_say_where_and_what_to_do(self):
        tell = "sp {hero*tell (state <s> ^superstate nil ^heard <n>) -->"
        for broken, message, hint in (
                (COUNT.replace("(crlf))}", "(crlf))"), "rule hero*tell is not closed: } is missing", "put } at its end"),
                (COUNT.replace("^heard <n>) --> (write", "^heard <n> --> (write"), "found '-->'", "still open"),
                (COUNT.replace(tell, tell[3:]), "expected sp { here", "a rule starts with sp {"),
                (COUNT.replace(tell, tell.replace(" -->", "")), "-->", "write --> between the conditions and the actions"),
                (COUNT.replace("|old |", "|new |").replace("^heard 0", "^^heard 0"), "^", "")):
            self.assertNotEqual(broken, COUNT)
            texts, err, end = self.run_and_edit(lambda text=broken: self.write("hero.soar", text))
            self.assertRegex(err, r"hero\.soar:\d+(:\d+)?: error: ")
            self.assertIn(message, err)
            self.assertIn(hint, err)
            self.assertTrue(err.endswith("hero.soar: note: nothing was changed; the previous version keeps running\n"), err)
            self.assertEqual(end["problems"], 0)
            self.assertEqual({text.split()[0] for text in texts}, {"old"})
            self.assertGreater(int(texts[-1].split()[1]), 40, "the old rules go on to the end")

    def test_of_a_misspelt_attribute_are_warned_of_when_they_run(self):
        _, err, _ = self.run_and_edit(lambda: self.write("hero.soar", COUNT.replace("input-link.time", "input-link.tiem")),
                                      until=lambda err: "did you mean ^time?" in err)
        self.assertIn("warning: rule hero*propose tests ^tiem, which no percept and no rule makes", err)
        self.assertIn("did you mean ^time?", err)

    def test_that_are_typed_and_do_not_parse_change_nothing_either(self):
        self.write("hero.soar", COUNT)
        self.write("scenario.toml", WORLD)
        inputs = self.write("typed.txt", "30 command hero sp {hero*tell (state <s> ^superstate nil ^heard <n> --> (write |new |)}\n"
                                         "60 command hero sp {hero*tell (state <s> ^superstate nil ^heard <n>) --> (write |new | <n> (crlf))}\n")
        run = run_json(self.folder, "--seconds", 4, "--input", inputs)
        problem = next(problem for problem in run.diagnostics() if problem["severity"] == "error")
        self.assertIn("found '-->'", problem["message"])
        self.assertTrue(problem["hint"].endswith("nothing was changed"), problem)
        by_tick = [(event["tick"], event["text"].split()[0]) for event in run.of("log")]
        self.assertEqual({word for tick, word in by_tick if 30 < tick < 60}, {"old"})
        self.assertEqual({word for tick, word in by_tick if tick > 61}, {"new"})

    def test_commands_that_fail_say_only_what_is_wrong(self):
        self.write("hero.soar", COUNT)
        self.write("scenario.toml", WORLD)
        inputs = self.write("typed.txt", "20 command hero watch 99\n30 command hero nonsense\n")
        run = run_json(self.folder, "--seconds", 2, "--input", inputs)
        self.assertEqual([problem["message"] for problem in run.diagnostics() if problem["severity"] == "error"],
                         ["the command 'watch 99' failed for hero: Expected trace level from 0 to 5.",
                          "the command 'nonsense' failed for hero: No such command: nonsense"])
