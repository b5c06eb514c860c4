# SPDX-License-Identifier: BSD-2-Clause
"""Worlds of Soarbox from Python: run a scenario tick by tick, and look into the minds of its agents.

    import soarbox
    with soarbox.World("soar_hallway", seed=3) as world:
        world.step(30)
        print(world["anna"].percepts["self"]["health"])
        print(world.why("anna"))

The same scenario, seed and build give the same run as in a window. docs/python.md is the tutorial. For a Soar kernel
without a world, import soar_sml.
"""
from .command import CommandError
from .environment import Environment
from .reports import Run, record, report
from .rules import Diagnostic, RuleError, check, check_text
from .scene import Scene, Shape
from .spaces import Box, Discrete
from .tables import Table, recording, sweep, tables
from .values import Command, Node, Reason
from .vector import VectorEnvironment
from .world import Agent, World, WorldEnded, WorldError

__all__ = ["Agent", "Box", "Command", "CommandError", "Diagnostic", "Discrete", "Environment", "Node", "Reason", "RuleError",
           "Run", "Scene", "Shape", "Table", "VectorEnvironment", "World", "WorldEnded", "WorldError", "check", "check_text", "record", "recording", "report",
           "sweep", "tables"]
