# SPDX-License-Identifier: BSD-2-Clause
"""A robot in a room of 4 m by 3 m, with a world of its own. usage: robot.py [RECORDING [STEPS]]

With a recording, `soarbox replay RECORDING` shows the room, the robot and what it thinks. While it runs,
`soarbox watch` shows the same (docs/client_recordings.md).
"""
import math
import pathlib
import sys
import time

import soar_sml as sml
from soarbox import Scene

WIDTH, DEPTH = 4.0, 3.0
CORNERS = [(0, 0), (WIDTH, 0), (WIDTH, DEPTH), (0, DEPTH)]


class Robot:
    """Where it is, and how far the next wall is."""

    def __init__(self):
        self.x, self.y, self.heading = 1.0, 1.0, 0.0

    def ahead(self):
        dx, dy = math.cos(math.radians(self.heading)), math.sin(math.radians(self.heading))
        ways = []
        if abs(dx) > 1e-6:
            ways.append(((WIDTH if dx > 0 else 0) - self.x) / dx)
        if abs(dy) > 1e-6:
            ways.append(((DEPTH if dy > 0 else 0) - self.y) / dy)
        return round(min(ways), 3)

    def obey(self, command):
        if command.GetCommandName() == "drive":
            distance = float(command.GetParameterValue("distance"))
            self.x += distance * math.cos(math.radians(self.heading))
            self.y += distance * math.sin(math.radians(self.heading))
        else:
            self.heading = (self.heading + float(command.GetParameterValue("angle"))) % 360


def main():
    recording = sys.argv[1] if len(sys.argv) > 1 else ""
    steps = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    kernel = sml.Kernel.CreateKernelInNewThread()
    if recording:
        kernel.record(recording)
    agent = kernel.CreateAgent("robot")
    agent.LoadProductions(str(pathlib.Path(__file__).with_name("robot.soar")))
    robot = Robot()
    scene = Scene(agent)
    for (x, y), (to_x, to_y) in zip(CORNERS, CORNERS[1:] + CORNERS[:1]):
        scene.line(x, y, to_x, to_y, color="blue")
    caption = scene.text("ready", WIDTH / 2, DEPTH)
    ahead = agent.GetInputLink().CreateFloatWME("ahead", robot.ahead())
    step = agent.GetInputLink().CreateIntWME("step", 0)
    for number in range(1, steps + 1):
        scene.body("robot", robot.x, robot.y, robot.heading)
        agent.RunSelfTilOutput()
        for i in range(agent.GetNumberCommands()):
            command = agent.GetCommand(i)
            robot.obey(command)
            caption.set(text=command.GetCommandName())
            command.AddStatusComplete()
        agent.ClearOutputLinkChanges()
        ahead.Update(robot.ahead())
        step.Update(number)
        if not recording:
            time.sleep(0.1)
    kernel.Shutdown()


if __name__ == "__main__":
    main()
