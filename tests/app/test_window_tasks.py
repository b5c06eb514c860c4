# SPDX-License-Identifier: BSD-2-Clause
"""Tasks of a user of the window: nothing that was typed is lost, everything can be found."""
import subprocess
import unittest

from png_picture import Picture
from soarbox_command import COMMAND
from virtual_display import can_draw
from window_user import IDLER, WALKER, WindowUser

# Opens walker.soar in Edit and types a comment at its beginning.
TYPE_INTO_EDIT = """
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Edit"
            expect "sp {walker*propose*seek"
            click "sp {walker*propose*seek"
            key Home
            type "# mine"
            key Return
            expect "# mine"
            """


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class TypedText(WindowUser):
    """Closing the window asks first, drafts are restored, and each change can be undone."""

    def test_closing_asks_and_what_was_typed_comes_back_as_a_draft(self):
        self.play(TYPE_INTO_EDIT + """
            key Escape
            expect "# mine"
            expect "not applied"
            key Ctrl+Q
            expect "Close the window?"
            expect "walker.soar: typed, not applied"
            audit "the question"
            key Escape
            expect-not "Close the window?"
            key Escape
            key Escape
            expect "Close the window?"
            click "Close without saving"
            wait 60
            """)
        self.assertEqual((self.folder / "walker.soar").read_text(encoding="utf-8"), WALKER, "nothing was saved")
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Edit"
            expect "# mine"
            expect "This is your draft"
            click "Undo"
            expect-not "# mine"
            click "Redo"
            expect "# mine"
            click "Apply"
            expect "Reloaded"
            key Ctrl+Q
            expect "walker.soar: applied to the running world"
            click "Save all and close"
            wait 60
            """)
        self.assertIn("# mine", (self.folder / "walker.soar").read_text(encoding="utf-8"))
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Edit"
            expect "# mine"
            expect-not "This is your draft"
            key Ctrl+Q
            """)

    def test_a_run_that_begins_again_keeps_what_was_typed(self):
        self.play(TYPE_INTO_EDIT + """
            key Escape
            click "Breakpoints"
            click "the rule's name"
            type "walker*apply*forget*"
            key Return
            expect "any agent: a rule fires:"
            key Ctrl+R
            expect "From the beginning"
            expect "any agent: a rule fires:"
            click "Edit"
            expect "# mine"
            click "Undo"
            expect-not "# mine"
            """)

    def test_the_field_of_the_console_keeps_the_keyboard(self):
        self.play("""
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Console"
            click "a Soar command"
            key Return
            type "print s1"
            expect "print s1"
            expect "walker>"
            click-agent idler
            expect "idler>"
            type "echo typed-without-a-click"
            key Return
            expect "> echo typed-without-a-click"
            key Return
            key Up
            expect "echo typed-without-a-click" 4
            """)

    def test_earlier_lines_of_the_console_can_be_read_and_copied(self):
        many = "\n".join(f"            type \"echo line-{i}\"\n            key Return\n            expect \"> echo line-{i}\"" for i in range(30))
        self.play(f"""
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Console"
            click "a Soar command"
{many}
            expect-not "> echo line-0"
            right-click "> echo line-29"
            click "Copy all"
            click "a Soar command"
            key Ctrl+V
            expect "echo line-29line-29"
            """)

    def test_a_click_on_the_ground_takes_neither_panels_nor_the_keyboard_away(self):
        self.play("""
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Console"
            click "a Soar command"
            type "print s"
            click-at 640 470
            expect "walker>"
            type "1"
            expect "print s1"
            expect "Paused"
            key Return
            expect "^superstate nil"
            type "print s2"
            click-agent idler
            expect "idler>"
            expect-not "print s2"
            click-agent walker
            expect "print s2"
            key Escape
            key Ctrl+Q
            expect "was typed and not sent"
            click "Stay"
            expect "Goal stack"
            """)


# A mistake typed into walker.soar, as events, and the panel's message.
TYPED_MISTAKES = (
    ('click "sp {walker*propose*seek"\nkey Home\ntype "p"', "expected sp { here, found 'psp'"),
    ('double-click "<name> ^here"\ntype "("', "line 4"),
    ('click "sp {walker*propose*seek"\nkey Ctrl+A\nkey Delete', "the text is empty"),
    ('click "sp {walker*propose*seek"\nkey Home\ntype "source nowhere.soar"\nkey Return', "Failed to open file"),
    ('click "sp {walker*propose*seek"\nkey Home\ntype "// mine"\nkey Return', "comments start with #"),
)


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Mistakes(WindowUser):
    def test_what_is_typed_wrong_and_applied_is_told_there_and_changes_nothing(self):
        script = """
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Edit"
            expect "sp {walker*propose*seek"
            """
        for events, said in TYPED_MISTAKES:
            script += f"""
                {events}
                click "Apply"
                expect "{said}"
                expect "Nothing was changed"
                audit "a mistake"
                click "Revert"
                expect-not "{said}"
                expect "sp {{walker*propose*seek"
                """
        self.play(script + """
            click "Rules"
            expect "walker*propose*seek"
            expect "walker*apply*seek"
            """)
        self.assertEqual((self.folder / "walker.soar").read_text(encoding="utf-8"), WALKER, "nothing was saved")


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Finding(WindowUser):
    def test_the_palette_finds_commands_agents_rules_files_and_texts(self):
        self.play("""
            until 0.3
            key Ctrl+Shift+P
            expect "command"
            type "idler*propose*fl"
            expect "idler*propose*flee"
            key Escape
            expect-not "idler*propose*flee"
            key Ctrl+Shift+P
            type "pause"
            key Return
            expect "Paused"
            key Ctrl+Shift+P
            type "agent idler"
            key Return
            expect "operator tie"
            key Ctrl+Shift+P
            type "flee"
            expect "idler*propose*flee"
            expect "idler.soar:"
            audit "the palette"
            key Escape
            key Ctrl+Shift+P
            type "rule propose*flee"
            key Return
            expect "Break when it fires"
            expect "(state <s> ^superstate nil"
            expect "^io.input-link.self.health < 10"
            expect-not "<i*1>"
            expect-not "*1>"
            key Ctrl+Shift+P
            type "layout compare"
            key Return
            expect "Side by side:"
            key Ctrl+Shift+P
            type "light"
            key Return
            audit "light colors"
            """)

    def test_another_scenario_and_a_recording_open_in_the_window(self):
        self.record("decisions")
        self.play("""
            until 0.3
            click "File"
            click "Open scenario ..."
            type "soar_wander"
            expect "stroll"
            key Return
            expect "stroller-1"
            until 0.3
            key Ctrl+Shift+O
            type "decisions.soarrec"
            key Return
            expect "walker"
            expect "End"
            click "File"
            click "Open recent"
            click "soar_wander"
            expect "stroller-1"
            key Ctrl+O
            type "no_such_world"
            key Return
            expect "no_such_world"
            expect "stroller-1"
            """)


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Watching(WindowUser):
    def test_rows_are_printed_again_for_several_agents_side_by_side(self):
        self.play("""
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            click "Watch"
            click "Watch: a path"
            type "<o>.name"
            key Return
            expect "seek"
            type "io.input-link.self.health"
            key Return
            expect "100"
            type "print s1"
            key Return
            expect "all of it"
            type "excise walker*apply*seek"
            key Return
            expect "cannot be watched"
            click "+ idler"
            expect "idler \u00d7"
            audit "two agents beside each other"
            click "Minds"
            expect "operator tie"
            expect "seek"
            """)

    def test_it_goes_on_until_something_changes_and_a_decision_shows_what_it_decides(self):
        self.play("""
            until 0.3
            key P
            expect "Paused"
            click-agent walker
            key Ctrl+Shift+N
            expect "walker:"
            expect "Paused"
            click "Decision"
            expect "decision"
            click "Trace"
            click "Search; rule:NAME op:NAME ^attribute"
            type "op:seek"
            expect "seek"
            expect-not "percept"
            """)


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Looking(WindowUser):
    def test_a_small_window_with_large_text_stays_readable(self):
        (self.folder / "scenario.toml").write_text(
            (self.folder / "scenario.toml").read_text(encoding="utf-8").replace('"walker"\n', '"blue-leader"\n', 1),
            encoding="utf-8")
        self.play("""
            until 0.5
            key P
            expect "Paused"
            expect "tick"
            expect "blue-leader"
            audit "150 % at 1280 px"
            click "Trace"
            audit "the trace"
            click "Rules"
            audit "the rules"
            """, "--panels", "default", "--text", "150")

    def test_a_picture_shows_the_window_without_the_menu_and_replaces_no_other(self):
        self.play(f"""
            until 0.5
            key P
            expect "Paused"
            click-at 640 300
            wait 20
            picture {self.folder}/plain.png
            click "File"
            click "Save picture"
            expect "Saved as soarbox-"
            click-at 640 300
            key Ctrl+Shift+P
            type "save picture"
            key Return
            expect "-2.png"
            """)
        plain = Picture(self.folder / "plain.png")
        saved = sorted(self.folder.glob("soarbox-*.png"))
        self.assertEqual(len(saved), 2)
        for file in saved:
            picture = Picture(file)
            # The places of the menu and the finder.
            places = [(x, y) for x in range(30, 240, 30) for y in range(64, 96, 4)] + \
                [(x, y) for x in range(930, 955, 5) for y in range(150, 400, 10)]
            self.assertEqual([place for place in places if picture.at(*place) != plain.at(*place)], [], file.name)

    def test_the_camera_follows_until_it_is_taken_and_comes_back(self):
        self.play("""
            until 6
            click-agent walker
            key W
            wait 5
            drag 640 400 700 420
            key Home
            wait 60
            click-agent walker
            click-agent idler
            """)

    def test_a_camera_that_goes_along_finds_somebody_by_itself(self):
        pictures = []
        for name, more in (("one", []), ("other", ["--select", "walker"])):
            file = self.folder / f"{name}.png"
            done = subprocess.run(
                [COMMAND, "run", str(self.folder), "--camera", "follow", "--screenshot", str(file), "--at", "1", *more],
                capture_output=True, text=True, timeout=240, check=False, env=self.surroundings((1280, 720)))
            self.assertEqual(done.returncode, 0, done.stderr)
            pictures.append(Picture(file))
        places = [(x, y) for x in range(300, 980, 20) for y in range(100, 620, 20)]
        same = sum(pictures[0].at(x, y) == pictures[1].at(x, y) for x, y in places)
        self.assertGreater(same, 0.95 * len(places), "the first agent is who it goes along with")

    def test_one_of_a_crowd_can_be_clicked(self):
        self.play("""
            until 1
            key P
            expect "Paused"
            click-agent idler-7
            expect "idler-7"
            click-agent idler-23
            click "Why"
            expect "Why does idler-23 do what it does?"
            """)

    def setUp(self):
        super().setUp()
        if "crowd" not in self.id():
            return
        (self.folder / "idler.soar").write_text(IDLER, encoding="utf-8")
        (self.folder / "scenario.toml").write_text(
            '[[agent]]\nname = "idler"\nrules = "idler.soar"\ncount = 30\nacross = 6\n', encoding="utf-8")
