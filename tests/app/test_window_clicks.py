# SPDX-License-Identifier: BSD-2-Clause
"""The numbers of clicks in the table of docs/window.md: each task is played with real events, and the clicks are counted."""
import pathlib
import re
import unittest

from virtual_display import can_draw
from window_user import WindowUser

PAGE = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "window.md"
CLICKS = ("click", "click-agent", "click-at", "double-click", "right-click", "drag", "type", "key")

# The actions of a user in one window, in order: (task in the table, its session). None: actions between two tasks.
# Lines with a deeper indentation are not part of the task, but check its result.
STORY = (
    (None, """
        until 0.5
        key P
        expect "Paused"
        """),
    ("Ask why an agent does what it does", """
        click-agent idler
        click "Why"
          expect "Why does idler do what it does?"
        """),
    ("Ask why not", """
        click "Why not ..."
        type "flee"
        key Return
          expect "Why not flee?"
          expect "health"
          click-agent walker
        """),
    ("See a rule and where it stops", """
        key Ctrl+Shift+P
        type "propose*seek"
        key Return
          expect "Break when it fires"
          expect "(state <s> ^superstate nil"
        """),
    ("Change a rule in the running world", """
        click "Edit"
          expect "sp {walker*propose*seek"
        click "sp {walker*propose*seek"
        type "# mine "
          expect "# mine"
        click "Apply"
          expect "Reloaded"
        """),
    ("Take the change back", """
        click "Undo"
          expect-not "# mine"
        click "Apply"
          expect "Reloaded"
        """),
    ("Stop when a rule fires", """
        click "Breakpoints"
        click "the rule's name"
        type "walker*apply*forget*"
        key Return
          expect "any agent: a rule fires:"
          click "\u00d7"
          expect "No breakpoints."
        """),
    ("Watch a value of two agents", """
        click "Watch"
        click "Watch: a path"
        type "io.input-link.self.health"
        key Return
          expect "100"
        click "+ idler"
          expect "idler \u00d7"
          click "idler \u00d7"
          expect-not "idler \u00d7"
        """),
    ("Step one decision", """
        click "Decision"
          expect "walker:"
          expect "decision"
        """),
    ("Go on until something changes", """
        key Ctrl+Shift+N
          expect "walker:"
          expect "Paused"
        """),
    ("Show one operator's lines in the trace", """
        click "Trace"
        click "Search; rule:NAME op:NAME ^attribute"
        type "op:seek"
          expect "seek"
          expect-not "percept"
          key Ctrl+A
          key Delete
          key Escape
        """),
    ("Show one rule's firings in the trace", """
        click "Trace"
        click "Search; rule:NAME op:NAME ^attribute"
        type "rule:walker*apply*seek"
          expect "fire walker*apply*seek"
          expect-not "seek ^within 0.8 ^waypoint north"
          key Ctrl+A
          key Delete
          key Escape
        """),
    ("Show one command's lines in the trace", """
        click "Trace"
        click "Search; rule:NAME op:NAME ^attribute"
        type "command:seek"
          expect "seek ^within 0.8 ^waypoint north"
          expect-not "fire walker*"
          key Ctrl+A
          key Delete
          key Escape
        """),
    ("Go to the moment when an operator was selected", """
        click "Trace"
        click "Search; rule:NAME op:NAME ^attribute"
        type "op:seek"
        double-click "O2 (seek)"
          expect "Resume here"
          click "Live"
          expect-not "Resume here"
          click "op:seek"
          key Ctrl+A
          key Delete
          key Escape
        """),
    ("See which rule made an element", """
        click "Memory"
        click "^operator"
          expect "Made by"
          expect "walker*propose*seek"
        """),
    ("See what an agent perceives", """
        click-agent walker
        click "Senses"
          expect "Percepts (input link)"
        """),
    ("Stop when a rule fires that you look for", """
        key Ctrl+Shift+P
        type "apply*forget"
        key Return
        click "Break when it fires"
          click "Breakpoints"
          expect "a rule fires:"
          expect "walker*apply*forget"
          click "\u00d7"
          expect "No breakpoints."
        """),
    ("Plot a number over time", """
        click "Plots"
        click "Plot a number of walker"
        click "speed (m/s)"
          expect-not "Nothing is plotted yet."
        """),
    ("Send an agent a Soar command", """
        click "Console"
        click "a Soar command"
        type "print s1"
        key Return
          expect "^superstate nil"
          key Escape
        """),
    ("Find one agent of many", """
        click "Filter"
        type "idl"
          key Ctrl+A
          key Delete
          key Escape
        """),
    ("Save a picture of the window", """
        click "File"
        click "Save picture"
          expect "Saved as soarbox-"
        """),
    ("Switch to light colours", """
        click "Panels"
        click "Light colors"
          audit "light colours"
          click "Panels"
          click "Light colors"
        """),
    ("Keep an arrangement of panels", """
        click "Panels"
        click "Layouts"
        click "Save as: a name, Enter"
        type "mine"
        key Return
          expect "Layout saved as mine"
          key Escape
          key Escape
        """),
    ("See the scene alone", """
        key F11
          expect-not "Timeline"
          key F11
          expect "Timeline"
        """),
    ("Find a text anywhere", """
        key Ctrl+Shift+P
        type "flee"
          expect "idler*propose*flee"
          expect "idler.soar:"
          key Escape
        """),
    ("Compare several minds", """
        key Ctrl+Shift+P
        type "layout compare"
        key Return
        click "+ idler"
          expect "operator tie"
          key Ctrl+Shift+P
          type "layout explore"
          key Return
        """),
    (None, """
        key P
        until 4
        key P
        expect "Paused"
        click "Edit"
        expect "sp {walker*propose*seek"
        """),
    ("Go back and try another rule", """
        drag 700 704 400 704
          expect "Resume here"
          expect-not "Rebuilding"
        double-click "^name seek ^way"
        type "dream"
          expect "^name dream ^waypoint"
        click "Apply"
          expect "Reloaded"
        click "Resume here"
          expect-not "Resume here"
          click "Save"
          expect "Saved"
        """),
    ("Begin again with the next seed", """
        click "Next seed"
          expect "seed 2"
          expect "walker"
        """),
    ("Open another scenario", """
        key Ctrl+O
        type "soar_wander"
        key Return
          expect "stroller-1"
          until 0.3
          key Ctrl+Shift+O
          type "decisions.soarrec"
          key Return
          expect "End"
          key Ctrl+O
          type "soar_wander"
          key Return
          expect "stroller-1"
          until 0.3
        """),
    ("Open a recent recording", """
        click "File"
        click "Open recent"
        click "decisions.soarrec"
          expect "walker"
          expect "End"
        """),
)


def table():
    """The number of clicks of each task in the page's table."""
    part = PAGE.read_text(encoding="utf-8").split("### How many clicks", 1)[1].split("\n## ", 1)[0].split("\n### ", 1)[0]
    rows = re.findall(r"^\| (.+?) \| .+ \| (\d+) \|$", part, flags=re.MULTILINE)
    return {task: int(number) for task, number in rows}


def count(session):
    """The number of clicks and typed texts of a task. A text and the Enter after it count once."""
    total, before = 0, ""
    lines = [line for line in session.splitlines() if line.strip()]
    margin = min(len(line) - len(line.lstrip()) for line in lines)
    for line in lines:
        words = line.split()
        if len(line) - len(line.lstrip()) == margin and words[0] in CLICKS:
            ends_text = words == ["key", "Return"] and before == "type"
            total += not ends_text
            before = words[0]
    return total


class Counting(unittest.TestCase):
    def test_each_task_of_the_page_has_a_session_of_so_many_clicks(self):
        counted = {task: count(session) for task, session in STORY if task is not None}
        self.assertEqual(counted, table())


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Clicks(WindowUser):
    def test_the_sessions_of_all_tasks_do_what_the_page_promises(self):
        self.record("decisions")
        self.play("".join(session for _, session in STORY))
