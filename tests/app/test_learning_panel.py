# SPDX-License-Identifier: BSD-2-Clause
"""Learned rules in the panel Learning and in `soarbox why`: live and in recordings, with real events."""
import json
import pathlib
import unittest

from png_picture import Picture
from soarbox_command import Run
from virtual_display import can_draw
from window_user import WindowUser

# Looks up the price of a pear in a substate. The learned rule gives the price of a fig without a substate.
SHOPPER = """
chunk always
sp {walker*init (state <s> ^superstate nil) --> (<s> ^tag <t1> ^tag <t2>)
   (<t1> ^fruit pear ^cents 40) (<t2> ^fruit fig ^cents 75)}
sp {walker*propose*pear (state <s> ^superstate nil ^tag.fruit pear -^cost) --> (<s> ^operator <o> +) (<o> ^name price ^fruit pear)}
sp {walker*propose*fig (state <s> ^superstate nil ^cost 40 -^cost 75)
   --> (<s> ^operator <o> +) (<o> ^name price ^fruit fig)}
sp {walker*propose*rest (state <s> ^superstate nil ^cost 75) --> (<s> ^operator <o> +) (<o> ^name rest)}
sp {walker*price*copy (state <ss> ^superstate <s>) (<s> ^operator <o>) (<o> ^name price ^fruit <f>) --> (<ss> ^wanted <f>)}
sp {walker*price*look (state <ss> ^superstate <s> ^wanted <f>) (<s> ^operator.name price ^tag <t>)
   (<t> ^fruit <f> ^cents <c>) --> (<s> ^cost <c>)}
"""


def views(scenario, view, seconds, agent="learner"):
    """The output of `soarbox inspect` for the agent, as text and as JSON."""
    text = Run("inspect", scenario, "--agent", agent, "--at", seconds, "--view", view)
    return text.out, json.loads(Run("inspect", scenario, "--agent", agent, "--at", seconds, "--view", view, "--json").out)


def every(node):
    """A reason and all reasons below it."""
    yield node
    for below in node.get("below", []):
        yield from every(below)


class WhatIsLearned(unittest.TestCase):
    def test_rules_of_the_town_lead_back_to_their_substates(self):
        text, told = views("soar_town", "learning", 90)
        rules = told["rules"]
        self.assertGreaterEqual(len(rules), 2, text)
        for rule in rules:
            self.assertIn("substate" if "substate" in rule["source"] else " in S", rule["source"])
            self.assertTrue(rule["purpose"], rule)
            self.assertGreater(rule["tick"], 0)
        self.assertGreater(sum(rule["firings"] for rule in rules), 0, "what was learned is used")
        first = rules[-1]["rule"]
        why_text = Run("why", "soar_town", first, "--agent", "learner", "--at", 90).out
        self.assertIn("why each condition is there", why_text)
        why = json.loads(Run("why", "soar_town", first, "--agent", "learner", "--at", 90, "--json").out)
        self.assertEqual((why["kind"], why["link"]), ("learned", first))
        kinds = {node["kind"] for node in every(why)}
        self.assertLessEqual({"condition", "rule", "element"}, kinds)
        self.assertTrue(any("firing" in node["text"] for node in every(why)))

    def test_numbers_and_episodes_of_the_courier_are_told(self):
        text, told = views("soar_reward", "learning", 420)
        self.assertTrue(told["by_reward"])
        self.assertGreaterEqual(len(told["episodes"]), 2, text)
        self.assertIn("episode 1: reward ", text)
        total = sum(episode["reward"] for episode in told["episodes"])
        self.assertLess(total, told["total_reward"] + 1000)
        self.assertTrue(any(number["updates"] > 0 for number in told["numbers"]))


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class LearningInTheWindow(WindowUser):
    def test_a_learned_rule_is_told_live_and_of_a_recording(self):
        (self.folder / "walker.soar").write_text(SHOPPER, encoding="utf-8")
        file = self.folder / "learned.soarrec"
        self.play("""
            until 1
            key P
            expect "Paused"
            key Alt+N
            expect "Rules 1"
            expect "makes ^cost"
            audit "learned rules"
            picture rules.png
            click "chunk*walker"
            expect "why each condition is there"
            expect "Fired since"
            audit "a learned rule"
            picture rule.png
            click "Close"
            expect-not "why each condition is there"
            click "Values 0"
            expect "No rule learns by reward."
            click "Episodes 0"
            expect "No episode has ended yet."
            click "Rules 1"
            click "Filter by text"
            type "mortar"
            expect "No learned rule has this text."
            key Escape
            click "Why"
            click "Why not ..."
            type "rest"
            key Return
            expect "cost 75"
            expect "learned in decision"
            click "idler"
            expect "No rule has been learned yet."
            """, record=f"--record={file}")
        for name in ("rules.png", "rule.png"):
            picture = Picture(self.folder / name)
            colours = {picture.at(x, y) for x in range(10, 900, 3) for y in range(530, 700, 3)}
            self.assertGreater(len(colours), 12, name)
        self.replay(file, """
            until 0.9
            key P
            expect "Paused"
            click "walker"
            key Alt+N
            expect "Rules 1"
            click "chunk*walker"
            expect "why each condition is there"
            """)

    def test_what_the_scenarios_learn_is_drawn_from_their_recordings(self):
        for scenario, seconds, script in (
                ("soar_town", 60, """
                    expect "makes go best"
                    audit "rules of the town"
                    picture town.png
                    click "chunk"
                    expect "why each condition is there"
                    audit "a rule of the town"
                    """),
                ("soar_reward", 420, """
                    click "Values "
                    expect "rl*courier*value*"
                    audit "values of the courier"
                    picture values.png
                    click "Episodes "
                    expect "Took"
                    audit "episodes of the courier"
                    picture episodes.png
                    """)):
            with self.subTest(scenario):
                file = self.folder / f"{scenario}.soarrec"
                Run("run", scenario, "--headless", "--seconds", seconds, "--record", file, "--record-level", "decisions",
                    code=0)
                self.replay(file, """
                    until 0.2
                    key P
                    expect "Paused"
                    click "learner"
                    click-at 860 704
                    key Alt+N
                    """ + script)
        for name in ("town.png", "values.png", "episodes.png"):
            self.assertTrue(pathlib.Path(self.folder / name).exists(), name)
