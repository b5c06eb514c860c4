# SPDX-License-Identifier: BSD-2-Clause
"""Wrong answers to lessons without a known mistake, and the headline of `soarbox learn check`: it must be true.

Each was made from the solution by deleting, swapping, misspelling or misplacing something, before its headline was known."""
import pathlib
import re

from soarbox_command import Run, ScenarioCase

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "lessons"

# Lesson, text in its solution, replacement, and a pattern for the beginning of the headline.
ANSWERS = [
    (1, "^visible yes", "^visible no", r"It greeted at .* but not within 1 s when a visitor came into view"),
    (1, "(<a> ^name <name> ^visible yes)", "(<a> ^name <name>)\n  -(<a> ^visible yes)", r"It greeted at .* but not within 1 s"),
    (1, "^io.input-link.agent <a>", "^io.output-link.agent <a>",
     r"rule porter\*greet never fired: it requires \^io\.output-link\.agent <a>, but no percept is there"),
    (1, "^visible yes", "^range < 1", r"rule porter\*greet never fired: it requires \^io\.input-link\.agent\.range < 1, but it is"),
    (3, "(<gold> ^where gold)", "(<gold> ^name gold)",
     r"runner\.soar:\d+: rule runner\*prefer\*gold looks for a proposed operator with the name gold"),
    (3, "<gold> > <other>", "<other> > <gold>", r"At .* before the gold, a preference chose another place"),
    (3, "^where gold)", "^where silver)", r"At .* before the gold, a preference chose another place"),
    (4, "(<w> ^index <n> ^name <name> ^here no)", "(<w> ^index <m> ^name <name> ^here no)",
     r"At 0\.0 s two operators tie: .*the same variable in both"),
    (5, "^reason <reason>)\n-->\n   (<s> ^closed <name>)\n   (write |no way to the | <name> |: | <reason> (crlf))",
     "^status done)\n-->\n   (<s> ^closed <name>)", r"climber\.soar:31: .* waits for \^status done, which no command is answered with"),
    (5, "(<s> ^closed <name>)", "(<s> ^closed <command>)", r"\^closed is there at 0\.1 s: .*take the name from the operator or the command"),
    (6, "^range < 8", "^range > 8", r"The wolf had the sheep at .*Did \^danger come as soon as the wolf was nearer than 8 m"),
    (6, "^until 14", "^until far", r"sheep\.soar:28: rule sheep\*apply\*flee: \^until of flee is far"),
    (6, "^agent <name> ^until 14", "^name <name> ^until 14", r"sheep\.soar:28: .* flee has no parameter \^name"),
    (6, "^until 14", "^until 4", r"The wolf had the sheep at .*: .*Did \^danger come .* \^until 14\?"),
    (7, "(<above> ^holds soup)\n}", "(<s> ^holds soup)\n}",
     r"operator fetch has been applied .* and let this rule change what the proposal tests"),
    (8, "^to <cart>", "^to cart", r"say failed at 0\.0 s: say: no-such-agent"),
    (8, "^about go ^place <place>", "^about go ^barn <place>", r"The messages about go have no \^place"),
    (8, "-^told yes", "-^told no", r"operator tell has been applied .* and stays selected"),
    (10, "^item <a> ^item <b>", "^items <a> ^items <b>", r"muleteer\.soar:52: .* tests \^items, .* did you mean \^item\?"),
    (10, "^operator <a> > <b>", "^operator <a> < <b>", r"At .* the muleteer came over the stone bridge, which costs most"),
    (10, "^toll > <low>", "^toll < <low>", r"At .* the muleteer came over the stone bridge, which costs most"),
    (12, "(<r> ^value <n>)", "(<r> ^value 1)", r"The numbers learn, but after 80 s the bee still visited the red flower"),
    (12, "^reward-link <link>)", "^io.reward-link <link>)",
     r"rule bee\*reward\*nectar never fired, although \^nectar <n> was there .*: which of its other conditions"),
    (12, "^value <n>", "^valu <n>", r"The values were updated, but there was never a reward. The state always has a \^reward-link"),
    (12, "= 6)", "= 0)", r"Your numbers begin at 0\."),
    (13, "^id fence", "^id wall", r"mouse\.soar:46: .* there is no node wall"),
    (13, "value > 0.9", "value < 0.9", r"At 1\.6 s the mouse is where the cat sees it\. The value is the share that is hidden"),
    (13, "(<s> ^hidden <place>)", "(<s> ^hidden <x>)",
     r"At 0\.1 s the world refused move-to of mouse: \^waypoint of move-to is an object, not its name"),
    (14, "^operator <o> -)", "^operator <o> =)", r"The conflict was never answered"),
    ("eaters 3", "^x <x> ^y <y>", "^name <y>", r"It moved at 0\.0 s, and never again\. Your proposal still matches as it did before"),
    ("eaters 3", "^status complete", "^status completed", r"rule eater\*apply\*move-north\*clear never fired: .*\.status completed"),
    ("eaters 3", "^move.direction", "^move.directon", r"At 0\.0 s the world refused move of eater: \^move requires \^direction .*, and has \^directon"),
    ("tanks 3", "^blocked.forward no", "^blocked.forward yes", r"rule tank\*propose\*go-to-sound never fired: .* but it is no"),
    ("tanks 3", "^actions.rotate.direction <side>", "^actions.rotate.direction side", r"By .* it had turned 20 times and was not there\. .* and rotate to <side>"),
    ("tanks 3", "left right >>", "left rihgt >>", r"It turned at .* Does it turn to the left and to the right"),
]


class Headlines(ScenarioCase):
    def headline(self, number, old, new):
        # A lesson is a number, or a step of another course: "eaters 3".
        course, _, number = str(number).rpartition(" ")
        words = [course] if course else []
        lesson = next((LESSONS / course).glob(f"{course[:1]}{number}-*" if course else f"{int(number):02}-*"))
        solution = next((lesson / "solution").iterdir())
        right = solution.read_text(encoding="utf-8")
        self.assertIn(old, right)
        mine = self.folder / "-".join([*words, number])
        self.assertEqual(Run("learn", *words, number, "--headless", "--folder", mine).code, 0)
        (mine / lesson.name / solution.name).write_text(right.replace(old, new), encoding="utf-8")
        run = Run("learn", *words, "check", number, "--headless", "--folder", mine, code=1)
        self.assertRegex(run.out, "this was seed")
        return run.out.split("\n\n", 1)[0]

    def test_the_first_thing_said_is_true(self):
        for number, old, new, wanted in ANSWERS:
            with self.subTest(number, new=new):
                self.assertRegex(self.headline(number, old, new), re.compile("^(?:" + wanted + ")", re.S))
