# SPDX-License-Identifier: BSD-2-Clause
"""A user of the window, with real mouse and keyboard events: inspects an agent, stops it, changes it, goes back."""
import subprocess
import unittest

from png_picture import Picture
from soarbox_command import Run, end, start_kernel, wait_until
from virtual_display import can_draw
from window_user import WALKER, WORLD, WindowUser

# Has two crates and a rope in memory; queries ammunition, then something that is not in memory, and an episode.
REMEMBERER = """
smem --enable
epmem --enable
smem --add { (@1 ^kind ammo ^at barn) (@2 ^kind ammo ^at mill) (@3 ^kind rope) }
sp {walker*start (state <s> ^superstate nil -^step) --> (<s> ^operator <o> +) (<o> ^name start)}
sp {walker*start*apply (state <s> ^operator.name start ^smem.command <c>)
-->
   (<s> ^step 1) (<c> ^query <q>) (<q> ^kind ammo)}
sp {walker*next (state <s> ^superstate nil ^step 1 ^smem.result.retrieved) --> (<s> ^operator <o> +) (<o> ^name next)}
sp {walker*next*apply
   (state <s> ^operator.name next ^smem.command <c> ^epmem.command <e>) (<c> ^query <q>)
-->
   (<s> ^step 1 - 2) (<c> ^query <q> - ^query <n>) (<n> ^kind mortar) (<e> ^query <m>) (<m> ^step 1)}
sp {walker*wait (state <s> ^superstate nil ^step 2) --> (<s> ^operator <o> +) (<o> ^name wait)}
"""


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Panels(WindowUser):
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
            expect-not "one phase"
            expect "walker:"
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
            click "Begin again"
            until 0.2
            click "Next seed"
            until 0.2
            """, record=f"--record={self.folder / 'walk.soarrec'}")
        self.assertIn("seed 2", done.stdout)
        for name in ("walk.soarrec", "walk-2.soarrec", "walk-3.soarrec"):
            Run("verify", self.folder / name, code=0)

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
            click "Problems"
            expect "idler has nothing to do"
            click "Why"
            expect "Why does walker do what it does?"
            expect "command seek"
            click "Senses"
            expect "Percepts (input link)"
            expect "free-ahead"
            click "Breakpoints"
            expect "Breakpoints stop a run, not a recording."
            click "Trace"
            expect "walker"
            audit "a replay"
            """)

    def test_a_recording_whose_scenario_has_gone_rebuilds_minds_from_what_it_keeps(self):
        file = self.record("decisions")
        (self.folder / "scenario.toml").unlink()
        self.replay(file, """
            key P
            expect "Paused"
            click-at 500 704
            expect "Goal stack"
            expect "seek"
            click "Memory"
            expect "^reward-link"
            click "Senses"
            expect "Percepts (input link)"
            expect "free-ahead"
            click "Why"
            expect "command seek"
            """)

    def test_what_an_agent_knows_recalls_and_remembers_is_told(self):
        (self.folder / "walker.soar").write_text(REMEMBERER, encoding="utf-8")
        file = self.folder / "remembered.soarrec"
        self.play("""
            until 1
            key P
            expect "Paused"
            key Alt+Y
            expect "Known 3"
            expect "^at mill ^kind ammo"
            audit "what is known"
            click "Recalled 3"
            expect "^kind mortar"
            audit "what was recalled"
            picture recalled.png
            click "episode "
            expect "taken in decision"
            audit "an episode"
            picture episode.png
            click "Close"
            expect "Choose an episode"
            click "Known 3"
            click "Filter by text"
            type "ROPE"
            expect "^kind rope"
            expect-not "^kind ammo"
            key Escape
            click "idler"
            expect "No long-term memory is switched on"
            """, record=f"--record={file}")
        self.replay(file, """
            until 1
            click "walker"
            click "Long-term memory"
            click "Recalled 3"
            expect "^kind mortar"
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
            # The left, right and bottom panels below their tabs are not blank and have many colours.
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
            expect "That is how you find out why."
            audit "the last step"
            click "Close"
            expect-not "First steps"
            """)

    def test_the_window_goes_on_without_a_kernel_that_has_gone(self):
        kernel, port = start_kernel()
        self.addCleanup(end, kernel)
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
                expect "which rule made it and which rules test it:"
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
                expect "its agents do nothing until"
                click "Why"
                click "Memory"
                until 4
                expect "Running"
                """, "run", str(self.folder), "--no-record", "--kernel", f"127.0.0.1:{port}", "--kernel-limit", "0.5"),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
            env=self.surroundings((1280, 720)))
        self.addCleanup(run.kill)
        wait_until(lambda: mark.exists() or run.poll() is not None)
        kernel.kill()
        _, errors = run.communicate(timeout=150)
        self.assertIn(run.returncode, (0, 1), errors)
