# SPDX-License-Identifier: BSD-2-Clause
"""Mistakes in a file of rules that is edited while the world runs: each is reported with its place and a hint, and
the previous version keeps running."""
import os
import time

from test_live_edits import COUNT, LiveEditCase

TELL = "sp {hero*tell"
LOOP = "sp {hero*again (state <s> ^superstate nil ^n <n>) --> (<s> ^n (+ <n> 1))}\n"
KEEPS = "the previous version keeps running"

# The edited text, and parts of the message. The old rules count until the end.
SLIPS = {
    "a bracket is gone": (COUNT.replace("nil ^heard <n>) --> (write", "nil ^heard <n> --> (write"),
                          ("hero.soar:6:", "found '-->'", "still open", KEEPS)),
    "sp is gone": (COUNT.replace(TELL, "{hero*tell"), ("hero.soar:6:1: error: expected sp { here", KEEPS)),
    "sp is misspelt": (COUNT.replace(TELL, "ps {hero*tell"), ("hero.soar:6:1: error: expected sp { here, found 'ps'", KEEPS)),
    "the name is gone": (COUNT.replace(TELL, "sp {"), ("hero.soar:6:", "expected the rule's name", "give it one", KEEPS)),
    "a comment of another language": (COUNT + "// the end\n", ("hero.soar:7:1: error:", "comments start with #", KEEPS)),
    "a variable that nothing binds": (COUNT.replace("(<s> ^heard 0)", "(<state> ^heard 0)"),
                                      ("hero.soar:3:", "no condition binds <state>", KEEPS)),
    "the file is empty": ("", ("hero.soar: warning: this file is empty: nothing was changed", KEEPS, "leave a comment in it")),
    "a file that is not there is sourced": (COUNT + "source nowhere.soar\n", ("hero.soar:7:", "Failed to open file", "relative", KEEPS)),
    "it sources itself": (COUNT + "source hero.soar\n", ("hero.soar:7: warning: this file sources itself", "remove this line")),
    "a setting among the rules": (COUNT + "chunk always\n", ("hero.soar:7: warning: the command chunk always is not carried out",
                                                             "Ctrl+R")),
    "an attribute is misspelt": (COUNT + "sp {hero*late (state <s> ^superstate nil ^io.input-link.tiem <t>) --> (<s> ^late yes)}\n",
                                 ("hero.soar:7:", "tests ^tiem, which no percept and no rule makes", "did you mean ^time?")),
    "a rule fires for ever": (COUNT + LOOP, ("hero.soar:7:", "fires again for each new value, without end", "(<s> ^n <n> -)")),
    "two rules of one name": (COUNT + LOOP.replace("again", "tell").replace("(+ <n> 1)", "5"),
                              ("hero.soar:7:5: warning: rule hero*tell replaces the rule of the same name in line 6", "its own name")),
    "it is UTF-16": (COUNT.encode("utf-16"), ("hero.soar", "UTF-16", KEEPS)),
}
# These edits replace the rule that prints, so its output ends.
REPLACES = ("two rules of one name",)


class LiveMistakes(LiveEditCase):
    def test_are_told_with_their_place_and_what_to_do_and_the_old_rules_go_on(self):
        for name, (text, said) in SLIPS.items():
            with self.subTest(name):
                def edit(text=text):
                    (self.folder / "hero.soar").write_bytes(text if isinstance(text, bytes) else text.encode())
                texts, err, _ = self.run_and_edit(edit, until=lambda err, said=said: all(sentence in err for sentence in said))
                for sentence in said:
                    self.assertIn(sentence, err)
                old = [int(line.split()[1]) for line in texts if line.startswith("old ")]
                self.assertEqual(old, sorted(old), "it begins anew")
                if name not in REPLACES:
                    self.assertGreater(old[-1], 40, "the old rules go on to the end")

    def test_another_name_for_the_file_takes_no_rule_away(self):
        texts, err, _ = self.run_and_edit(lambda: os.rename(self.folder / "hero.soar", self.folder / "heroine.soar"))
        self.assertEqual(err.count(f"hero.soar: warning: this file is gone\n   note: {KEEPS}\n"), 1, err)
        self.assertGreater(int(texts[-1].split()[1]), 40)

    def test_what_another_system_does_to_a_text_is_no_edit(self):
        """A byte order mark in front of the first rule, and line ends of Windows."""
        def edit():
            (self.folder / "hero.soar").write_bytes(b"\xef\xbb\xbf" + COUNT.strip().replace("\n", "\r\n").encode() + b"\r\n")
        # There is no message: the run continues until the time-out.
        texts, err, _ = self.run_and_edit(edit, COUNT.strip() + "\n", until=lambda _: True, goes_on=150)
        self.assertNotIn("error", err)
        counted = [int(line.split()[1]) for line in texts]
        self.assertEqual(counted, sorted(set(counted)), "no rule was taken out and loaded again")
        self.assertGreater(counted[-1], 40)

    def test_an_editor_that_writes_in_two_steps_takes_nothing_away(self):
        def edit():
            for _ in range(6):
                self.write("hero.soar", "")
                time.sleep(0.02)
                self.write("hero.soar", COUNT.split(TELL)[0])
                time.sleep(0.03)
                self.write("hero.soar", COUNT.replace("|old |", "|new |"))
                time.sleep(0.06)
        texts, err, _ = self.run_and_edit(edit)
        self.assertNotIn("empty", err)
        counted = [int(line.split()[1]) for line in texts]
        self.assertTrue(texts[0].startswith("old") and texts[-1].startswith("new"), texts)
        self.assertEqual(sorted(counted), counted)

    def test_a_file_that_is_sourced_now_is_loaded_and_one_that_is_not_any_more_goes(self):
        rules = COUNT.split(TELL)
        self.write("tell.soar", TELL + rules[1].replace("|old |", "|new |"))
        texts, err, _ = self.run_and_edit(lambda: self.write("hero.soar", COUNT.replace("hero*tell", "hero*said") + "source tell.soar\n"))
        self.assertIn("tell.soar: note: reloaded", err)
        self.assertTrue(any(line.startswith("new ") for line in texts) and texts[-1].split()[0] in ("old", "new"), texts)
        texts, err, _ = self.run_and_edit(lambda: self.write("hero.soar", rules[0]), rules[0] + "source tell.soar\n")
        self.assertIn("tell.soar: note: no longer sourced: its rules are excised", err)
        self.assertTrue(1 < self.last_tick < self.end_tick - self.GOES_ON / 2, "nothing is told after the edit")

    def test_a_rule_that_moves_into_another_file_stays(self):
        rules = COUNT.split(TELL)

        def edit():
            self.write("tell.soar", "# nothing\n")
            self.write("hero.soar", COUNT + "source tell.soar\n")
        self.write("tell.soar", TELL + rules[1])
        texts, err, _ = self.run_and_edit(edit, rules[0] + "source tell.soar\n")
        self.assertNotIn("error", err)
        self.assertGreater(int(texts[-1].split()[1]), 40, err)
