# SPDX-License-Identifier: BSD-2-Clause
"""Messages of `soarbox check` about typical slips in a beginner's first rules."""
import json

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

# The replaced text, its replacement, the reported line, and parts of the message and its hint. Each file has one slip.
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
    "not before a value as in C": ("> 10)", "!yes)", 3, "found 'yes'", "not equal is written <>: <> yes"),
    "print as in other languages": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (print |hello|)", 13, "the function print", "did you mean write?"),
    "half of output-link": ("^io.output-link", "^io.output", 9, "tests ^output, which no percept and no rule makes", "did you mean ^output-link?"),
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
    "no plus at all": ("^operator <o> +", "^operator <o> =", 5, "makes the operator <o> and does not propose it", "add a +: (<s> ^operator <o> + =)"),
    "operator misspelt in a proposal": ("^operator <o> +", "^operater <o> +", 5, "makes ^operater, which no rule tests", "did you mean ^operator?"),
    "operator misspelt in an application": ("^operator <o> ^io", "^opertor <o> ^io", 9, "tests ^opertor", "did you mean ^operator?"),
    "superstate misspelt": ("^superstate", "^superstat", 2, "tests ^superstat", "did you mean ^superstate?"),
    "an underscore in the input link": ("input-link", "input_link", 2, "tests ^input_link", "did you mean ^input-link?"),
    "a unit behind a number": ("> 10", "> 2m", 3, "^health > 2m, which is a word and no number", "write the number alone: 2"),
    "a percent sign": ("> 10", "< 50%", 3, "^health < 50%, which is a word and no number", "write the number alone: 50"),
    "a number between bars is compared": ("> 10", "> |2|", 3, "^health > |2|, which is a word and no number", "write the number without bars: 2"),
    "a number between bars is waited for": ("> 10", "|10|", 3, "^health, a number, with the word 10", "write the number without bars: 10"),
    "a word is compared": ("> 10", "> high", 3, "^health > high, which is a word and no number", "compare numbers"),
    "an answer that there is not": ("(<me> ^health > 10)", "(<me> ^health > 10) -(<s> ^io.output-link.wander.status completed)", 3,
                                    "waits for ^status completed, which no command is answered with", "did you mean complete?"),
    "another word for complete": ("(<me> ^health > 10)", "(<me> ^health > 10) -(<s> ^io.output-link.wander.status done)", 3,
                                  "waits for ^status done", "did you mean complete?"),
    "a reason that there is not": ("(<me> ^health > 10)", "(<me> ^health > 10) -(<s> ^io.output-link.wander.reason bloked)", 3,
                                   "waits for ^reason bloked", "did you mean blocked?"),
    "a sum of equal numbers": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^seconds 1 + 1)", 12,
                               "gives ^seconds of wander twice, as 1", "a sum is written (+ 1 1)"),
    "a variable of a shell": ("(<out> ^wander <c>)", "(<out> ^move-to <c>) (<c> ^waypoint $place)", 12, "$place in rule hero*apply*go is read as a word",
                              "<place>"),
    "a no-break space": ("^health > 10", "^health\u00a0> 10", 3, "a no-break space is skipped", "a plain blank"),
    "typographic quotes": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (write \u201chello\u201d)", 12, "a typographic quote \u201c is skipped", "|hello|"),
    "a typographic minus": ("(<me> ^health > 10)", "(<me> ^health > 10) \u2212(<me> ^weapon empty)", 3, "a typographic minus \u2212 is skipped", "the keyboard"),
    "a sign for at least": ("> 10", "\u2265 10", 3, "\u2265 is skipped", "write >="),
    "an arrow in one sign": ("-->", "\u2192", 4, "an arrow \u2192 is skipped", "write -->"),
    "a dash in the arrow": ("-->", "\u2013>", 4, "a dash \u2013 is skipped", "the keyboard"),
    "a letter in a rule's name that is not ASCII": ("hero*propose*go", "hero*gr\u00fc\u00dfe", 1, "in hero*gr\u00fc\u00dfe, \u00fc is skipped", "write it without \u00fc"),
    "a letter in a value that is not ASCII": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<s> ^place h\u00f6hle)", 12, "in h\u00f6hle, \u00f6 is skipped",
                                              "|h\u00f6hle|"),
    "a letter in a variable that is not ASCII": ("self <me>)", "self <m\u00fc>)", 2, "in <m\u00fc>, \u00fc is skipped", "the letters a to z"),
    "not before a condition": ("(<me> ^health > 10)", "not (<me> ^health > 10)", 3, "found 'not'", "-(<id> ^attribute value)"),
    "not before an attribute": ("(<me> ^health > 10)", "(<me> not ^health > 10)", 3, "found 'not'", "-^attribute value"),
    "not before a value": ("^health > 10", "^weapon not empty", 3, "^weapon is the word not", "not equal is written <>"),
    "and between conditions": ("(<me> ^health > 10)", "and (<me> ^health > 10)", 3, "found 'and'", "without and"),
    "and between attributes": ("^health > 10)", "^health > 10 and ^weapon ready)", 3, "^health is the word and", "need no and"),
    "and between tests": ("> 10)", "> 10 and < 20)", 3, "^health is the word and", "{ > 10 < 20 }"),
    "or between values": ("^health > 10", "^weapon ready or empty", 3, "^weapon is the word or", "<< a b >>"),
    "blanks in a rule's name": ("hero*propose*go", "hero propose go", 1, "found 'propose'", "sp {hero*propose*go"),
    "a round bracket at a rule's begin": ("sp {hero*propose*go", "sp (hero*propose*go", 1, "not with sp (", "write sp {hero*propose*go"),
    "the word state in an action": ("(<s> ^operator <o> +)", "(state <s> ^operator <o> +)", 5, "found '^'", "write (<s> ^..."),
    "a command in a path from the state": ("(<out> ^wander <c>)", "(<s> ^io.output-link.wander <c>)", 12, "makes a second ^io on its state",
                                           "bind the link in a condition"),
    "a percept is removed by a path": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<s> ^io.input-link.self.health 100 -)", 12,
                                       "does not reach the agent's own links", "only the world changes"),
    "an operator without a name": ("(<o> ^name go)\n}", "(<o> ^kind go)\n}", 5, "proposes an operator without a ^name", "(<o> ^name go)"),
    "an operator with two names": ("^name go)\n}", "^name go there)\n}", 6, "two names, go and there", "go-there"),
    "a sum that keeps the old value": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*count\n   (state <s> ^superstate nil ^count <n>)\n"
                                       "-->\n   (<s> ^count (+ <n> 1))\n}", 17, "adds another ^count and keeps the old one", "(<s> ^count <n> -)"),
    "a command of semantic memory misspelt": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*ask\n   (state <s> ^superstate nil ^smem.command <k>)\n-->\n   (<k> ^querry.name gate)\n}", 17,
        "asks semantic memory by ^querry", "did you mean ^query?"),
    "a command of episodic memory that there is not": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*ask\n   (state <s> ^superstate nil ^epmem.command <k>)\n-->\n   (<k> ^remember yes)\n}", 17,
        "asks episodic memory by ^remember", "its commands are ^store"),
    "an answer of a memory misspelt": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*hear\n   (state <s> ^superstate nil ^smem.result.retreived <r>)\n-->\n   (<s> ^heard <r>)\n}", 15,
        "^retreived, which semantic memory never answers", "did you mean ^retrieved?"),
    "a reward in a path from the state": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*reward\n   (state <s> ^superstate nil ^io.input-link.time > 3)\n-->\n   (<s> ^reward-link.reward.value 1)\n}", 17,
        "makes a second ^reward-link on its state", "(<r> ^reward.value 1)"),
    "a reward that is a word": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*reward\n   (state <s> ^superstate nil ^reward-link <r>)\n-->\n   (<r> ^reward.value ten)\n}", 17,
        "gives ten as a reward, which is not a number", "^value 1"),
    "a number for reward beside other actions": (
        "(<s> ^operator <o> +)\n   (<o> ^name go)\n}", "(<s> ^operator <o> + = 0.5)\n   (<o> ^name go)\n}\n"
        "sp {hero*reward (state <s> ^superstate nil ^reward-link <r>) --> (<r> ^reward.value 1)}", 5,
        "the number 0.5 and has other actions, so that reward does not change", "(<s> ^operator <o> = 0.5)"),
    "a reward without its object": ("(<out> ^wander <c>)\n}", "(<out> ^wander <c>)\n}\nsp {hero*reward\n   (state <s> ^superstate nil ^reward-link <r>)\n-->\n   (<r> ^value 1)\n}", 17,
        "puts ^value on the reward link", "^reward.value 1"),
    "a minus before an action": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   -(<s> ^next <o>)", 13, "found '-'", "ends with a minus"),
    "a minus before an attribute of an action": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (<s> -^next <o>)", 13, "found '-'",
                                                 "ends with a minus"),
    "a command that has a status": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^status complete)", 12, "already has a ^status",
                                    "leave ^status out"),
    "no blank behind sp": ("sp {hero*propose*go", "sp{hero*propose*go", 1, "a blank is missing between sp and {", "write sp {hero*propose*go"),
    "a variable in capitals": ("(<o> ^name go)\n-->", "(<O> ^name go)\n-->", 10, "leads from the state to <O>", "did you mean <o>?"),
    "a choice without blanks": ("^health > 10)", "^health > 10 ^weapon <<ready empty>>)", 3, "not as a choice", "<< a b >>"),
    "a variable of CLIPS": ("^health > 10)", "^health ?h)", 3, "?h in rule hero*propose*go is read as a word", "<h>"),
    "counting as in C": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<s> ^count ++)", 12, "++ in rule", "(+ <n> 1)"),
    "a variable that only a negation binds": ("(<o> ^name go)\n-->\n   (<out> ^wander <c>)", "(<o> ^name go)\n  -(<o> ^name <p>)\n-->\n"
                                              "   (<out> ^move-to <c>)\n   (<c> ^waypoint <p>)", 11, "in a negated condition only",
                                              "without -"),
    "two paths to one waypoint": ("(<me> ^health > 10)", "(<s> ^io.input-link.waypoint.name gate ^io.input-link.waypoint.here no)", 3,
                                  "two different waypoints", "bind one"),
    "signs without a blank": ("^operator <o> +)", "^operator <o> +=)", 5, "proposes the word += itself", "+ ="),
    "best as a word": ("^operator <o> +)", "^operator <o> + best)", 5, "proposes the word best itself", "> is best"),
    "a number as a preference": ("^operator <o> +)", "^operator <o> + 5)", 5, "proposes the word 5 itself", "= 5"),
    "make as in OPS5": ("(<s> ^operator <o> +)", "(make <s> ^operator <o> +)", 5, "found '^'", "needs no make"),
    "a sum as in C": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^seconds (1 + 2))", 12, "found '+'", "the sign comes first: (+ 1"),
    "state without brackets": ("(state <s> ^superstate nil ^io.input-link.self <me>)", "state <s> ^superstate nil ^io.input-link.self <me>", 2,
                               "found 'state'", "between ( and )"),
    "an impasse that there is not": ("^superstate nil", "^impasse nochange", 2, "waits for ^impasse nochange", "did you mean no-change?"),
    "a type that no state has": ("^superstate nil", "^type State", 2, "waits for ^type State", "did you mean state?"),
    "an operator as a word": ("(state <s> ^operator <o> ^io.output-link <out>)\n   (<o> ^name go)", "(state <s> ^operator go ^io.output-link <out>)", 9,
                              "the operator is the word go", "^operator.name go"),
    "commas in an action": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (write |go|, <o>)", 13, "found ','", "not commas"),
    "a random number": ("(<out> ^wander <c>)", "(<out> ^wander <c>) (<c> ^seconds (random 3))", 12, "the function random", "rand-int or rand-float"),
    "a name of one run": ("(<s> ^operator <o> +)", "(S1 ^operator <o> +)", 5, "no condition binds <o>", "S1 is the name of one object"),
    "an answer of the operator": ("(<o> ^name go)\n-->", "(<o> ^name go ^status complete)\n-->", 10, "tests ^status of an operator, where nothing writes it",
                                  "^io.output-link.wander.status"),
    "an answer of the output link": ("(<me> ^health > 10)", "(<me> ^health > 10) -(<s> ^io.output-link.reason blocked)", 3,
                                     "tests ^reason of the output link itself", "^io.output-link.wander.reason"),
    "a line end without brackets": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (write |hello| crlf)", 13, "prints the word crlf", "(crlf)"),
    "a division by 0": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (<c> ^seconds (/ 3 0))", 13, "divides by 0", "another divisor"),
    "a file that is not there": (None, "source helper.soar", 1, "Failed to open file", "relative to the folder"),
    "a backslash in a path": (None, "source rules\\helper.soar", 1, "Failed to open file", "write / between folders"),
    "an equals sign to remove an element": ('(<out> ^wander <c>)\n}', '(<out> ^wander <c>)\n}\nsp {hero*forget\n   (state <s> ^operator <o> ^io.output-link <out>)\n'
                                            '   (<out> ^wander <c>)\n   (<c> ^status)\n-->\n   (<out> ^wander <c> =)\n}', 19,
                                            "the preference = has no meaning here", "write - after its value"),
    "a word compared with a number": ("^health > 10", "^weapon > 2", 3, "compares ^weapon, a word, with the number 2", "not equal: ^weapon <>"),
    "an operator compared with a name": ("^operator <o> +)", "^operator <o> + > rest)", 5, "compares its operator with the word rest",
                                         "(<p> ^name rest)"),
    "two selected operators": ('(<out> ^wander <c>)\n}', '(<out> ^wander <c>)\n}\nsp {hero*prefer\n   (state <s> ^operator <a> ^operator <b>)\n   (<a> ^name go)\n'
                               '   (<b> ^name go)\n-->\n   (<s> ^operator <a> > <b>)\n}', 15, "tests two operators as selected", "add a + after each"),
    "the top state at an impasse": ("^superstate nil", "^superstate nil ^impasse tie", 2, "never matches: it tests ^superstate nil, which is the top state, and ^impasse",
                                    "leave ^superstate nil out"),
    "the links of a substate": ('(<out> ^wander <c>)\n}', '(<out> ^wander <c>)\n}\nsp {hero*go*propose*run\n   (state <s> ^superstate.operator.name go)\n-->\n'
                                '   (<s> ^operator <o> +)\n   (<o> ^name run)\n}\nsp {hero*apply*run\n   (state <s> ^operator.name run ^io.output-link <out>)\n-->\n'
                                '   (<out> ^wander <c>)\n}', 21, "tests ^io of the state where run is selected", "^superstate.io"),
    "a value that piles up": ('(<out> ^wander <c>)\n}', '(<out> ^wander <c>)\n}\nsp {hero*remember\n   (state <s> ^operator.name go ^io.input-link.time <t>)\n-->\n'
                              '   (<s> ^seen <t>)\n}', 17, "adds another ^seen at each change of ^time", "(<s> ^seen <old> -)"),
    "an action without brackets around it": ("   (<o> ^name go)\n}", "   ^name go\n}", 6, "found '^'", "after the object that has them"),
    "a condition without brackets around it": ("   (<me> ^health > 10)", "   ^health > 10", 3, "found '^'", "after the object that has them"),
    "a double quote without its partner": ("(<out> ^wander <c>)", '(<out> ^wander <c>)\n   (write "go)', 13, "is not closed", "between bars"),
    "a command in a proposal": (GOOD[GOOD.index("^io.input"):], "^io <io>)\n   (<io> ^input-link.self <me> ^output-link <out>)\n-->\n   (<s> ^operator <o> +)\n"
                                "   (<o> ^name go)\n   (<out> ^wander <c>)\n}\n", 6, "operator go, which no rule applies", "it gives its command itself"),
    "a relation without a blank": ("> 10", "<10", 3, "<10 in rule hero*propose*go is read as a word", "a blank between them: < 10"),
    "a parameter beside its command": ("(<out> ^wander <c>)", "(<out> ^move-to ^waypoint gate)", 12, "found '^'", "write a value after ^move-to"),
    "a parameter within its command": ("(<out> ^wander <c>)", "(<out> ^move-to (<c> ^waypoint gate))", 12, "found '^'",
                                       "objects cannot be nested: write (<out> ^move-to <c>)"),
    "a number before its attribute": ("^health > 10", "^weapon none 10 < ^health", 3, "found '^'", "the attribute comes first"),
    "a unit behind a blank": ("> 10", "> 10 m", 3, "compares ^health, a number, with the word m", "without its unit"),
    "a path in a comparison": ("> 10", "< <s>.limit", 3, "found '.'", "bind it in a condition of its own"),
    "and between braces": ("> 10", "{ > 10 and < 20 }", 3, "^health is the word and", "one after another"),
    "an operator's name as an attribute": ("(<o> ^name go)\n-->", "(<o> ^go)\n-->", 10, "tests ^go", "an operator's name is a value: ^name go"),
    "an object as its own name": ("^health > 10", "^name <me>", 3, "the object that has it", "a variable of its own"),
    "a percept that a rule writes": ("^operator <o> +)", "^operator <o> +) (<me> ^health 100)", 5, "writes ^health where it is a percept",
                                     "commands change the world"),
    "a star of a web page": ("hero*propose*go", "hero\\*propose*go", 1, "it has \\*, which web pages write for *", "write * here and elsewhere"),
    "signs of a web page": ("(<me> ^health", "(&lt;me&gt; ^health", 3, "it has &lt;, which web pages write for <", "write < here"),
    "a preference of long ago": ("^operator <o> +)", "^operator <o> + &)", 5, "found '&'", "parallel preferences (&) are gone"),
    "a goal of long ago": ("(state <s>", "(goal <s>", 2, "constant goal is used", "a goal is a state now"),
    "a command of long ago": (None, "o-support-mode 4", 1, "Soar no longer has a command 'o-support-mode'", "leave it out"),
    "an option of long ago": (None, "excise -all", 1, "No such option", "options have two dashes: excise --all"),
    "a function of long ago": ("(<out> ^wander <c>)", "(<out> ^wander <c>)\n   (tcl |puts hi|)", 13, "calls the function tcl", "Soar has no Tcl any more"),
    "a file between quotes": (None, "source 'helper.soar'", 1, "Failed to open file", "without quotes"),
    "a number between quotes": ("> 10", "> \"10\"", 3, "found '\"10\"'", "without quotes: 10"),
}

# Between bars: an escaped bar, an arrow, and a line that begins with a brace.
LEGAL = r"""sp {a*make
   (state <s> ^superstate nil)
-->
   (<s> ^word |a\|b| ^sign |-->| ^open |
} x|)
}
sp {a*propose
   (state <s> ^superstate nil ^word |a\|b| ^sign |-->| ^open |
} x|)
-->
   (<s> ^operator <o> +)
   (<o> ^name go ^open |
} y| ^sign |-->|)
}
sp {a*apply
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name go ^open |
} y| ^sign |-->|)
-->
   (<out> ^wander <c>)
}
"""

REMEMBERS = """smem --set learning on
smem --add {
   (<a> ^kind apple ^color red ^taste <t>)
   (<t> ^sweet yes)
}
sp {ask
   (state <s> ^superstate nil ^smem.command <c>)
-->
   (<c> ^query.kind apple)
}
sp {told
   (state <s> ^superstate nil ^smem.result <r> ^epmem.result.match-score > 0.5)
   (<r> ^success <q> -^failure <f> ^retrieved <apple>)
   (<apple> ^color <color> ^taste.sweet yes)
-->
   (<s> ^tasty <color>)
}
"""


# An operator without a sign is acceptable; = and > of proposals elsewhere; odd letters between bars and in comments.
FINE = """# Gr\u00fc\u00dfe, \u201cquoted\u201d
sp {hero*propose*go
   (state <s> ^superstate nil ^io.input-link.self <me>)
   (<me> ^health { > 10 <= 200 <> 50 })
-->
   (<s> ^operator <o>)
   (<o> ^name go)
}
sp {hero*propose*rest
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> + <)
   (<o> ^name rest)
}
sp {hero*prefer
   (state <s> ^operator <a> + ^operator { <> <a> <b> } +)
   (<a> ^name go)
-->
   (<s> ^operator <a> > <b> ^operator <a> =)
}
sp {hero*apply*go
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name << go rest >>)
-->
   (<out> ^wander <c>)
   (write |gr\u00fc\u00dfe \u201cyou\u201d| (crlf))
}
sp {hero*elaborate*io
   (state <s> ^superstate.io <io>)
-->
   (<s> ^io <io>)
}
sp {hero*apply*count
   (state <s> ^operator.name go ^count <n>)
-->
   (<s> ^count (+ <n> 1) ^count <n> -)
}
sp {hero*apply*first
   (state <s> ^operator.name go -^count)
-->
   (<s> ^count 0)
}
sp {hero*apply*end
   (state <s> ^operator.name << go rest >> ^io.output-link <out>)
   (<out> ^wander <c>)
   (<c> ^status << complete error >>)
-->
   (<out> ^wander <c> -)
}
"""

# A rule with conditions that match in all combinations.
TOWER = ("multi-attributes disk 6\nsp {done\n   (state <s> ^holds" + "".join(f" <h{n}>" for n in range(1, 7)) + ")\n"
         + "".join(f"   (<h{n}> ^disk <d{n}>)\n" for n in range(1, 7)) + "".join(f"   (<d{n}> ^name {n})\n" for n in range(1, 7))
         + "-->\n   (<s> ^done yes)\n}\n"
         "sp {make (state <s> ^superstate nil) --> (<s> ^holds <h>) (<h> ^disk <d>) (<d> ^name 1)}\n"
         "sp {told (state <s> ^done yes) --> (write |done|)}\n")


class Typos(ScenarioCase):
    def test_are_told_where_they_are_with_what_was_meant_and_nothing_besides(self):
        for i, (name, (old, new, *_)) in enumerate(SLIPS.items()):
            text = new + "\n" + GOOD if old is None else GOOD.replace(old, new, 1)
            self.assertNotEqual(text, GOOD, name)
            # Each in a separate folder: attributes that other rules in the folder make would count as known.
            (self.folder / f"{i:03}").mkdir()
            self.write(f"{i:03}/hero.soar", text)
        run = Run("check", self.folder, "--json", code=1)
        problems = [json.loads(line) for line in run.out.splitlines()]
        for i, (name, (_, _, line, message, hint)) in enumerate(SLIPS.items()):
            mine = [problem for problem in problems if problem["file"].endswith(f"{i:03}/hero.soar")]
            told = mine[0]
            self.assertEqual(told["line"], line, (name, mine))
            self.assertIn(message, told["message"], name)
            self.assertIn(hint, told.get("hint", ""), name)
            # If an operator has two names, both places are reported.
            self.assertEqual(len(mine), 2 if name in ("applies another operator", "operator misspelt in an application") else 1, (name, mine))

    def test_rules_for_another_world_are_told_once(self):
        rules = """sp {play*propose*left
   (state <s> ^superstate nil ^io.input-link <il>)
   (<il> ^board.cell <c> ^game-over false ^score-so-far <sc>)
   (<c> ^tile <t> ^column 1)
-->
   (<s> ^operator <o> + =)
   (<o> ^name slide ^direction left)
}
sp {play*apply*slide
   (state <s> ^operator <o> ^io.output-link <ol>)
   (<o> ^name slide ^direction <d>)
-->
   (<ol> ^slide.direction <d>)
}
"""
        run = Run("check", self.write("player.soar", rules))
        self.assertEqual(run.err.count("warning:") + run.out.count("warning:"), 1, run.out + run.err)
        self.assertIn("written for another world", run.out + run.err)
        self.assertIn("^game-over", run.out + run.err)

    def test_a_good_file_has_none(self):
        run = Run("check", self.write("good.soar", GOOD), "--json")
        self.assertEqual((run.code, run.out), (0, ""))

    def test_what_looks_like_a_slip_and_is_none(self):
        run = Run("check", self.write("good.soar", FINE), "--json")
        self.assertEqual((run.code, run.out), (0, ""))

    def test_words_that_look_like_syntax_are_words(self):
        file = self.write("legal.soar", LEGAL)
        run = Run("check", file, "--json")
        self.assertEqual((run.code, run.out), (0, ""))
        # A slip after such words is found, with the correct name.
        run = Run("check", self.write("legal.soar", LEGAL.replace("(<o> ^name go ^open |\n} y| ^sign |-->|)\n-->", "(<o> ^name og ^open |\n} y| ^sign |-->|)\n-->")), "--json")
        told = [json.loads(line)["message"] for line in run.out.splitlines()]
        self.assertEqual(sorted(told), ["rule a*apply waits for the operator og, which no rule proposes",
                                        "rule a*propose proposes the operator go, which no rule applies"])

    def test_traps_that_a_kernel_sees_in_good_rules_are_told_before_and_in_a_run(self):
        """Conditions that match in all combinations, and a number that no proposal accepts."""
        gap = GOOD + GOOD.split("sp {hero*apply")[0].replace("propose*go", "propose*rest").replace("> 10", "< 10")
        for name, rules, line, message in (("tower", TOWER, 2, "tests ^holds 6 times"), ("gap", gap, 14, "exactly 10")):
            file = self.write(name + ".soar", rules)
            run = Run("check", file, "--json")
            told = [json.loads(line) for line in run.out.splitlines()]
            self.assertEqual([(problem["line"], problem["severity"]) for problem in told], [(line, "warning")], (name, told))
            self.assertIn(message, told[0]["message"])
            self.write("scenario.toml", f'[[agent]]\nrules = "{name}.soar"\n')
            run = Run("run", self.folder, "--headless", "--seconds", 1)
            self.assertIn(message, run.out + run.err)

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
        run = Run("run", self.folder, "--headless", "--seconds", 1, code=1)
        self.assertIn("write --> between the conditions and the actions", run.err)
