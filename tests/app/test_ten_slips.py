# SPDX-License-Identifier: BSD-2-Clause
"""Ten slips that `soarbox check` finds without running the rules, each with a similar correct rule."""
from soarbox_command import Run, ScenarioCase

PROPOSE = """
sp {hero*propose*go
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name go ^where <name>)
}
sp {hero*apply*go
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name go ^where <name>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint <name>)
}
"""

PLANS = """
sp {hero*propose*plan
   (state <s> ^superstate nil -^plan)
-->
   (<s> ^operator <o> + >)
   (<o> ^name plan)
}
sp {hero*apply*plan
   (state <s> ^operator.name plan)
-->
   (<s> ^plan <one> <two>)
   (<one> ^cart ada ^place gate)
   (<two> ^cart bo ^place tower)
}
"""

# Name of the slip: rules with it, its message, and the same rules without it.
SLIPS = {
    "a rule makes what it tests as absent": (
        "sp {hero*safe (state <s> ^superstate nil -^safe) --> (<s> ^safe yes)}\n"
        "sp {hero*say (state <s> ^safe yes) --> (write |safe|)}",
        "makes the \\^safe that it tests as absent",
        "sp {hero*safe (state <s> ^superstate nil -^danger) --> (<s> ^safe yes)}\n"
        "sp {hero*danger (state <s> ^superstate nil ^io.input-link.self.health < 9) --> (<s> ^danger yes)}\n"
        "sp {hero*say (state <s> ^safe yes) --> (write |safe|)}"),
    "two paths through an attribute with several values": (
        PLANS + "sp {hero*tell (state <s> ^plan.cart <cart> ^plan.place <place>) --> (write <cart> | to | <place>)}",
        "tests \\^(cart|place) and \\^(cart|place) of \\^plan on two paths",
        PLANS + "sp {hero*tell (state <s> ^plan <p>) (<p> ^cart <cart> ^place <place>) --> (write <cart> | to | <place>)}"),
    "a variable that is used once where a similar one is meant": (
        PROPOSE + "sp {hero*there (state <s> ^operator <o> ^io.input-link.waypoint <w>) (<o> ^name go ^where <place>)\n"
        "   (<w> ^name <plac> ^here yes) --> (write |at the | <place>)}",
        "uses <plac> once, as \\^name, and <place> beside it",
        PROPOSE + "sp {hero*there (state <s> ^operator <o> ^io.input-link.waypoint <w>) (<o> ^name go ^where <place>)\n"
        "   (<w> ^name <place> ^here yes) --> (write |at the | <place>)}"),
    "a number in bars is tested for equality": (
        "sp {hero*begin (state <s> ^superstate nil -^next) --> (<s> ^operator <o> + >) (<o> ^name begin)}\n"
        "sp {hero*begin*apply (state <s> ^operator.name begin) --> (<s> ^next 1)}\n"
        "sp {hero*say (state <s> ^next |1|) --> (write |one|)}",
        "tests that \\^next is \\|1\\|, which is a word",
        "sp {hero*begin (state <s> ^superstate nil -^next) --> (<s> ^operator <o> + >) (<o> ^name begin)}\n"
        "sp {hero*begin*apply (state <s> ^operator.name begin) --> (<s> ^next |1|)}\n"
        "sp {hero*say (state <s> ^next |1|) --> (write |one|)}"),
    "a variable of an action that nothing binds or uses": (
        PROPOSE.replace("^name go ^where <name>)\n-->\n   (<out>", "^name go)\n-->\n   (<out>"),
        "no condition of rule hero\\*apply\\*go binds <name>",
        PROPOSE),
    "a state name that rules test and none makes": (
        "sp {hero*deliver (state <s> ^name delivr ^superstate.operator.name serve)\n"
        "--> (<s> ^operator <o> +) (<o> ^name walk)}\n"
        "sp {hero*walk (state <s> ^operator.name walk) --> (<s> ^walked yes)}\n"
        "sp {hero*name (state <s> ^superstate.operator.name serve) --> (<s> ^name serve)}\n"
        "sp {hero*serve (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name serve)}",
        "delivr",
        "sp {hero*deliver (state <s> ^name serve ^superstate.operator.name serve)\n"
        "--> (<s> ^operator <o> +) (<o> ^name walk)}\n"
        "sp {hero*walk (state <s> ^operator.name walk) --> (<s> ^walked yes)}\n"
        "sp {hero*name (state <s> ^superstate.operator.name serve) --> (<s> ^name serve)}\n"
        "sp {hero*serve (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name serve)}"),
    "an application tests +": (
        PROPOSE.replace("^operator <o> ^io.output-link <out>", "^operator <o> + ^io.output-link <out>"),
        "without the \\+ it tests the operator that is selected",
        PROPOSE),
    "an application on the wrong state": (
        "sp {hero*serve (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name serve)}\n"
        "sp {hero*fetch (state <s> ^superstate.operator.name serve) --> (<s> ^operator <o> +) (<o> ^name fetch)}\n"
        "sp {hero*fetch*apply (state <s> ^superstate nil ^operator.name fetch ^io.output-link <out>)\n"
        "--> (<out> ^move-to <c>) (<c> ^waypoint gate)}",
        "fetch",
        "sp {hero*serve (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name serve)}\n"
        "sp {hero*fetch (state <s> ^superstate.operator.name serve) --> (<s> ^operator <o> +) (<o> ^name fetch)}\n"
        "sp {hero*fetch*apply (state <s> ^superstate <top> ^operator.name fetch) (<top> ^io.output-link <out>)\n"
        "--> (<out> ^move-to <c>) (<c> ^waypoint gate)}"),
    "a path in an action makes a new object": (
        "sp {hero*go (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
        "sp {hero*go*apply (state <s> ^operator.name go) --> (<s> ^io.output-link.move-to.waypoint gate)}",
        "a path in an action makes (a )?new object",
        "sp {hero*go (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
        "sp {hero*go*apply (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^move-to.waypoint gate)}"),
    "the removal of a value that an elaboration makes": (
        "sp {hero*conclude (state <s> ^superstate nil ^io.input-link.self.health > 0) --> (<s> ^well yes)}\n"
        "sp {hero*go (state <s> ^superstate nil ^well yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
        "sp {hero*go*apply (state <s> ^operator.name go ^well <x>) --> (<s> ^well <x> -)}",
        "removes .*\\^well|\\^well.*remov",
        "sp {hero*begin (state <s> ^superstate nil -^begun) --> (<s> ^operator <o> + >) (<o> ^name begin)}\n"
        "sp {hero*begin*apply (state <s> ^operator.name begin) --> (<s> ^begun yes ^well yes)}\n"
        "sp {hero*go (state <s> ^superstate nil ^well yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
        "sp {hero*go*apply (state <s> ^operator.name go ^well <x>) --> (<s> ^well <x> -)}"),
}

WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
position = [0, 0]

[[waypoint]]
name = "gate"
position = [3, 0]

[[waypoint]]
name = "tower"
position = [0, -12]
"""


class TenSlips(ScenarioCase):
    def told(self, name, rules):
        folder = self.folder / name
        folder.mkdir()
        (folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        (folder / "hero.soar").write_text(rules + "\n", encoding="utf-8")
        return Run("check", folder / "hero.soar", code=None).out

    def test_each_is_found_and_what_looks_alike_is_not(self):
        self.assertEqual(len(SLIPS), 10)
        for number, (slip, (wrong, says, right)) in enumerate(SLIPS.items()):
            with self.subTest(slip):
                self.assertRegex(self.told(f"wrong-{number}", wrong), says)
                self.assertNotIn("warning:", self.told(f"right-{number}", right))
