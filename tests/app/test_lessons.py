# SPDX-License-Identifier: BSD-2-Clause
"""The lessons of docs/lessons run as their pages describe: each sentence about the behaviour has a test."""
import json
import math
import pathlib
import re
import shutil
import subprocess

from soarbox_command import COMMAND, Run, ScenarioCase, run_json

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
LESSONS = REPOSITORY / "docs" / "lessons"


def written(run, agent):
    return [event["text"] for event in run.of("log", agent=agent)]


def distances(run, one, other):
    """The distance between two agents in each report."""
    gaps = []
    for state in run.of("state"):
        places = {agent["name"]: agent["position"] for agent in state["agents"]}
        gaps.append(math.hypot(places[one][0] - places[other][0], places[one][2] - places[other][2]))
    return gaps


def session(rules, commands):
    """What `soarbox soar` prints for each command after these rules, without empty lines and the lines that count cycles."""
    done = subprocess.run([COMMAND, "soar", "--json"], input="\n".join([rules, *commands, ""]), text=True, capture_output=True,
                          timeout=60, check=False)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    told = ""
    for command, answer in zip(commands, answers[len(answers) - len(commands):], strict=True):
        told += f"> {command}\n"
        for line in (answer.get("printed", "") + "\n" + answer.get("text", "")).splitlines():
            if line.strip() and not line.startswith("--> "):
                told += line.rstrip() + "\n"
    return told


class LessonCase(ScenarioCase):
    def run_lesson(self, lesson, *arguments):
        run = run_json(LESSONS / lesson, *arguments, code=0)
        self.assertEqual(run.of("gap"), [], "nobody stands idle")
        self.assertEqual(run.diagnostics(), [])
        return run

    def changed(self, lesson, file, *changes):
        """A copy of a lesson in which pieces of text were replaced."""
        copy = self.folder / lesson
        if not copy.exists():
            shutil.copytree(LESSONS / lesson, copy)
        text = (copy / file).read_text(encoding="utf-8")
        for old, new in changes:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        (copy / file).write_text(text, encoding="utf-8")
        return copy

    def without_rule(self, lesson, file, rule):
        text = (LESSONS / lesson / file).read_text(encoding="utf-8")
        whole = re.search(r"^sp \{" + re.escape(rule) + r"\n.*?^\}\n", text, re.M | re.S)
        self.assertTrue(whole, rule)
        return self.changed(lesson, file, (whole.group(), ""))


class Rule(LessonCase):
    LESSON = "1-a-rule"

    def test_it_fires_once_each_time_the_visitor_comes_into_view(self):
        run = self.run_lesson(self.LESSON, "--report", 0.1)
        gaps = distances(run, "guard", "visitor")
        visits = sum(before > 8 >= after for before, after in zip(gaps, gaps[1:]))
        self.assertGreaterEqual(visits, 2)
        self.assertEqual(written(run, "guard"), ["I see visitor"] * visits)

    def test_the_guard_decides_once(self):
        self.assertEqual(len(self.run_lesson(self.LESSON).of("command", agent="guard")), 1)

    def test_with_a_range_it_speaks_many_times_and_a_warning_says_why(self):
        lesson = self.changed(self.LESSON, "guard.soar", ("^visible yes", "^range < 6"))
        run = run_json(lesson)
        self.assertGreater(len(written(run, "guard")), 30)
        said = "rule guard*notice writes again at each change of ^range, which changes all the time"
        self.assertEqual([problem["message"] for problem in run.diagnostics()], [said])
        check = Run("check", lesson)
        self.assertIn(f"guard.soar:4:23: warning: {said}\n", check.out)

    def test_a_misspelt_attribute_gets_its_suggestion_everywhere(self):
        lesson = self.changed(self.LESSON, "guard.soar", ("^visible yes", "^visibel yes"))
        run = run_json(lesson)
        self.assertEqual(written(run, "guard"), [])
        self.assertEqual([problem["hint"] for problem in run.diagnostics()], ["did you mean ^visible?"])
        self.assertIn("guard.soar:4:23: warning: rule guard*notice tests ^visibel, which no percept and no rule makes",
                      Run("run", lesson, "--headless", "--seconds", 1).err)
        self.assertIn("did you mean ^visible?", Run("check", lesson).out)


class Operators(LessonCase):
    LESSON = "2-operators"

    def test_the_stroller_decides_once_and_goes_on(self):
        run = self.run_lesson(self.LESSON, "--report", 1)
        self.assertEqual(written(run, "stroller"), ["I stroll"])
        places = [state["agents"][0]["position"] for state in run.of("state")]
        self.assertGreater(sum(math.dist(a, b) for a, b in zip(places, places[1:])), 10)

    def test_without_the_second_rule_the_console_names_the_operator(self):
        run = Run("run", self.without_rule(self.LESSON, "stroller.soar", "stroller*apply*wander"), "--headless", "--seconds", 3)
        self.assertIn("operator wander is selected in S1 and no rule applies it", run.out + run.err)

    def test_why_tells_of_both_rules(self):
        run = Run("why", LESSONS / self.LESSON, "wander")
        self.assertIn("stroller*propose*wander", run.out)
        self.assertIn("stroller*apply*wander", run.out)


class Choices(LessonCase):
    LESSON = "3-choices"

    def test_the_gold_comes_first_and_every_second_way_leads_to_it(self):
        for seed in (1, 2, 3):
            texts = written(self.run_lesson(self.LESSON, "--seed", seed), "runner")
            self.assertTrue(3 <= len(texts) <= 12, texts)
            self.assertEqual(set(texts[::2]), {"to gold"}, texts)
            self.assertTrue(set(texts[1::2]) <= {"to silver", "to bronze"}, texts)

    def test_it_does_not_change_its_mind_halfway(self):
        run = self.run_lesson(self.LESSON)
        outcomes = [event["text"] for event in run.of("outcome", command="move-to")]
        self.assertEqual(set(outcomes), {"complete"})

    def test_without_indifference_the_operators_tie_and_are_named(self):
        run = run_json(self.changed(self.LESSON, "runner.soar", ("^operator <o> + =)", "^operator <o> +)")))
        self.assertEqual(written(run, "runner"), ["to gold"])
        reasons = run.of("gap")[0]["reasons"]
        self.assertEqual(reasons[0], "operator tie in S1: no preference decides among 2 go operators")
        self.assertEqual(sorted(reasons[1:3]), ["go ^where bronze is proposed by rule runner*propose*go",
                                                "go ^where silver is proposed by rule runner*propose*go"])

    def test_without_the_preference_chance_decides_and_the_seed_decides_about_chance(self):
        lesson = self.without_rule(self.LESSON, "runner.soar", "runner*prefer*gold")
        ways = {seed: tuple(written(run_json(lesson, "--seed", seed), "runner")) for seed in range(1, 6)}
        self.assertGreater(len(set(ways.values())), 1)
        self.assertEqual(ways[1], tuple(written(run_json(lesson, "--seed", 1), "runner")))


class Memory(LessonCase):
    LESSON = "4-memory"

    def test_the_watchman_keeps_the_order(self):
        texts = written(self.run_lesson(self.LESSON), "watchman")
        order = [f"{name}: all is well" for name in ("tower", "bridge", "gate")]
        self.assertGreaterEqual(len(texts), 4)
        self.assertEqual(texts, [order[i % 3] for i in range(len(texts))])

    def test_it_remembers_whose_turn_it_is(self):
        look = self.write("look.txt", "200 command watchman print s1\n")
        run = Run("run", LESSONS / self.LESSON, "--headless", "--input", look, "--seconds", 11)
        self.assertIn("^next 2", run.out)


class Answers(LessonCase):
    LESSON = "5-answers"

    def test_the_climber_learns_that_the_hut_is_closed(self):
        run = self.run_lesson(self.LESSON)
        self.assertEqual(written(run, "climber"),
                         ["to the hut", "no way to the hut: no-way", "to the well", "rest at the well"])
        failed = run.of("outcome", command="move-to", text="error no-way: There is no way to the place")
        self.assertLess(failed[0]["time"], 2, "at once")

    def test_through_an_open_fence_it_reaches_the_hut_and_rests_there(self):
        lesson = self.changed(self.LESSON, "scenario.toml", ("[4, 8]", "[8, 8]"))
        run = run_json(lesson)
        self.assertEqual(written(run, "climber"), ["to the hut", "rest at the hut"])
        self.assertEqual(run.of("gap"), [])


class Danger(LessonCase):
    LESSON = "6-danger"

    def test_the_sheep_flees_in_time_and_grazes_again(self):
        run = self.run_lesson(self.LESSON, "--report", 0.2)
        texts = written(run, "sheep")
        self.assertEqual(texts[:3], ["grass", "a wolf!", "grass"], texts)
        self.assertGreater(min(distances(run, "sheep", "wolf")), 3)

    def test_why_follows_the_command_back_to_what_the_sheep_sees(self):
        run = Run("why", LESSONS / self.LESSON, "flee", "--agent", "sheep", "--at", 5.6, code=0)
        for piece in ("sheep*apply*flee", "sheep*propose*flee", "^danger wolf"):
            self.assertIn(piece, run.out)


class Parts(LessonCase):
    LESSON = "7-parts"

    def test_the_cook_fetches_then_delivers(self):
        self.assertEqual(written(self.run_lesson(self.LESSON), "cook"), ["fetch", "deliver", "enjoy it"])

    def test_the_substate_is_there_while_it_serves_and_goes_away_then(self):
        look = self.write("look.txt", "60 command cook print --stack\n1190 command cook print --stack\n")
        run = run_json(LESSONS / self.LESSON, "--input", look)
        first, last = (event["text"] for event in run.of("answer"))
        self.assertIn("operator no-change", first)
        self.assertIn("(fetch)", first)
        self.assertIn("(rest)", last)
        self.assertNotIn("(serve)", last)
        self.assertNotIn("S2", last, "the substate of serve has gone")

    def test_without_fetch_the_console_says_what_is_missing_and_nothing_false(self):
        run = run_json(self.without_rule(self.LESSON, "cook.soar", "cook*serve*propose*fetch"), "--seconds", 3)
        reasons = run.of("gap")[0]["reasons"]
        self.assertIn("operator serve is selected in S1, and in the state below it no operator is proposed", reasons)
        self.assertIn("rule cook*serve*propose*deliver requires ^superstate.holds soup, but there is none now; "
                      "rule cook*serve*apply*fetch*done makes it when it applies fetch", reasons)
        self.assertFalse([reason for reason in reasons if "cook*serve*propose*deliver makes" in reason])


class Team(LessonCase):
    LESSON = "8-team"

    def test_the_leaders_give_one_order_each_and_a_team_wins(self):
        for seed in (1, 2):
            run = self.run_lesson(self.LESSON, "--seed", seed)
            orders = [event for event in run.of("news", news="says") if "^about order" in event["text"]]
            self.assertEqual({event["agent"] for event in orders}, {"blue-leader", "red-leader"})
            self.assertEqual(len(orders), 2)
            self.assertTrue(run.of("news", news="shoots"))
            self.assertEqual(len(run.of("reached")), 1)

    def test_before_the_order_the_others_stand_by(self):
        run = self.run_lesson(self.LESSON)
        first = {}
        for event in run.of("command"):
            first.setdefault(event["agent"], event["command"])
        self.assertEqual({name: first[name] for name in ("blue-1", "blue-2", "red-1", "red-2")},
                         dict.fromkeys(("blue-1", "blue-2", "red-1", "red-2"), "wait"))

    def test_who_reloads_falls_back_to_its_leader_with_the_rules_of_the_page(self):
        page = (LESSONS / self.LESSON / "README.md").read_text(encoding="utf-8")
        rules = "\n".join(line[4:] for line in page.splitlines() if line.startswith("    "))
        rules = rules[rules.index("sp {blue*propose"):rules.index("for seed")]
        lesson = self.changed(self.LESSON, "scenario.toml",
                              ('name = "blue"\nrules = "fighter.soar"', 'name = "blue"\nrules = "blue.soar"'))
        (lesson / "blue.soar").write_text((lesson / "fighter.soar").read_text(encoding="utf-8") + rules, encoding="utf-8")
        self.assertEqual(Run("check", lesson / "blue.soar").code, 0)
        fell_back = 0
        for seed in (1, 2, 3):
            run = run_json(lesson, "--seed", seed)
            self.assertEqual((run.code, run.of("gap")), (0, []), run.err)
            fell_back += len([event for event in run.of("command", command="move-to")
                              if "blue-leader" in event["parameters"]])
        self.assertGreater(fell_back, 0)


class Pages(LessonCase):
    def test_their_files_are_free_of_slips_and_their_pages_show_rules_that_are_there(self):
        run = Run("check", LESSONS)
        self.assertEqual((run.code, run.out), (0, "0 errors, 0 warnings\n"))
        for page in sorted(LESSONS.glob("*/README.md")):
            rules = "\n".join(file.read_text(encoding="utf-8") for file in sorted(page.parent.glob("*.soar")))
            for block in re.findall(r"```\n(sp .*?)```", page.read_text(encoding="utf-8"), re.S):
                for line in block.splitlines():
                    self.assertIn(line, rules, page)

    def test_what_grades_a_lesson_is_checked_too(self):
        graded = REPOSITORY / "lessons"
        for lesson in sorted(graded.iterdir()):
            self.assertNotIn("lesson.toml", Run("check", lesson).out)
        lesson = sorted(graded.iterdir())[0]
        shutil.copytree(lesson, self.folder / lesson.name)
        grades = self.folder / lesson.name / "lesson.toml"
        grades.write_text(grades.read_text(encoding="utf-8").replace("title =", "titel ="), encoding="utf-8")
        run = Run("check", self.folder / lesson.name, code=1)
        self.assertRegex(run.out, r"lesson\.toml:1:\d+: error: .*'titel'")
        grades.write_text(grades.read_text(encoding="utf-8").replace("titel =", "title =").replace('panel = "Memory"', 'panel = "Memroy"'), encoding="utf-8")
        run = Run("check", self.folder / lesson.name, code=1)
        self.assertRegex(run.out, r"lesson\.toml:4:\d+: error: there is no panel 'Memroy'\n +note: did you mean 'Memory'\?")

    def test_each_lesson_names_the_panels_in_which_it_is_to_be_seen(self):
        for page in sorted(LESSONS.glob("*/README.md")):
            text = page.read_text(encoding="utf-8")
            self.assertIn("In the window", text, page)
            self.assertRegex(text, r"\*(Mind|Why|Memory|Operators|Trace)\*", page)

    def test_soar_in_one_evening_has_rules_that_load_and_do_what_it_says(self):
        page = (REPOSITORY / "docs" / "soar_in_one_evening.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```soar\n(.*?)```", page, re.S)
        self.assertGreaterEqual(len(blocks), 7)
        for number, block in enumerate(blocks):
            check = Run("check", self.write(f"block{number}.soar", block), "--json")
            problems = [line for line in check.out.splitlines() if '"error"' in line or "all the time" in line]
            self.assertEqual(problems, [])

    def test_each_statement_of_soar_in_one_evening_is_shown_by_a_session_that_answers_as_printed(self):
        page = (REPOSITORY / "docs" / "soar_in_one_evening.md").read_text(encoding="utf-8")
        page += "".join(each.read_text(encoding="utf-8") for each in sorted(LESSONS.glob("*/README.md")))
        sessions = re.findall(r"```soar\n([^`]*)```\n```\n(> [^`]*)```", page)
        self.assertGreaterEqual(len(sessions), 24)
        for rules, printed in sessions:
            commands = [line[2:] for line in printed.splitlines() if line.startswith("> ")]
            self.assertEqual(printed, session(rules, commands), rules)

    def test_the_sessions_of_soar_in_one_evening_notice_another_answer(self):
        page = (REPOSITORY / "docs" / "soar_in_one_evening.md").read_text(encoding="utf-8")
        rules = next(block for block in re.findall(r"```soar\n([^`]*)```", page) if "sunbathe*warm" in block)
        commands = ["add-wme s1 ^sun yes", "run 3", "remove-wme 14", "run 1", "print --exact (s1 ^warm *)"]
        self.assertNotIn("(S1 ^warm yes)", session(rules, commands))
        kept = rules.replace("(<above> ^sun yes)", "(<above> ^sun yes ^operator.name sunbathe)")
        self.assertIn("(S1 ^warm yes)", session(kept, commands))


class OwnWorld(ScenarioCase):
    """The world that a learner writes. It is graded by the mistakes that its checks detect."""

    def setUp(self):
        super().setUp()
        self.assertEqual(Run("learn", "24", "--headless", "--folder", self.folder / "mine").code, 0)
        self.world = self.folder / "mine" / "24-own-world"
        page = (LESSONS / "24-own-world" / "README.md").read_text(encoding="utf-8")
        self.more = re.search(r"```toml\n(.*?)```", page, re.S)[1]
        self.dog = re.search(r"```soar\n(.*?)```", page, re.S)[1]

    def grade(self, more, dog):
        scenario = self.world / "scenario.toml"
        scenario.write_text(scenario.read_text(encoding="utf-8") + more, encoding="utf-8")
        if dog:
            (self.world / "dog.soar").write_text(dog, encoding="utf-8")
        run = Run("learn", "check", "24", "--folder", self.world.parent)
        return run.code, run.out

    def test_the_lesson_begins_with_what_soarbox_new_makes(self):
        self.assertEqual(Run("new", self.folder / "keeper").code, 0)
        for file in ("scenario.toml", "keeper.soar"):
            self.assertEqual((self.folder / "keeper" / file).read_text(), (self.world / file).read_text(), file)

    def test_the_world_of_the_page_passes_and_counts_as_passed(self):
        code, told = self.grade(self.more, self.dog)
        self.assertEqual(code, 0, told)
        self.assertRegex(Run("learn").out, r"done  24  Your own world")

    def test_what_soarbox_new_made_is_not_enough(self):
        code, told = self.grade("", "")
        self.assertEqual((code, told.count("  no   ")), (1, 3), told)

    def test_a_check_that_always_holds_notices_nothing(self):
        more = re.sub(r'near = .*?within = 2\n', "alive = true\nby = 50\n", self.more, flags=re.S)
        self.assertNotEqual(more, self.more)
        code, told = self.grade(more, self.dog)
        self.assertIn("no   dog.soar: 0 of 2 rules noticed", told)
        self.assertTrue(told.startswith("Your checks notice 0 of 2 rules of dog.soar"), told)
        self.assertEqual(code, 1)

    def test_a_dog_that_does_not_come_fails_its_own_check(self):
        code, told = self.grade(self.more, self.dog.replace("(<out> ^follow <command>)", "(<out> ^evade <command>)"))
        self.assertRegex(told, r"\AA check fails\. the dog comes along, seed \d")
        self.assertEqual(code, 1)

    def test_an_error_in_the_world_is_no_attempt(self):
        code, told = self.grade(self.more.replace("range = { max = 4 }", "rnage = { max = 4 }"), self.dog)
        self.assertRegex(told, r"scenario\.toml:\d+:\d+: error: .*rnage")
        self.assertIn("It does not count as an attempt", told)
        self.assertNotIn(str(self.folder), told)
        self.assertEqual(code, 1)

    def test_a_lesson_that_asks_for_the_impossible_is_refused(self):
        lesson = self.folder / "course" / "1-mine"
        shutil.copytree(REPOSITORY / "lessons" / "24-own-world", lesson)
        text = (lesson / "lesson.toml").read_text(encoding="utf-8")
        for old, new, told in (("agents = 2", "agents = 0", r"lesson\.toml:\d+.*'agents' is a whole number from 1 to 100"),
                               ("noticed = 0.5", "noticed = 5", "'noticed' is a share from 0 to 1"),
                               ("checks = 3", "cheks = 3", r"\[own\] has no 'cheks'"),
                               ("[own]", '[[check]]\nname = "x"\nagent = "keeper"\nalive = true\n\n[own]', "has no \\[\\[check"),):
            self.assertEqual(text.count(old), 1, old)
            (lesson / "lesson.toml").write_text(text.replace(old, new), encoding="utf-8")
            self.assertRegex(Run("learn", "--from", lesson.parent, code=3).err, told)
