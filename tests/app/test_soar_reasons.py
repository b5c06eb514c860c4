# SPDX-License-Identifier: BSD-2-Clause
"""The reasons for what an agent does or does not do: gap reports, `soarbox why`, `soarbox check`."""
import json

from soarbox_command import Run, ScenarioCase, run_json
from test_soar_authors import SCOUT, WORLD


class Reasons(ScenarioCase):
    def gap(self, rules, *arguments):
        self.write("hero.soar", rules)
        self.write("scenario.toml", WORLD)
        run = run_json(self.folder, "--seconds", 3, *arguments, code=0)
        return run.of("gap", agent="hero")

    def test_name_an_attribute_that_nothing_writes(self):
        gaps = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.distnace < 3) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}""")
        self.assertEqual(len(gaps), 1)
        self.assertIn("tests ^distnace, which no percept and no rule makes: did you mean ^distance?", gaps[0]["reasons"][0])

    def test_name_the_rule_that_came_nearest_its_failing_condition_and_the_values(self):
        reasons = self.gap("""
sp {hero*far (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}""")[0]["reasons"]
        self.assertEqual(reasons[0], "no operator is proposed in S1")
        self.assertEqual(reasons[1], "rule hero*far requires ^io.input-link.self.health < 50, but it is 100")
        self.assertTrue(any(reason.startswith("it perceives ") and "^health 100" in reason for reason in reasons))

    def test_name_the_operators_of_a_tie_and_what_would_decide_it(self):
        reasons = self.gap("""
sp {hero*one (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name one)}
sp {hero*two (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name two)}""")[0]["reasons"]
        self.assertEqual(reasons[0], "operator tie in S1: no preference decides among one and two")
        self.assertEqual(reasons[1:3], ["one is proposed by rule hero*one", "two is proposed by rule hero*two"])
        self.assertIn("(<s> ^operator <o> + =)", reasons[3])

    def test_tell_operators_of_one_name_apart(self):
        reasons = self.gap("""
sp {hero*go (state <s> ^superstate nil ^io.input-link.self <me>) (<me> ^ << ammunition reserve >> <n>) --> (<s> ^operator <o> +) (<o> ^name go ^n <n>)}""")[0]["reasons"]
        self.assertEqual(sorted(reasons[1:3]), ["go ^n 10 is proposed by rule hero*go", "go ^n 40 is proposed by rule hero*go"])

    def test_name_preferences_that_contradict_each_other(self):
        reasons = self.gap("""
sp {hero*one (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name one)}
sp {hero*two (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name two)}
sp {hero*a (state <s> ^operator <a> + ^operator <b> +) (<a> ^name one) (<b> ^name two) --> (<s> ^operator <a> > <b>)}
sp {hero*b (state <s> ^operator <a> + ^operator <b> +) (<a> ^name one) (<b> ^name two) --> (<s> ^operator <b> > <a>)}""")[0]["reasons"]
        self.assertRegex(reasons[0], r"^operator conflict in S1: each of .* is worse than another one; ")
        self.assertIn("rule hero*a makes one (O1) better than two (O2)", reasons[0])
        self.assertIn("rule hero*b makes two (O2) better than one (O1)", reasons[0])

    GO = "\nsp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}"

    def nearest(self, conditions):
        return self.gap("sp {hero*go (state <s> ^superstate nil ^io.input-link <in>) " + conditions +
                        " --> (<s> ^operator <o> +) (<o> ^name go)}" + self.GO)[0]["reasons"][1]

    def test_say_what_is_there_in_the_words_of_the_author(self):
        for conditions, said in (
            ("(<in> ^self.weapon redy)", "rule hero*go requires ^io.input-link.self.weapon redy, but it is ready; "
             "it is never redy, only none ready cooling reloading empty"),
            ("(<in> ^agent <a>)", "rule hero*go requires ^io.input-link.agent <a>, but there is none now (Another agent that"),
            ("(<in> ^health > 50)", "^io.input-link.health > 50, but no percept is there: it is ^io.input-link.self.health"),
            ("(<in> -^self.health 100)", "rule hero*go requires no ^io.input-link.self"),
            ("(<in> ^self <me>) (<me> ^reserve <r> ^health < <r>)", "^io.input-link.self.reserve > ^io.input-link.self.health, but it is 40; ^io.input-link.self.health is 100"),
        ):
            self.assertIn(said, self.nearest(conditions), conditions)

    def test_follow_what_is_waited_for_to_the_rule_that_makes_it(self):
        reasons = self.gap("""
sp {hero*danger (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^danger yes)}
sp {hero*go (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name go)}""" + self.GO)[0]["reasons"]
        self.assertIn("rule hero*go requires ^danger yes, but there is none now; rule hero*danger makes it", reasons)
        self.assertIn("rule hero*danger requires ^io.input-link.self.health < 50, but it is 100", reasons)

    def test_do_not_name_a_rule_that_makes_something_else(self):
        for rule in ("sp {hero*calm (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^danger no)}",
                     "sp {hero*note (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^note <n>) (<n> ^danger yes)}",
                     "sp {hero*end (state <s> ^superstate nil ^danger yes) --> (<s> ^danger yes -)}",
                     "sp {hero*keep (state <s> ^superstate nil ^danger <d>) --> (<s> ^danger <d>)}"):
            reasons = self.gap(rule + "\nsp {hero*go (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name go)}" +
                               self.GO)[0]["reasons"]
            said = [reason for reason in reasons if "hero*go requires ^danger yes" in reason]
            self.assertEqual(len(said), 1, reasons)
            self.assertNotIn("makes it", said[0].replace("no rule makes it", ""), rule)

    def test_do_not_say_that_an_operator_was_applied_if_no_rule_fired_for_it(self):
        reasons = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.input-link.self.health < 50 ^io.output-link <out>) --> (<out> ^stop <c>)}""")[0]["reasons"]
        self.assertEqual(reasons[0], "operator go is selected in S1 and no rule that applies it matches")
        self.assertEqual(reasons[1], "rule hero*apply requires ^io.input-link.self.health < 50, but it is 100")
        self.assertFalse([reason for reason in reasons if "has been applied" in reason])

    def test_end_where_two_rules_wait_for_each_other(self):
        rules = """
sp {hero*a (state <s> ^superstate nil ^y yes) --> (<s> ^x yes)}
sp {hero*b (state <s> ^superstate nil ^x yes) --> (<s> ^y yes)}
sp {hero*go (state <s> ^superstate nil ^x yes) --> (<s> ^operator <o> +) (<o> ^name go)}""" + self.GO
        reasons = self.gap(rules)[0]["reasons"]
        self.assertEqual(len(reasons), len(set(reasons)), reasons)
        why = Run("why", self.folder, "go", "--agent", "hero").out
        self.assertIn("rule hero*go requires ^x yes, but ^x and ^y wait for each other: only rule hero*a creates ^x, and it "
                      "tests ^y; only rule hero*b creates ^y, and it tests ^x", why)
        self.assertNotIn("makes it", why)

    def test_say_that_the_last_command_failed_and_that_its_operator_stays(self):
        gaps = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^wandr <c>)}""")
        self.assertIn("its last command wandr failed: unknown-command", gaps[0]["reasons"][0])
        self.assertIn("operator go has been applied (rule hero*apply) and stays selected", gaps[0]["reasons"][1])

    def test_why_says_that_a_command_was_refused_and_does_not_blame_the_proposal(self):
        self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name flee)}
sp {hero*apply (state <s> ^operator.name flee ^io.output-link <out>) --> (<out> ^flee <c>) (<c> ^from wolf)}""")
        why = Run("why", self.folder, "--agent", "hero", "--at", 2, code=0).out
        self.assertIn("its last command flee failed: ", why)
        self.assertNotIn("let the proposal test", why)
        # The operator has the name of the command.
        topic = Run("why", self.folder, "flee", "--agent", "hero", "--at", 2, code=0).out
        self.assertRegex(topic, r"command flee .*: flee failed: ")
        self.assertIn("flee (O1) was selected", topic)

    def test_name_the_rule_that_removes_each_command_at_once(self):
        reasons = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^wander <c>)}
sp {hero*tidy (state <s> ^operator <o> ^io.output-link <out>) (<out> ^<name> <c>) --> (<out> ^<name> <c> -)}""")[0]["reasons"]
        self.assertRegex(reasons[0], r"^rule hero\*tidy removes every command while its operator is selected, also the \^wander that rule hero\*apply")

    def test_say_that_a_selected_operator_has_no_name(self):
        self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^to gate)}
sp {hero*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^stop <c>)}""")
        why = Run("why", self.folder, "hero*apply", "--agent", "hero", "--at", 2, code=0).out
        self.assertIn("but the operator selected in S1 is O1, which has no name", why)
        self.assertIn("hero*propose: all its conditions hold now, but the operator that it proposes has no ^name", why)

    def test_name_percepts_that_belong_to_an_absent_one(self):
        # While the radar is off, there is no ^radar.
        rules = self.write("tank.soar", """
sp {tank*propose*fire (state <s> ^io.input-link.radar.tank) --> (<s> ^operator <o> +) (<o> ^name fire)}
sp {tank*apply*fire (state <s> ^operator.name fire ^io.output-link <out>) --> (<out> ^fire.weapon missile)}""")
        recording = self.folder / "run.soarrec"
        Run("run", "tanksoar", "--headless", "--seconds", 2, "--rules", f"tank={rules}", "--record", recording)
        why = Run("why", recording, "fire", "--agent", "tank", "--at", 2, code=0).out
        self.assertIn("^io.input-link.radar-status is off", why)

    def test_name_the_operator_that_a_rule_applies_under_another_name(self):
        reasons = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name goo ^io.output-link <out>) --> (<out> ^stop <c>)}""")[0]["reasons"]
        self.assertIn("no rule applies it: rule hero*apply applies goo: did you mean that?", reasons[0])

    def test_look_below_an_operator_that_is_worked_on_in_a_substate(self):
        reasons = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*below (state <s> ^superstate.io.input-link.self.health < 50) --> (<s> ^operator <o> +) (<o> ^name step)}""")[0]["reasons"]
        self.assertIn("in the state below it no operator is proposed", reasons[0])
        self.assertEqual(reasons[1], "rule hero*below requires ^superstate.io.input-link.self.health < 50, but it is 100")

    def test_name_the_rule_that_halted_the_program(self):
        gaps = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*apply (state <s> ^operator.name go) --> (halt)}""")
        self.assertEqual(gaps[0]["text"], "its program has halted: rule hero*apply calls (halt)")

    def test_are_given_for_the_minds_of_scripts_too(self):
        self.write("Body.lua", "function Agent_Initialize(agent) agent:SetTarget(Vector.new(5, 0, 0)) end\nfunction Agent_Update(agent) end")
        self.write("far.soar", """
sp {far*propose (state <s> ^superstate nil ^io.input-link.distance > 1000) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {far*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^go <c>)}""")
        self.write("Sandbox.lua", "function Sandbox_Initialize(s) Sandbox.CreateSoarAgent(s, 'Body.lua', 'far.soar', {name = 'far'}) end")
        gap = run_json(self.folder, "--seconds", 2).of("gap")[0]
        self.assertEqual(gap["text"], "it gave no command within its decision budget")
        self.assertIn("rule far*propose requires ^io.input-link.distance > 1000, but it is 25", gap["reasons"])
        self.assertTrue(any(reason.startswith("it perceives ^distance 25") for reason in gap["reasons"]), gap)

    def test_name_a_rule_that_failed_to_parse_and_why_until_it_is_mended(self):
        broken = """
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self (<s> ^operator <o> +) (<o> ^name go)}"""
        self.write("hero.soar", broken + self.GO)
        self.write("scenario.toml", WORLD)
        reasons = run_json(self.folder, "--seconds", 3).of("gap", agent="hero")[0]["reasons"]
        self.assertRegex(reasons[0], r"^no rule proposes an operator: rule hero\*propose in hero.soar:\d+ failed to parse: .")
        self.assertNotIn("write one", reasons[0])
        why = Run("why", self.folder, "hero*propose", "--agent", "hero", "--at", 1, code=0)
        self.assertRegex(why.out, r"rule hero\*propose in hero.soar:\d+ failed to parse: .")
        unknown = Run("why", self.folder, "dance", "--agent", "hero", "--at", 1)
        self.assertIn("no rule that loaded gives or proposes 'dance'", unknown.err)

    def test_do_not_say_that_an_operator_is_not_proposed_if_it_was_prohibited(self):
        reasons = self.gap("""
sp {hero*propose (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*never (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> ~)}""" + self.GO)[0]["reasons"]
        self.assertRegex(reasons[0], r"^no operator is selected in S1: the only operator proposed was dropped: "
                                     r"rule hero\*never prohibits go \(O\d+\)$")

    def test_are_the_same_live_and_simulated_again_from_a_recording(self):
        self.write("hero.soar", """
sp {hero*go (state <s> ^superstate nil ^x yes) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {hero*a (state <s> ^superstate nil ^y yes) --> (<s> ^x yes)}
sp {hero*b (state <s> ^superstate nil ^x yes) --> (<s> ^y yes)}
sp {hero*calm (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^danger no)}
sp {hero*run (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name run)}""" + self.GO)
        self.write("scenario.toml", WORLD)
        recording = self.folder / "run.soarbox"
        Run("run", self.folder, "--headless", "--seconds", 2, "--record", recording, code=0)
        for topic in ("go", "hero*run", "hero*calm"):
            view = ("--agent", "hero", "--at", 1, "--view", f"why {topic}")
            live, again = Run("inspect", self.folder, *view), Run("inspect", recording, *view)
            self.assertEqual((live.code, again.code), (0, 0), live.err + again.err)
            self.assertEqual(live.out, again.out)
        self.assertIn("no rule makes it; rule hero*calm makes ^danger no",
                      Run("inspect", recording, "--agent", "hero", "--at", 1, "--view", "why hero*run").out)

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
        run = Run("why", self.write("scout.soar", SCOUT), "--agent", "scout", "--at", 2, code=0)
        for piece in ("scout at 2.0", "command move-to ^waypoint", "under way", "given by rule scout*apply*move-to",
                      "operator move-to", "by rule scout*propose*move-to", "^waypoint W", "^path (^status moving"):
            self.assertIn(piece, run.out)

    def test_tells_of_a_command_an_operator_or_a_rule_why_it_comes_about_or_does_not(self):
        rules = self.write("hero.soar", """
sp {hero*danger (state <s> ^superstate nil ^io.input-link.self.health < 50) --> (<s> ^danger yes)}
sp {hero*propose*run (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name run)}
sp {hero*propose*stroll (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name stroll)}
sp {hero*apply*run (state <s> ^operator.name run ^io.output-link <out>) --> (<out> ^flee <c>)}
sp {hero*apply*stroll (state <s> ^operator.name stroll ^io.output-link <out>) --> (<out> ^wander <c>)}""")
        for topic, tree in (
            ("flee", ["  command flee was never given",
                      "  rule hero*apply*run gives it when it applies an operator",
                      "    operator run is not proposed now; stroll is selected",
                      "      rule hero*propose*run requires ^danger yes, but there is none now; rule hero*danger makes it",
                      "        rule hero*danger requires ^io.input-link.self.health < 50, but it is 100"]),
            ("run", ["  operator run is not proposed now; stroll is selected",
                     "    rule hero*propose*run requires ^danger yes, but there is none now; rule hero*danger makes it",
                     "      rule hero*danger requires ^io.input-link.self.health < 50, but it is 100"]),
            ("hero*danger", ["  rule hero*danger requires ^io.input-link.self.health < 50, but it is 100"]),
        ):
            run = Run("why", rules, topic, "--at", 2)
            self.assertEqual((run.code, run.out.splitlines()[1:]), (0, tree), run.err)
        happens = Run("why", rules, "wander", "--at", 2)
        for piece in ("  command wander", "rule hero*apply*stroll", "rule hero*propose*stroll"):
            self.assertIn(piece, happens.out)
        unknown = Run("why", rules, "flea", "--at", 2, code=3)
        self.assertIn("did you mean flee?", unknown.err)

    def test_suggests_the_agent_that_was_meant(self):
        run = Run("why", self.write("scout.soar", SCOUT), "--agent", "scuot", code=3)
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
                                 ("d.toml", '[[agent]]\nrules = "nowhere.soar"\n', 2)):
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

    def test_finds_names_in_lua_that_are_nearly_those_of_functions(self):
        code, problems = self.check("Body.lua", """-- agent:SetPositon in a comment is none
function Agent_Updat(agent)
    agent:SetPositon(Vector.new(0, 0, 0));
    Sandbox.CreateSoarAgnet(agent:GetSandbox(), {});
    print("Agent.SetPositon(agent)");
end
""")
        self.assertEqual(code, 1)
        self.assertEqual([(problem["line"], problem["column"], problem["hint"]) for problem in problems],
                         [(2, 10, "did you mean Agent_Update?"), (3, 11, "did you mean SetPosition?"),
                          (4, 13, "did you mean CreateSoarAgent?")])

    def test_finds_faults_of_scenario_files_at_their_lines(self):
        code, problems = self.check("scenario.toml", """
[[agent]]
name = "a"
heading = "north"

[[agent]]
body = "soldir"

[[obstacle]]
shape = "sphere"

[[goal]]
agent = "a"
region = "y"
""")
        self.assertEqual(code, 1)
        self.assertEqual({(problem["line"], problem["message"], problem.get("hint", "")) for problem in problems}, {
            (4, "the option 'heading' takes degrees", ""), (7, "there is no body 'soldir'", "did you mean 'soldier'?"),
            (10, 'an obstacle\'s shape is "box" or "column"', ""), (14, "there is no region 'y'", "")})
        for text, hint in (("[[agent]]\nname = scout\n", 'put text between quotes: name = "scout"'),
                           ('description = "x\n', "no closing quote"), ('seed = 1\nseed = 2\n', "may occur once")):
            code, problems = self.check("scenario.toml", text)
            self.assertIn(hint, problems[0]["hint"])

    def test_names_files_that_are_not_there(self):
        (self.folder / "hero.soar").write_text("# no rules yet\n", encoding="utf-8")
        code, problems = self.check("yard.toml", '[[agent]]\nname = "a"\nrules = "heros.soar"\n')
        self.assertEqual(code, 1)
        self.assertEqual([(problem["message"], problem["hint"]) for problem in problems],
                         [("there are no rules 'heros.soar' beside this scenario", "did you mean 'hero.soar'?")])
        self.assertEqual(Run("check", self.folder / "no.soar").code, 1)
