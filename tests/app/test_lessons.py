# SPDX-License-Identifier: BSD-2-Clause
"""The lessons of docs/lessons run, and show what their pages say."""
import pathlib
import re
import unittest

from soarbox_command import Run, run_json

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
LESSONS = REPOSITORY / "docs" / "lessons"


class Lessons(unittest.TestCase):
    def texts(self, lesson, agent, *arguments):
        run = run_json(LESSONS / lesson, *arguments)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(run.of("gap"), [], "nobody stands idle")
        return [event["text"] for event in run.of("log", agent=agent)]

    def test_1_the_guard_tells_of_the_visitor_each_time_it_comes_near(self):
        texts = self.texts("1-a-rule", "guard")
        self.assertEqual(set(texts), {"I see visitor"})
        self.assertGreaterEqual(len(texts), 2)

    def test_2_the_stroller_decides_once_and_goes_on(self):
        self.assertEqual(self.texts("2-operators", "stroller"), ["I stroll"])

    def test_3_the_gold_is_always_preferred(self):
        for seed in (1, 2, 3):
            texts = self.texts("3-choices", "runner", "--seed", seed)
            self.assertGreaterEqual(len(texts), 3)
            # Whoever stands at the gold cannot go there: each second way leads to it.
            self.assertEqual(set(texts[::2]), {"to gold"}, texts)
            self.assertTrue(set(texts[1::2]) <= {"to silver", "to bronze"}, texts)

    def test_4_the_watchman_keeps_the_order(self):
        texts = self.texts("4-memory", "watchman")
        order = [f"{name}: all is well" for name in ("tower", "bridge", "gate")]
        self.assertGreaterEqual(len(texts), 4)
        self.assertEqual(texts, [order[i % 3] for i in range(len(texts))])

    def test_5_the_climber_learns_that_the_hut_is_closed(self):
        run = run_json(LESSONS / "5-answers")
        texts = [event["text"] for event in run.of("log", agent="climber")]
        self.assertEqual(texts, ["to the hut", "no way to the hut: no-way", "to the well"])
        self.assertTrue(run.of("outcome", command="move-to", text="complete"))
        failed = run.of("outcome", command="move-to", text="error no-way: There is no way to the place")
        self.assertLess(failed[0]["time"], 2, "told before walking there")

    def test_6_the_sheep_flees_in_time_and_grazes_again(self):
        run = run_json(LESSONS / "6-danger", "--report", 0.2)
        texts = [event["text"] for event in run.of("log", agent="sheep")]
        self.assertEqual(texts[:3], ["grass", "a wolf!", "grass"], texts)
        for state in run.of("state"):
            (ax, _, az), (bx, _, bz) = (agent["position"] for agent in state["agents"])
            self.assertGreater((ax - bx) ** 2 + (az - bz) ** 2, 9)

    def test_7_the_cook_fetches_then_delivers(self):
        self.assertEqual(self.texts("7-parts", "cook"), ["fetch", "deliver", "enjoy it"])

    def test_their_files_are_free_of_slips_and_their_pages_show_rules_that_are_there(self):
        run = Run("check", LESSONS)
        self.assertEqual((run.code, run.out), (0, "0 errors, 0 warnings\n"))
        for page in sorted(LESSONS.glob("*/README.md")):
            rules = "\n".join(file.read_text(encoding="utf-8") for file in sorted(page.parent.glob("*.soar")))
            for block in re.findall(r"```\n(sp .*?)```", page.read_text(encoding="utf-8"), re.S):
                for line in block.splitlines():
                    if line.strip() not in ("...", "") and not line.rstrip().endswith("...)"):
                        self.assertIn(line, rules, page)


if __name__ == "__main__":
    unittest.main()
