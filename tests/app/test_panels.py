# SPDX-License-Identifier: BSD-2-Clause
"""A user of the window, with real events of mouse and keyboard: looks into an agent, stops it, changes it, goes back."""
import pathlib
import socket
import subprocess
import tempfile
import time
import unittest

from png_picture import Picture
from soarbox_command import COMMAND
from virtual_display import can_draw, environment

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


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Panels(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in (("scenario.toml", WORLD), ("walker.soar", WALKER), ("idler.soar", IDLER)):
            (self.folder / name).write_text(text, encoding="utf-8")

    def window(self, script, *command, size=(1280, 720)):
        """The command line that opens a window and plays a user in it."""
        file = self.folder / "user.txt"
        file.write_text(script, encoding="utf-8")
        return [COMMAND, *command, "--width", str(size[0]), "--height", str(size[1]), "--ui-script", str(file),
                "--detail", "low"]

    def play(self, script, *arguments, size=(1280, 720), code=0, record="--no-record"):
        """Plays a user and expects that everything could be done; 1: something in the run was a problem."""
        done = subprocess.run(
            self.window(script, "run", str(self.folder), record, "--port", "0", *arguments, size=size),
            capture_output=True, text=True, timeout=280, check=False, cwd=self.folder, env=environment(*size))
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def record(self, level):
        """Records three seconds of the run and returns the file."""
        file = self.folder / f"{level}.soarrec"
        done = subprocess.run([COMMAND, "run", str(self.folder), "--headless", "--seconds", "3", "--record", str(file),
                               "--record-level", level], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return file

    def replay(self, file, script):
        done = subprocess.run(self.window(script, "replay", str(file)), capture_output=True, text=True, timeout=280,
                              check=False, cwd=self.folder, env=environment(1280, 720))
        self.assertEqual(done.returncode, 0, done.stderr)

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
            expect "Paused"
            click "Phase"
            expect "walker: one phase, next is"
            click "Decision"
            expect "walker: one decision; the world stands still"
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

    def test_a_recording_has_the_panels_of_a_run(self):
        self.replay(self.record("decisions"), """
            key P
            expect "Paused"
            click-at 500 704
            expect "Goal stack"
            expect "walker*prefer*north"
            expect "Standing"
            expect "End"
            expect-not "Resume here"
            click "Why"
            expect "Why does walker do what it does?"
            expect "command seek"
            click "Senses"
            expect "Percepts (input link)"
            expect "free-ahead"
            click "Breakpoints"
            expect "Nothing stops a recording."
            click "Trace"
            expect "walker"
            audit "a replay"
            """)

    def test_a_recording_whose_scenario_has_gone_tells_what_it_holds(self):
        file = self.record("decisions")
        (self.folder / "scenario.toml").unlink()
        self.replay(file, """
            key P
            expect "Paused"
            click-at 500 704
            expect "as recorded"
            expect "Goal stack"
            expect "seek"
            expect "preferences: not recorded"
            click "Memory"
            expect "Not recorded at this level"
            click "Senses"
            expect "Percepts (input link)"
            expect "free-ahead"
            click "Why"
            expect "as it was recorded"
            expect "command seek"
            """)

    def test_every_panel_is_drawn_over_a_filled_run(self):
        (self.folder / "walker.soar").write_text(
            WALKER.replace("(<out> ^seek <command>)", "(<out> ^seek <command> ^broadcast <call>)\n"
                           "   (<call> ^about contact ^text |follow me|)") + "sp {walker*broken (state <s> -->}\n",
            encoding="utf-8")
        (self.folder / "scenario.toml").write_text(
            WORLD.replace('body = "runner"', 'body = "runner"\nteam = "red"'), encoding="utf-8")
        self.play("""
            until 1.5
            key P
            expect "Paused"
            audit "the default layout"
            click "Problems"
            expect "walker*broken"
            click "Why"
            click "Messages"
            expect "team red"
            expect "follow me"
            audit "Problems, Why and Messages"
            picture first.png
            click "Memory"
            click "Plots"
            click "Plot a number of walker"
            expect "decision time"
            click "health"
            expect "100"
            audit "Memory and Plots"
            click "Rules"
            click "Trace"
            expect "selected agent"
            expect "seek"
            audit "Rules and Trace"
            click "Edit"
            click "Choose a file"
            click "walker.soar"
            expect "sp {walker*propose*seek"
            audit "Edit"
            picture second.png
            click "Find; Enter: next"
            type "prefer*north"
            key Return
            expect "walker*prefer*north"
            click "Mind"
            expect "Goal stack"
            expect "walker*prefer*north"
            click "Console"
            click "a Soar command"
            type "print s1"
            key Return
            expect "^superstate nil"
            audit "Mind and Console"
            click "Senses"
            expect "Percepts (input link)"
            expect "free-ahead"
            click "Breakpoints"
            click "the rule's name"
            type "walker*apply*forget*"
            key Return
            expect "any agent: a rule fires:"
            click "Timeline"
            expect "signs"
            click "Agents"
            expect "Doing"
            audit "Breakpoints, Timeline and Agents"
            picture third.png
            click "Breakpoints"
            click "\u00d7"
            expect "No breakpoints."
            click-at 400 704
            expect "Resume here"
            expect-not "Rebuilding"
            click "Resume here"
            expect-not "Resume here"
            click "Futures"
            expect "So far both futures are the same."
            audit "Futures"
            picture fourth.png
            """, code=1, record=f"--record={self.folder / 'filled.soarrec'}")
        for name in ("first.png", "second.png", "third.png", "fourth.png"):
            picture = Picture(self.folder / name)
            # Left, right and bottom panels below their tabs: neither blank nor of few colours only.
            for left, top, right, bottom in ((10, 110, 260, 400), (930, 130, 1270, 400), (290, 530, 900, 680)):
                colours = {picture.at(x, y) for x in range(left, right, 3) for y in range(top, bottom, 3)}
                self.assertGreater(len(colours), 12, (name, left, top))

    def test_keys_lead_to_panels_search_and_copy(self):
        self.play("""
            until 0.5
            key P
            expect "Paused"
            key Alt+R
            expect "Filter by name"
            type "prefer"
            expect "walker*prefer*north"
            expect-not "walker*apply*seek"
            key Escape
            hover "walker*prefer*north"
            key Ctrl+C
            expect "Rules: copied"
            key Alt+L
            type "print s1"
            key Return
            expect "^superstate nil"
            key Alt+W
            type "flee"
            key Return
            expect "Why not flee?"
            click-at 640 300
            key Escape
            expect "Press Esc again to close the window"
            """)

    def test_somebody_new_is_led_through_the_window(self):
        self.play("""
            until 0.3
            click "Help"
            click "First steps"
            expect "1 of 5"
            audit "the first step"
            click-agent idler
            expect "2 of 5"
            click "Why"
            expect "3 of 5"
            click "Why not ..."
            type "flee"
            key Return
            expect "4 of 5"
            click "Pause"
            expect "5 of 5"
            click-at 400 704
            expect "That is how one finds out why."
            audit "the last step"
            click "Close"
            expect-not "First steps"
            """)

    def test_the_window_goes_on_without_a_kernel_that_has_gone(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = str(free.getsockname()[1])
        kernel = subprocess.Popen([COMMAND, "kernel", "--port", port], stdout=subprocess.PIPE, text=True)
        self.addCleanup(kernel.stdout.close)
        self.addCleanup(kernel.wait)
        self.addCleanup(kernel.kill)
        kernel.stdout.readline()
        mark = self.folder / "mark.png"
        run = subprocess.Popen(
            self.window("""
                until 0.5
                expect "Goal stack"
                expect "seek"
                expect "not available there"
                audit "Mind of another process"
                click "Memory"
                expect "^superstate"
                click "^superstate"
                expect "who made it and who tests it:"
                click "Rules"
                click "Filter by name"
                type "prefer"
                expect-not "walker*propose*seek"
                click "walker*prefer*north"
                expect "Break when it fires"
                audit "Rules of another process"
                click "Breakpoints"
                expect "No breakpoints."
                click "Console"
                click "a Soar command"
                type "print s1"
                key Return
                expect "^superstate nil"
                click "Plots"
                click "Plot a number of walker"
                click "health"
                expect "100"
                click "Edit"
                click "Choose a file"
                click "walker.soar"
                expect "sp {walker*propose*seek"
                click "Trace"
                expect "walker"
                click "Timeline"
                expect "seek"
                click "Senses"
                expect "Percepts (input link)"
                click "Why"
                expect "Why does walker do what it does?"
                click "Mind"
                picture mark.png
                expect "cannot be looked into"
                click "Problems"
                expect "has gone"
                click "Why"
                click "Memory"
                until 4
                expect "Running"
                """, "run", str(self.folder), "--no-record", "--kernel", f"127.0.0.1:{port}", "--kernel-limit", "0.5"),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
            env=environment(1280, 720))
        self.addCleanup(run.kill)
        end = time.monotonic() + 120
        while not mark.exists() and run.poll() is None and time.monotonic() < end:
            time.sleep(0.1)
        kernel.kill()
        _, errors = run.communicate(timeout=150)
        self.assertIn(run.returncode, (0, 1), errors)


if __name__ == "__main__":
    unittest.main()
