# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox learn` and the lessons that come with the program, through the real command."""
import shutil
import signal
import subprocess
import tomllib

from mission_case import REPOSITORY, MissionCase
from soarbox_command import COMMAND, Run


LATER = 13  # The first lesson that test_later_lessons.py tests.


def tried_as_it_should(case, numbers, wrong):
    """Tests these lessons: starter, solution and wrong answers. There must be at least `wrong` wrong answers."""
    told = []
    for number in numbers:
        run = Run("learn", "test", number, code=0, limit_s=480)
        case.assertEqual(len({line.split("  ")[0] for line in run.out.splitlines()}), 1, "one lesson alone is tried")
        told += run.out.splitlines()
    case.assertEqual(sum("  solution: as it should" in line for line in told), len(numbers))
    case.assertGreaterEqual(sum("  wrong/" in line for line in told), wrong)


class Lessons(MissionCase):
    def test_starters_fail_solutions_pass_and_wrong_answers_get_their_own_hint(self):
        tried_as_it_should(self, range(1, LATER), wrong=50)

    def test_each_mistake_of_these_lessons_has_a_wrong_answer_that_makes_it(self):
        for name in ("04-memory", "06-danger", "07-parts", "09-support", "10-results", "13-imagine", "15-debugging", "16-hierarchy",
                     "17-dependencies", "18-knowledge", "19-episodes", "20-look-ahead", "21-delayed-reward", "22-overgeneral", "23-would-it-fit", "25-storing", "26-activation", "27-other-programs", "tanks/t8-mission"):
            lesson = REPOSITORY / "lessons" / name
            mistakes = {each["name"] for each in tomllib.loads((lesson / "lesson.toml").read_text(encoding="utf-8"))["mistake"]}
            self.assertEqual(mistakes, {file.read_text(encoding="utf-8").strip() for file in lesson.glob("wrong/*/expects")}, name)

    def test_each_panel_of_the_window_is_introduced_by_a_lesson(self):
        page = (REPOSITORY / "docs" / "window.md").read_text(encoding="utf-8")
        table = page.split("## The panels")[1].split("\n\n")[1]
        panels = {line.split("|")[1].strip() for line in table.splitlines()[2:]}
        panels -= {"Exercise", "Script"}  # Exercises have the first; the second is about scripts, and lessons teach Soar.
        lessons = [tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted((REPOSITORY / "lessons").glob("*/lesson.toml"))]
        first = [lesson["panel"] for lesson in lessons]
        self.assertEqual(len(set(first)), 16, first)
        self.assertEqual(set(first).union(*(lesson.get("also", []) for lesson in lessons)), panels)

    def test_a_wrong_answer_that_nobody_foresaw_is_explained_from_its_run(self):
        lesson = REPOSITORY / "lessons" / "01-a-rule"
        right = (lesson / "solution" / "porter.soar").read_text(encoding="utf-8")
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        for old, new, told in (
                ("^visible yes", "^visible true", r"rule porter\*greet never fired: it requires \^.*visible true"),
                ("^visible yes", "^visibel yes", r"did you mean \^visible\?"),
                ("|Good day, | <name>", "|Good day,| <name>", 'It printed "Good day,anna"'),
                ("<name> (crlf)", "<a> (crlf)", "That is the identifier of the percept")):
            self.assertEqual(right.count(old), 1)
            (mine / "01-a-rule" / "porter.soar").write_text(right.replace(old, new), encoding="utf-8")
            run = Run("learn", "check", "1", "--folder", mine, code=1)
            self.assertRegex(run.out, told)

    def test_the_headline_comes_first_and_names_no_folder(self):
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        rules = mine / "01-a-rule" / "porter.soar"
        starter = rules.read_text(encoding="utf-8")
        rules.write_text(starter + "\nsp {broken (state <s> ^name) -- (write a)}\n", encoding="utf-8")
        run = Run("learn", "check", "1", "--folder", mine, code=1)
        self.assertRegex(run.out, r"\Aporter\.soar:\d+:\d+: error: ")
        self.assertNotIn(str(self.folder), run.out)

    def test_a_course_or_a_word_that_is_nearly_named_is_suggested(self):
        for words, meant in ((["eater"], "eaters"), (["eater", "1"], "eaters 1"), (["chek", "1"], "check 1"),
                             (["tanks", "hnt", "2"], "tanks hint 2")):
            run = Run("learn", *words, code=3)
            self.assertIn(f"did you mean soarbox learn {meant}?", run.err + run.out)

    def test_the_commands_that_it_prints_name_the_folder(self):
        mine = self.folder / "my lessons"
        begun = Run("learn", "1", "--headless", "--folder", mine, code=0).out
        self.assertIn(f'Grade: soarbox learn check 1 --folder "{mine}"\n', begun)
        self.assertIn(f'Stuck: soarbox learn hint 1 --folder "{mine}"\n', begun)
        refused = Run("learn", "check", "2", "--folder", mine, code=3)
        self.assertIn(f'soarbox learn 02-operators --folder "{mine}" puts its files there', refused.out + refused.err)

    def test_the_list_says_what_other_courses_are_about(self):
        listed = Run("learn", code=0).out
        for course in ("eaters", "guide", "tanks"):
            self.assertRegex(listed, rf"soarbox learn {course} lists another course: \w")

    def test_rules_without_end_end_their_seeds_and_are_the_headline(self):
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "4", "--headless", "--folder", mine).code, 0)
        rules = mine / "04-memory" / "watchman.soar"
        rules.write_text(rules.read_text(encoding="utf-8") + "\nsp {watchman*count\n   (state <s> ^superstate nil ^next { <n> < 1000000 })\n-->\n"
                         "   (<s> ^next <n> - (+ <n> 1))\n}\n", encoding="utf-8")
        run = Run("learn", "check", "4", "--folder", mine, code=1)
        self.assertRegex(run.out.split("\n\n")[0], r"watchman\.soar:\d+: .*watchman\*count")
        self.assertIn("rules fire again and again in one phase", run.out)
        self.assertNotIn("  yes  ", run.out, "of a run that was ended, nothing is judged")

    def test_grading_tells_progress_and_can_be_cancelled(self):
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        run = Run("learn", "check", "1", "--folder", mine, "--progress", code=1)
        self.assertEqual(run.out.splitlines()[:10], [f"seed {i} of 10" for i in range(1, 11)])
        attempts = Run("learn", "--json").out.splitlines()[0]
        grading = subprocess.Popen([COMMAND, "learn", "check", "1", "--folder", mine, "--progress"], stdout=subprocess.PIPE, text=True)
        self.assertEqual(grading.stdout.readline(), "seed 1 of 10\n")
        grading.send_signal(signal.SIGINT)
        rest = grading.communicate()[0]
        self.assertTrue(rest.endswith("Grading was cancelled. There is no verdict.\n"), rest)
        self.assertEqual(grading.returncode, 130)
        self.assertEqual(Run("learn", "--json").out.splitlines()[0], attempts, "it does not count")

    def test_what_a_learner_wrote_stays(self):
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        rules = mine / "01-a-rule" / "porter.soar"
        run = Run("learn", "check", "1", "--folder", mine, code=1)
        shutil.copy(REPOSITORY / "lessons" / "01-a-rule" / "solution" / "porter.soar", rules)
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        self.assertIn("^visible yes", rules.read_text(encoding="utf-8"), "nothing is overwritten")
        run = Run("learn", "check", "1", "--folder", mine, code=0)
        self.assertRegex(Run("learn").out, r"done   1  ")
        rules.write_text("sp {broken", encoding="utf-8")
        run = Run("learn", "check", "1", "--folder", mine, code=1)
        self.assertIn("does not count", run.out)
        self.assertEqual(Run("learn", "reset", "1", "--folder", mine).code, 0)
        self.assertTrue((mine / "01-a-rule.2" / "porter.soar").exists())
        self.assertIn("1. ", Run("learn", "hint", "1", "--folder", mine).out)
        progress = self.folder / "state" / "soarbox" / "learn" / "progress.json"
        progress.write_text("{ damaged", encoding="utf-8")
        self.assertEqual(Run("learn").code, 0)
        self.assertTrue(progress.with_name("progress.json.damaged").exists())
