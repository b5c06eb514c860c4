# SPDX-License-Identifier: BSD-2-Clause
"""What `soarbox check` says to the slips of those who write their first rules."""
import json
import unittest

from soarbox_command import Run, ScenarioCase

GOOD = """sp {hero*propose*go
   (state <s> ^superstate nil ^io.input-link.self <me>)
   (<me> ^health > 10)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {hero*apply*go
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name go)
-->
   (<out> ^wander <c>)
}
"""

# What is replaced by what, the line that is told, and what the message and its hint hold. Each file has one slip.
SLIPS = {
    "missing bracket at a condition's end": ("self <me>)", "self <me>", 4, "found '-->'", "( of line 2, column 4 is still open"),
    "missing arrow": ("-->\n", "", 6, "but the rule ends here", "write --> between"),
    "thin arrow": ("-->", "->", 4, "found '->'", "write --> between"),
    "double arrow": ("-->", "==>", 4, "found '==>'", "write --> between"),
    "missing caret": ("^health > 10", "health > 10", 3, "found 'health'", "did you mean ^health?"),
    "missing caret behind the state": ("<s> ^superstate", "<s> superstate", 2, "found 'superstate'", "did you mean ^superstate?"),
    "wrong variable in an action": ("(<o> ^name go)\n}", "(<op> ^name go)\n}", 6, "no condition binds <op>", "did you mean <o>?"),
    "wrong variable in a condition": ("(<me> ^health", "(<em> ^health", 3, "leads from the state to <em>", "did you mean <me>?"),
    "no condition on the state": ("(state <s> ^superstate nil ^io.input-link.self <me>)\n", "", 4, "no condition binds <s>",
                                  "first condition is missing: (state <s>"),
    "the word state is missing": ("(state <s> ^superstate", "(<s> ^superstate", 1, "begins with (state <s>", "begin the first condition"),
    "the word state is misspelt": ("(state <s>", "(sate <s>", 2, "constant sate", "did you mean state?"),
    "no blank behind state": ("(state <s>", "(state<s>", 2, "constant state<s>", "a blank is missing: state <s>"),
    "two rules of one name": ("hero*apply*go", "hero*propose*go", 8, "replaces the rule of the same name in line 1", "its own name"),
    "a bar is missing": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (write |I go (crlf))", 12, "starts here with | has no closing |", "|like this|"),
    "quotes for bars": ("(<out> ^wander <c>)", '(<out> ^wander <c>) (write "I go")', 12, "found '\"I go\"'", "between bars"),
    "missing brace at a rule's end": ("(<o> ^name go)\n}", "(<o> ^name go)", 1, "hero*propose*go is not closed", "line 7; put } before it"),
    "missing brace at the file's end": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)", 8, "hero*apply*go is not closed", "put } at its end"),
    "missing brace at a rule's begin": ("sp {hero*propose*go", "sp hero*propose*go", 1, "{ is missing after sp", "write sp {hero*propose*go"),
    "a bracket too many": ("> 10)", "> 10))", 3, "found ')'", "one ) too many"),
    "missing bracket at an action's end": ("<o> +)", "<o> +", 5, "a ) is missing", "close each ( with a )"),
    "no name": ("sp {hero*propose*go", "sp {", 2, "expected the rule's name", "give it one"),
    "half a variable": ("self <me>)", "self <me)", 2, "<me in rule hero*propose*go is read as a word", "between < and >"),
    "blanks in a variable": ("^operator <o> +", "^operator < o > +", 5, "found '<'", "without blanks"),
    "a comment of C": (None, "// my first rule", 1, "// does not start a comment", "comments start with #"),
    "a comment of Lisp": (None, "; my first rule", 1, "; does not start a comment", "comments start with #"),
    "sp misspelt": ("sp {hero*apply", "ps {hero*apply", 8, "expected sp { here, found 'ps'", "sp {"),
    "square brackets": ("(<me> ^health > 10)", "[<me> ^health > 10]", 3, "found '<me>'", "between ( and )"),
    "a relation that there is not": ("> 10", "=> 10", 3, "=> in rule hero*propose*go is read as a word", "the relations are"),
    "no value": ("(<o> ^name go)\n}", "(<o> ^name)\n}", 6, "found ')'", "write a value after each ^attribute"),
    "no actions": ("   (<out> ^wander <c>)\n", "", 8, "does nothing", "an action looks like"),
    "a function misspelt": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (wirte |hello|)", 13, "the function wirte", "did you mean write?"),
    "applies a proposal": ("(state <s> ^operator <o> ^io", "(state <s> ^operator <o> + ^io", 6, "operator go, which no rule applies",
                           "without the + it tests the operator that is selected"),
    "applies another operator": ("(<o> ^name go)\n-->", "(<o> ^name goo)\n-->", 10, "waits for the operator goo", "did you mean go?"),
    "a percept at the wrong place": ("^io.input-link.self <me>)\n   (<me> ^health > 10)", "^io.input-link.health > 10)", 2,
                                     "^health directly below the input link", "^io.input-link.self.health"),
    "a percept misspelt": ("^health", "^heatlh", 3, "tests ^heatlh", "did you mean ^health?"),
    "no io": ("^io.input-link.self", "^input-link.self", 2, "no ^input-link of its own", "^io.input-link"),
    "a word that is never perceived": ("^health > 10", "^weapon redy", 3, "^weapon redy, which it never is", "did you mean ready?"),
    "a word for a number": ("^health > 10", "^health full", 3, "^health, a number, with the word full", "< <= > >= <>"),
    "a command misspelt": ("^wander <c>", "^wanedr <c>", 12, "^wanedr, a command that does not exist", "did you mean ^wander?"),
    "a command without its place": ("^wander <c>", "^move-to <c>", 12, "move-to requires a place", "below the command: (<c>"),
    "a command with a constant": ("^wander <c>", "^wander true", 12, "has a constant as its value", ""),
    "a parameter misspelt": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^secnods 3)", 12, "no parameter ^secnods: did you mean ^seconds?", ""),
    "a parameter out of range": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^seconds -3)", 12, "^seconds of wander is -3", ""),
    "a sum as it is written elsewhere": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^seconds 1 + 2)", 12,
                                         "^seconds of wander has two values, 1 and 2", ""),
    "a removal of what is not bound": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<s> ^next <n> -)", 12, "binds <n>: the action removes nothing",
                                       "write the constant"),
    "a comma between tests": ("> 10)", "> 10, ^armed yes)", 3, "found ','", "not commas"),
    "a decimal comma": ("> 10)", "> 10,5)", 3, "found ','", "decimal point"),
    "commas in a choice": ("^health > 10", "^weapon << ready, empty >>", 3, "found ','", "not commas"),
    "a choice between single brackets": ("^health > 10)", "^weapon < ready empty > ^health > 10)", 3, "found '^'", "<< ready empty >>"),
    "an exclamation mark for not": ("^health > 10)", "^health > 10 !^weapon empty)", 3, "found '^'", "-^attribute value"),
    "not equal as in C": ("^health > 10", "^weapon != empty", 3, "found '='", "not equal is written <>"),
    "two carets": ("^health", "^^health", 3, "found '^'", "one ^ only"),
    "a caret within a path": ("^io.input-link.self", "io^.input-link.self", 2, "found '.'", "the ^ comes first"),
    "a path without caret": ("^io.output-link", "io.output-link", 9, "found '.'", "did you mean ^io?"),
    "braces in an action": ("(<o> ^name go)\n}", "(<o> ^name {go})\n}", 6, "found '{'", "write the value alone"),
    "a variable without its end in an action": ("(<o> ^name go)\n}", "(<o ^name go)\n}", 6, "found '^'", "a variable ends with >: <o>"),
    "an equals sign in an action": ("^name go)\n}", "^name = go)\n}", 6, "found '='", "without ="),
    "a comparison in an action": ("^name go)\n}", "^name go ^far > 3)\n}", 6, "found '>'", "compares nothing"),
    "a comment of Lua behind an action": ("^name go)\n}", "^name go) -- now\n}", 6, "found '--'", "comments start with #"),
    "a comment of C behind a condition": ("> 10)", "> 10) // healthy", 3, "found '//'", "comments start with #"),
    "a comment of Lisp behind a condition": ("> 10)", "> 10) ; healthy", 3, "found 'healthy'", "comments start with #"),
    "an action without brackets": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   halt", 13, "found 'halt'", "(halt)"),
    "an else": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\nelse", 13, "found 'else'", "there is no else"),
    "two arrows": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n-->", 13, "found '-->'", "one --> only"),
    "a brace too many": ("(<o> ^name go)\n}", "(<o> ^name go)\n}}", 7, "hero*propose*go has one } too many", "remove it"),
    "two rules in one line": ("}\nsp {hero*apply", "} sp {hero*apply", 7, "more follows in the same line", "a line of its own"),
    "an if": (None, "if it is healthy", 1, "no such command 'if'", "a rule starts with sp {"),
    "a fence of Markdown": (None, "```soar", 1, "no such command '```soar'", "a rule starts with sp {"),
    "Nil": ("^superstate nil", "^superstate Nil", 2, "never matches", "write ^superstate nil"),
}

REMEMBERS = """smem --set learning on
smem --add {
   (<a> ^kind apple ^color red ^taste <t>)
   (<t> ^sweet yes)
}
sp {ask
   (state <s> ^superstate nil ^smem.command <c> -^asked yes)
-->
   (<c> ^query.kind apple)
   (<s> ^asked yes)
}
sp {told
   (state <s> ^superstate nil ^smem.result <r> ^epmem.result.match-score > 0.5)
   (<r> ^success <q> -^failure <f> ^retrieved <apple>)
   (<apple> ^color <color> ^taste.sweet yes)
-->
   (<s> ^tasty <color>)
}
"""


class Typos(ScenarioCase):
    def test_are_told_where_they_are_with_what_was_meant_and_nothing_besides(self):
        for i, (name, (old, new, *_)) in enumerate(SLIPS.items()):
            text = new + "\n" + GOOD if old is None else GOOD.replace(old, new, 1)
            self.assertNotEqual(text, GOOD, name)
            self.write(f"{i:02}.soar", "#\n" * 0 + text)
        run = Run("check", self.folder, "--json")
        self.assertEqual(run.code, 1)
        problems = [json.loads(line) for line in run.out.splitlines()]
        for i, (name, (_, _, line, message, hint)) in enumerate(SLIPS.items()):
            mine = [problem for problem in problems if problem["file"].endswith(f"{i:02}.soar")]
            told = mine[0]
            self.assertEqual(told["line"], line, (name, mine))
            self.assertIn(message, told["message"], name)
            self.assertIn(hint, told.get("hint", ""), name)
            # An operator under two names is two places, and both are told.
            self.assertEqual(len(mine), 2 if name == "applies another operator" else 1, (name, mine))

    def test_a_good_file_has_none(self):
        run = Run("check", self.write("good.soar", GOOD), "--json")
        self.assertEqual((run.code, run.out), (0, ""))

    def test_what_a_memory_answers_and_facts_hold_is_none(self):
        run = Run("check", self.write("remembers.soar", REMEMBERS), "--json")
        self.assertEqual((run.code, run.out), (0, ""))
        run = Run("check", self.write("remembers.soar", REMEMBERS.replace("^color <", "^colour <")), "--json")
        (problem,) = [json.loads(line) for line in run.out.splitlines()]
        self.assertIn("rule told tests ^colour, which no percept and no rule makes", problem["message"])
        self.assertIn("did you mean ^color?", problem["hint"])

    def test_what_a_database_may_hold_is_none(self):
        rules = "smem --set path known.db\n" + REMEMBERS.replace("^color <", "^colour <")
        run = Run("check", self.write("remembers.soar", rules), "--json")
        self.assertEqual((run.code, run.out), (0, ""))

    def test_are_told_with_the_same_words_when_the_rules_run(self):
        self.write("hero.soar", GOOD.replace("-->", "->", 1))
        self.write("scenario.toml", '[[agent]]\nrules = "hero.soar"\n')
        run = Run("run", self.folder, "--headless", "--seconds", 1)
        self.assertEqual(run.code, 1)
        self.assertIn("write --> between the conditions and the actions", run.err)


if __name__ == "__main__":
    unittest.main()
