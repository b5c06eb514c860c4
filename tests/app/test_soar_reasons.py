# SPDX-License-Identifier: BSD-2-Clause
"""Why an agent does what it does, or nothing: gap reports, `soarbox why`, `soarbox check`."""
import json
import unittest

from soarbox_command import Run, ScenarioCase, run_json
from test_soar_authors import SCOUT, WORLD


class Reasons(ScenarioCase):
    def gap(self, rules, *arguments):
        self.write("hero.soar", rules)
        self.write("scenario.toml", WORLD)
        run = run_json(self.folder, "--seconds", 3, *arguments)
        self.assertEqual(run.code, 0, run.err)
        return run.of("gap", agent="hero")

    def test_name_an_attribute_that_nothing_writes(self):
        gaps = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.distnace < 3) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}""")
        self.assertEqual(len(gaps), 1)
        self.assertIn("tests ^distnace, which no sense and no rule ever writes: did you mean ^distance?", gaps[0]["reasons"][0])

    def test_name_the_rule_that_came_nearest_its_failing_condition_and_the_values(self):
        reasons = self.gap("""
sp {hero*far (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}""")[0]["reasons"]
        self.assertEqual(reasons[0], "no operator is proposed in S1")
        self.assertIn("rule hero*far came to ", reasons[1])
        self.assertIn("^health is now 100", reasons[1])
        self.assertTrue(any(reason.startswith("it perceives ") and "^health 100" in reason for reason in reasons))

    def test_name_the_operators_of_a_tie_and_what_would_decide_it(self):
        reasons = self.gap("""
sp {hero*one (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name one)}
sp {hero*two (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name two)}""")[0]["reasons"]
        self.assertIn("operator tie in S1", reasons[0])
        self.assertIn("(one) from hero*one", reasons[0])
        self.assertIn("(two) from hero*two", reasons[0])
        self.assertIn("(<s> ^operator <o> + =)", reasons[0])

    def test_name_an_operator_that_nothing_applies(self):
        reasons = self.gap("""
sp {hero*one (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name one)}""")[0]["reasons"]
        self.assertIn("operator one is selected in S1 and no rule applies it", reasons[0])

    def test_are_told_once_per_cause_with_a_count(self):
        self.write("hero.soar", """
sp {hero*propose*a (state <s> ^superstate nil ^io.input-link.time <t>) (<s> -^told <t>) --> (<s> ^operator <o> + =) (<o> ^name say ^time <t>)}
sp {hero*apply*a (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name say ^time <t>) --> (<s> ^told <t>) (<out> ^shoot <c>)}""")
        self.write("scenario.toml", WORLD)
        run = run_json(self.folder, "--seconds", 3)
        self.assertEqual(len(run.of("outcome", command="shoot")), 1)
        self.assertIn("error no-target", run.of("outcome", command="shoot")[0]["text"])
        self.assertTrue(any("times in all: error of shoot no-target" in gap["text"] for gap in run.of("gap")), run.of("gap"))

    def test_are_not_given_for_an_agent_that_waits_for_a_lasting_command(self):
        scout = self.write("scout.soar", SCOUT)
        self.assertEqual(run_json(scout, "--seconds", 5).of("gap"), [])


class Why(ScenarioCase):
    def test_goes_from_the_command_to_operator_rule_elements_and_percepts(self):
        run = Run("why", self.write("scout.soar", SCOUT), "--agent", "scout", "--at", 2)
        self.assertEqual(run.code, 0, run.err)
        for piece in ("scout at 2.0", "command move-to ^waypoint", "under way", "said by rule scout*apply*move-to",
                      "operator move-to", "by rule scout*propose*move-to", "^waypoint W", "^path (^status moving"):
            self.assertIn(piece, run.out)

    def test_suggests_the_agent_that_was_meant(self):
        run = Run("why", self.write("scout.soar", SCOUT), "--agent", "scuot")
        self.assertEqual(run.code, 3)
        self.assertIn("did you mean 'scout'?", run.err)


class Check(ScenarioCase):
    def check(self, name, text):
        run = Run("check", self.write(name, text), "--json")
        return run.code, [json.loads(line) for line in run.out.splitlines()]

    def test_finds_nothing_wrong_with_good_files(self):
        self.assertEqual(self.check("scout.soar", SCOUT), (0, []))
        self.assertEqual(self.check("scenario.toml", '[[agent]]\nrules = "scout.soar"\n'), (0, []))
        self.assertEqual(self.check("x.lua", "local x = 1"), (0, []))

    def test_tells_errors_of_each_kind_of_file_with_their_lines(self):
        for name, text, line in (("a.soar", "sp {a\n   (state <s> ^superstate nil\n-->\n   (<s> ^x 1)\n}\n", 3),
                                 ("b.lua", "local x = 1\nif x then\nlocal = 3\n", 3),
                                 ("c.toml", 'seed = 1\nsecnods = 3\n', 2),
                                 ("d.toml", '[[agent]]\nrules = "nowhere.soar"\n', 1)):
            code, problems = self.check(name, text)
            self.assertEqual(code, 1, name)
            self.assertEqual((problems[0]["severity"], problems[0]["line"]), ("error", line), problems)

    def test_finds_slips_with_line_and_suggestion(self):
        code, problems = self.check("slips.soar", """# ^distnace in a comment is none
sp {a*propose
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^waypoint.bearnig 3)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {a*propose*other
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> +)
   (<o> ^name never)
}
sp {a*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^folow <c>)
}
""")
        self.assertEqual(code, 1)
        found = {(problem["severity"], problem["line"], problem.get("hint", "")) for problem in problems}
        self.assertIn(("warning", 4, "did you mean ^bearing?"), found)
        self.assertIn(("warning", 18, "did you mean ^follow?"), found)
        self.assertTrue(any("proposes the operator never" in problem["message"] and problem["line"] == 13 for problem in problems), problems)
        self.assertEqual(len(problems), 3, problems)

    def test_knows_percepts_and_commands_of_scripts_beside_the_rules(self):
        self.write("Body.lua", "function Agent_Sense(a) return {glow = 1} end\nfunction Agent_Update(a, t, c) if c == 'shine' then end end")
        code, problems = self.check("lamp.soar", """
sp {a (state <s> ^superstate nil ^io.input-link.glow 1) --> (<s> ^operator <o> +) (<o> ^name x)}
sp {b (state <s> ^operator.name x ^io.output-link <out>) --> (<out> ^shine <c>)}""")
        self.assertEqual((code, problems), (0, []))

    def test_names_files_that_are_not_there(self):
        self.assertEqual(Run("check", self.folder / "no.soar").code, 1)


if __name__ == "__main__":
    unittest.main()
