# SPDX-License-Identifier: BSD-2-Clause
"""A user of the window, with real events of mouse and keyboard: looks into an agent, stops it, changes it, goes back."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from soarbox_command import COMMAND

WORLD = """
seconds = 60

[[agent]]
name = "walker"
rules = "walker.soar"
body = "runner"

[[agent]]
name = "idler"
rules = "idler.soar"
body = "runner"
position = [6, 0]

[[waypoint]]
name = "east"
position = [18, 0]

[[waypoint]]
name = "north"
position = [0, -18]
"""

WALKER = """
sp {walker*propose*seek
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name> ^here no)
-->
   (<s> ^operator <o> +)
   (<o> ^name seek ^waypoint <name>)
}

sp {walker*prefer*north
   (state <s> ^superstate nil ^operator <a> + ^operator <b> +)
   (<a> ^waypoint north)
   (<b> ^waypoint east)
-->
   (<s> ^operator <a> > <b>)
}

sp {walker*apply*seek
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name seek ^waypoint <name>)
-->
   (<out> ^seek <command>)
   (<command> ^waypoint <name> ^within 0.8)
}

sp {walker*apply*forget-answered-command
   (state <s> ^superstate nil ^operator <o> ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^status)
-->
   (<out> ^<name> <command> -)
}
"""

IDLER = """
sp {idler*propose*first
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name first)
}

sp {idler*propose*second
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name second)
}

sp {idler*propose*flee
   (state <s> ^superstate nil ^io.input-link.self.health < 10)
-->
   (<s> ^operator <o> +)
   (<o> ^name flee)
}
"""


def can_draw():
    return shutil.which("xvfb-run") is not None


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Panels(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in (("scenario.toml", WORLD), ("walker.soar", WALKER), ("idler.soar", IDLER)):
            (self.folder / name).write_text(text, encoding="utf-8")

    def play(self, script, *arguments, size=(1280, 720), code=0, record="--no-record"):
        """Plays a user and expects that everything could be done; 1: something in the run was a problem."""
        file = self.folder / "user.txt"
        file.write_text(script, encoding="utf-8")
        done = subprocess.run(
            ["xvfb-run", "-a", "-s", f"-screen 0 {size[0]}x{size[1]}x24", COMMAND, "run", str(self.folder),
             record, "--port", "0", "--width", str(size[0]), "--height", str(size[1]), "--ui-script", str(file),
             "--detail", "low", *arguments],
            capture_output=True, text=True, timeout=280, check=False, cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_a_learner_finds_out_why(self):
        self.play("""
            until 0.5
            key P
            expect "Paused"
            expect "Goal stack"
            expect "walker*prefer*north"
            click-agent idler
            expect "operator tie"
            click "Why"
            expect "Why does idler do what it does?"
            click "Why not ..."
            type "flee"
            key Return
            expect "Why not flee?"
            expect "health"
            click "Rules"
            click "idler*propose*flee"
            expect "Break when it fires"
            click "Memory"
            expect "^superstate"
            click "Senses"
            expect "Percepts (input link)"
            click "Problems"
            expect "No problems."
            key H
            expect "Keys and mouse"
            key Escape
            expect-not "Keys and mouse"
            click "Panels"
            click "Larger text"
            key Ctrl+0
            key F11
            expect-not "No problems."
            key F11
            expect "No problems."
            """)

    def test_an_expert_uses_the_command_line_and_breakpoints(self):
        self.play("""
            until 0.2
            key P
            click "Console"
            click "a Soar command"
            type "print s"
            type "1"
            key Return
            expect "^superstate nil"
            key Up
            key Return
            type "pritn s1"
            key Return
            expect "pritn"
            click "Breakpoints"
            click "the rule's name"
            type "walker*apply*forget*"
            key Return
            expect "any agent: a rule fires:"
            key P
            expect "stopped"
            expect "Paused"
            """, code=1)

    def test_going_back_with_another_rule_makes_another_future(self):
        self.play("""
            until 3
            key P
            click-at 400 704
            expect "Resume here"
            expect-not "Rebuilding"
            expect "seek"
            click "Edit"
            click "Choose a file"
            click "walker.soar"
            expect "sp {walker*propose*seek"
            click "sp {walker*propose*seek"
            key Ctrl+A
            type "sp {walker*broken"
            click "Apply"
            expect "is not closed"
            expect "Nothing was changed"
            click "sp {walker*broken"
            key Ctrl+A
            type "sp {walker*propose*seek (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name dream)}"
            click "Apply"
            expect "Reloaded"
            click "Resume here"
            expect-not "Resume here"
            click "Futures"
            expect "The run went back to"
            expect "First other decision or command"
            expect "dream"
            """)

    def test_a_run_that_begins_again_leaves_the_recordings_before_it(self):
        done = self.play("""
            until 0.5
            click "Reset"
            until 0.2
            click "Next seed"
            until 0.2
            """, record=f"--record={self.folder / 'walk.soarrec'}")
        self.assertIn("seed 2", done.stdout)
        for name in ("walk.soarrec", "walk-2.soarrec", "walk-3.soarrec"):
            checked = subprocess.run([COMMAND, "verify", str(self.folder / name)], capture_output=True, text=True,
                                     timeout=60, check=False)
            self.assertEqual(checked.returncode, 0, checked.stderr + checked.stdout)


if __name__ == "__main__":
    unittest.main()
