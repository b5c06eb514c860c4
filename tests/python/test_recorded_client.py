# SPDX-License-Identifier: BSD-2-Clause
"""A recorded robot in Python: the command explains it, runs its mind again, and goes back in time."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMMAND = os.environ["SOARBOX"]

# It drives along a corridor, cleans dirty cells, and charges when a function of the program requests it.
ROBOT_RULES = """
sp {propose*drive
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^cell.dirty no ^battery <b> ^clock <t>)
   (<in> ^battery > 20)
-->
   (<s> ^operator <o> + =)
   (<o> ^name drive ^at <t>)}

sp {propose*clean
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^cell.dirty yes ^clock <t>)
-->
   (<s> ^operator <o> + >)
   (<o> ^name clean ^at <t>)}

sp {propose*charge
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^battery { <b> <= 20 } ^clock <t>)
-->
   (<s> ^operator <o> + >)
   (<o> ^name charge ^at <t> ^minutes (exec minutes-for <b>))}

sp {apply*command
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name <name> ^at <t>)
-->
   (<out> ^command <c>)
   (<c> ^name <name> ^at <t>)}

sp {apply*minutes
   (state <s> ^operator <o> ^io.output-link.command <c>)
   (<o> ^minutes <m>)
   (<c> ^name charge)
-->
   (<c> ^minutes <m>)}

sp {apply*forget
   (state <s> ^operator.name ^io.output-link <out>)
   (<out> ^command <c>)
   (<c> ^status complete)
-->
   (<out> ^command <c> -)}
"""

ROBOT = '''
import sys
import soar_sml as sml

rules, steps, recording = sys.argv[1], int(sys.argv[2]), sys.argv[3] if len(sys.argv) > 3 else None
kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
if recording:
    kernel.record(recording)
kernel.AddRhsFunction("minutes-for", lambda event, data, agent, name, battery: str(60 - int(battery)), None)
robot = kernel.CreateAgent("robot")
robot.ExecuteCommandLine("source " + rules + " -v")
link = robot.GetInputLink()
clock, battery = link.CreateIntWME("clock", 0), link.CreateIntWME("battery", 50)
cell = link.CreateIdWME("cell")
dirty = cell.CreateStringWME("dirty", "no")
place, done = 0, []
for step in range(steps):
    robot.RunSelf(1)
    for i in range(robot.GetNumberCommands()):
        command = robot.GetCommand(i)
        name = command.GetParameterValue("name")
        done.append(name)
        if name == "drive":
            place += 1
            battery.Update(battery.GetValue() - 7)
        elif name == "charge":
            battery.Update(50)
        dirty.Update("yes" if name == "drive" and place % 3 == 0 else "no")
        command.AddStatusComplete()
        clock.Update(clock.GetValue() + 1)
    robot.ClearOutputLinkChanges()
print(" ".join(done))
kernel.Shutdown()
'''

# It chooses at random, with the seed from its program.
DICE_RULES = """
sp {propose*throw
   (state <s> ^superstate nil ^io.input-link.turn <t>)
-->
   (<s> ^operator <a> + = ^operator <b> + = ^operator <c> + =)
   (<a> ^name left ^turn <t>)
   (<b> ^name right ^turn <t>)
   (<c> ^name stay ^turn <t>)}

sp {apply*throw
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name <name> ^turn <t>)
-->
   (<out> ^<name> <t>)}
"""

DICE = '''
import sys
import soar_sml as sml

kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
players = [kernel.CreateAgent(name) for name in ("ann", "bob")]
for number, player in enumerate(players):
    player.ExecuteCommandLine(sys.argv[1])
    player.ExecuteCommandLine("srand " + str(number + 5))
    player.turn = player.GetInputLink().CreateIntWME("turn", 0)
for turn in range(20):
    kernel.RunAllAgents(1)
    for player in players:
        player.turn.Update(turn + 1)
kernel.Shutdown()
'''


class Recorded(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.rules = self.folder / "robot.soar"
        self.rules.write_text(ROBOT_RULES, encoding="utf-8")
        self.recording = self.folder / "run.soarrec"

    def program(self, text, *arguments, **environment):
        run = subprocess.run([sys.executable, "-c", text, *map(str, arguments)], capture_output=True, text=True,
                             env=os.environ | environment, timeout=120)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stdout)
        return run.stdout

    def soarbox(self, *arguments):
        run = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=120)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def assert_thinks_again(self, file):
        self.assertNotIn("another way", self.soarbox("replay", file, "--headless"))
        self.assertIn("equal", self.soarbox("verify", file))


class Robot(Recorded):
    def test_a_recorded_robot_thinks_again_as_it_did(self):
        done = self.program(ROBOT, self.rules, 60, self.recording)
        self.assertIn("charge", done)
        self.assertIn("clean", done)
        self.assert_thinks_again(self.recording)

    def test_a_program_that_cannot_be_changed_is_recorded_by_the_environment(self):
        by_call = self.program(ROBOT, self.rules, 30, self.recording)
        other = self.folder / "other.soarrec"
        self.assertEqual(self.program(ROBOT, self.rules, 30, SOARBOX_RECORD=str(other)), by_call)
        self.assert_thinks_again(other)
        # The times in the two logs differ, the decisions do not.
        compared = subprocess.run([COMMAND, "compare", self.recording, other], capture_output=True, text=True, timeout=120)
        self.assertNotIn("first other decision", compared.stdout)

    def test_why_and_inspect_explain_a_moment(self):
        self.program(ROBOT, self.rules, 60, self.recording)
        reasons = self.soarbox("why", self.recording, "--at", 0.8, "--agent", "robot")
        self.assertIn("given by rule apply*command", reasons)
        self.assertIn("^battery 29 of I2 (perceived)", reasons)
        self.assertIn("battery", self.soarbox("inspect", self.recording, "--agent", "robot", "--at", 0.8, "--view", "memory"))

    def test_a_recording_that_cannot_be_made_is_an_error(self):
        run = subprocess.run([sys.executable, "-c", ROBOT, self.rules, "1", self.folder / "absent" / "run.soarrec"],
                             capture_output=True, text=True, timeout=120)
        self.assertIn("OSError", run.stderr)
        self.assertIn("cannot be written", run.stderr)


class Dice(Recorded):
    def test_agents_that_choose_at_random_choose_the_same_again(self):
        self.program(DICE, DICE_RULES, SOARBOX_RECORD=str(self.recording))
        self.assert_thinks_again(self.recording)


if __name__ == "__main__":
    unittest.main()
