# SPDX-License-Identifier: BSD-2-Clause
"""A world as a learning environment: Python decides for one agent, Soar for all others."""
from __future__ import annotations

import difflib
import math
import os
import re
import warnings
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple, Union

from .spaces import Box, Discrete, Space, array
from .values import Command, Node
from .world import Agent, World, WorldEnded, WorldError

Parameters = Mapping[str, Union[int, float, str]]
#: An order for an agent: None, a command without parameters, or a command with parameters (docs/commands.md).
Order = Union[None, str, Tuple[str, Parameters]]

#: Name of the rule that gives the command. Inspectors show it.
RULE = "soarbox*python*decides"


class Environment:
    """A scenario in which Python decides for one agent, with the functions and attributes of a Gymnasium environment.

    `scenario` is the same as for World. `agent` is the name of an agent with a Soar mind; its rules are removed. It may be
    left out if there is only one such agent.

    `actions` is a list of orders: `None` (do nothing), the name of a command, or its name and its parameters:
    `["stop", ("move-to", {"waypoint": "north"})]`. An action is then an index into the list. Instead, you can pass a pair: a
    space, and a function that converts an action to an order.

    `observe` is a list of paths of percepts: `["self.health", "self.position.x"]`. An observation has their numbers. If there
    are several values, the newest counts. `yes` is 1, `no` is 0, and a missing percept is 0. A path that no
    percept has raises ValueError. Instead, you can pass a pair: a
    space, and a function that converts the agent to an observation.

    `reward` is a function of the agent that is called after each step; without it, rewards are 0. `ended` is a function of
    the agent that returns whether the episode is over. An episode also ends when the agent is dead or the scenario has ended.

    A step takes `ticks` ticks of the world, 30 to a simulated second in most scenarios. An episode is truncated after
    `most_steps` steps. `seed` is the seed of the first episode; each following episode uses the next seed, unless reset()
    sets one.

    Repeating an order does not restart its command while that is under way; afterwards the command is given again. The same
    scenario, seeds, actions and build give the same observations.
    """

    metadata: Dict[str, Any] = {"render_modes": ["ansi"]}
    spec = None
    reward_range = (-math.inf, math.inf)

    def __init__(self, scenario: Union[str, "os.PathLike[str]"], agent: Optional[str] = None, *,
                 actions: Union[Sequence[Order], Tuple[Space, Callable[[Any], Order]]],
                 observe: Union[Sequence[str], Tuple[Space, Callable[[Agent], Any]]],
                 reward: Optional[Callable[[Agent], float]] = None, ended: Optional[Callable[[Agent], bool]] = None,
                 ticks: int = 10, most_steps: Optional[int] = None, seed: Optional[int] = None,
                 render_mode: Optional[str] = None):
        if not isinstance(ticks, int) or isinstance(ticks, bool) or ticks < 1:
            raise TypeError(f"ticks are a whole number from 1, not {ticks!r}")
        if render_mode not in (None, "ansi"):
            raise ValueError(f"render_mode is None or 'ansi', not {render_mode!r}")
        self.render_mode = render_mode
        self.action_space, self._order_of = _actions(actions)
        if not isinstance(observe, (str, tuple)):
            observe = list(observe)
        self._paths = _paths(observe)
        self.observation_space, self._observe = _observations(observe)
        self._reward, self._ended = reward, ended
        self._scenario, self._name, self._ticks, self._most_steps = scenario, agent, ticks, most_steps
        self._next_seed = seed
        self._world: Optional[World] = None
        self._is_fresh = False
        self._is_over = False
        self._begin()

    @property
    def world(self) -> World:
        """The world of this episode. You may inspect it, but only step() may run it."""
        if self._world is None:
            raise WorldEnded("this environment is closed")
        return self._world

    @property
    def agent(self) -> Agent:
        """The agent that Python decides for."""
        return Agent(self.world, self._name or "")

    @property
    def unwrapped(self) -> "Environment":
        return self

    def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        """Begins an episode. Returns the first observation and the info (see step)."""
        if seed is not None:
            self._next_seed = seed
        if seed is not None or not self._is_fresh:
            self._begin()
        self._is_fresh = False
        self._observation = self._observe(self.agent)
        return self._observation, self._info()

    def step(self, action: Any) -> Tuple[Any, float, bool, bool, Dict[str, Any]]:
        """Gives the agent the order of this action, and runs the world for one step.

        Returns the observation, the reward, whether the episode has ended, whether it was truncated, and the info: `tick`,
        `time` (simulated seconds) and `command`, the status of the order ("under way", "complete" or the error; empty without
        an order).
        """
        world = self.world
        if self._is_fresh:
            raise WorldError("the episode has not begun; call reset() first")
        if self._is_over:
            raise WorldEnded("the episode has ended; call reset()")
        if action not in self.action_space:
            raise ValueError(f"{action!r} is not an action: {self.action_space!r}")
        self._steps += 1
        reward = 0.0
        try:
            self._give(self._order_of(action))
            world.step(self._ticks)
            self._observation = self._observe(self.agent)
            if self._reward is not None:
                reward = float(self._reward(self.agent))
            ended = not self.agent.alive or (self._ended is not None and bool(self._ended(self.agent)))
            info = self._info()
        except WorldEnded:
            ended = True
            info = self._known
        self._is_over = ended or (self._most_steps is not None and self._steps >= self._most_steps)
        return self._observation, reward, ended, self._is_over and not ended, info

    def render(self) -> Optional[str]:
        """With the render mode "ansi", returns why the agent does what it does, as text."""
        return str(self.agent.why()) if self.render_mode == "ansi" else None

    def close(self) -> None:
        """Ends the world's process. May be called twice."""
        world, self._world = self._world, None
        if world is not None:
            world.close()

    def __enter__(self) -> "Environment":
        return self

    def __exit__(self, *ignored: object) -> None:
        self.close()

    def _repr_html_(self) -> Optional[str]:
        return self.world._repr_html_() if self._world is not None else None

    # The agent -------------------------------------------------------------------------------------------------------

    def _begin(self) -> None:
        """Begins the world at tick 0, in the same process if there is one, and removes the agent's rules."""
        world = self._world
        try:
            if world is None:
                raise WorldEnded()
            world.restart(world.seed if self._next_seed is None else self._next_seed)
        except WorldEnded:
            self.close()
            self._world = world = World(self._scenario, self._next_seed)
        self._next_seed = world.seed + 1
        self._steps = 0
        self._is_fresh = True
        self._is_over = False
        self._order: Order = None
        self._known: Dict[str, Any] = {}
        self._vetted: Set[str] = set()
        try:
            if self._name is None:
                minds = [each.name for each in world if each.has_mind]
                if len(minds) != 1:
                    raise WorldError(f"say for which agent Python decides: {', '.join(minds) or 'there is none with a mind'}")
                self._name = minds[0]
            if not world[self._name].has_mind:
                raise WorldError(f"{self._name} has no Soar mind: a script decides for it")
            # Without a rule that proposes an operator, the agent waits. After one tick it has percepts.
            self._say("excise --all", "soar wait-snc on")
            world.step()
            self._check_paths()
        except BaseException:
            self.close()
            raise

    def _check_paths(self) -> None:
        """Refuses paths that name no percept: they would be 0 for ever."""
        if not self._paths:
            return
        known = set(self.world._percept_names())
        _add_paths(self.agent.percepts, "", known)
        for path in self._paths:
            if path in known:
                continue
            near = difflib.get_close_matches(path, sorted(known), 1, 0.6)
            raise ValueError(f"observe: there is no percept {path!r}; "
                             + (f"did you mean {near[0]!r}?" if near else "docs/percepts.md lists all percepts")
                             + " What a script adds later, observe with a space and a function.")

    def _say(self, *lines: str) -> None:
        self.world._ask(*[{"request": "console", "agent": self._name, "line": line} for line in lines])

    def _give(self, order: Order) -> None:
        """Replaces the rule, so that its command is removed and another one is given."""
        if order == self._order and (order is None or self._status() == "under way"):
            return
        rule = None if order is None else rule_of(order)
        lines = [] if self._order is None else [f"excise {RULE}"]
        self._order = order
        if rule is not None and rule not in self._vetted:
            self._say(*lines)
            self._vet(rule)
        else:
            self._say(*lines, *([rule] if rule is not None else []))

    def _vet(self, rule: str) -> None:
        """Adds a rule for the first time, and emits warnings for the problems that the check reports."""
        self._vetted.add(rule)
        with self.world._looking_at("console", self._name or ""):
            before = len(self.world._contents("console")["lines"])
            self._say(rule)
            said = self.world._contents("console")["lines"][before:]
        for line in said:
            if line["kind"] in ("error", "hint"):
                warnings.warn(f"{self._order!r}: {line['text']}", stacklevel=4)

    def _status(self) -> str:
        commands: List[Command] = self.agent.commands
        return commands[-1].status if commands else ""

    def _info(self) -> Dict[str, Any]:
        self._known = {"tick": self.world.tick, "time": self.world.time,
                       "command": "" if self._order is None else self._status()}
        return self._known


def rule_of(order: Order) -> str:
    """Returns the text of the rule that gives an order. Raises ValueError if the order is invalid."""
    name, parameters = (order, {}) if isinstance(order, str) else _pair(order)
    attributes = "".join(f" ^{_word(attribute)} {_constant(value)}" for attribute, value in parameters.items())
    below = f" (<c>{attributes})" if attributes else ""
    return f"sp {{{RULE} (state <s> ^superstate nil ^io.output-link <out>) --> (<out> ^{_word(name)} <c>){below}}}"


def _pair(order: Any) -> Tuple[str, Parameters]:
    try:
        name, parameters = order
        if isinstance(name, str) and isinstance(parameters, Mapping):
            return name, parameters
    except (TypeError, ValueError):
        pass
    raise ValueError(f"an order is None, a command's name, or a pair of its name and its parameters, not {order!r}")


def _word(text: Any) -> str:
    if not isinstance(text, str) or not re.fullmatch(r"[A-Za-z][A-Za-z0-9_*-]*", text):
        raise ValueError(f"{text!r} is not a name of a command or parameter")
    return text


def _constant(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        if any(ord(character) < 32 for character in value):
            raise ValueError(f"{value!r} has characters that no value may have")
        return "|" + value.replace("\\", "\\\\").replace("|", "\\|") + "|"
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"a parameter is a number or a text, not {value!r}") from None
    if not math.isfinite(number):
        raise ValueError(f"a parameter is a finite number, not {value!r}")
    return str(int(number)) if number == int(number) and abs(number) < 1e15 else format(number, ".9f")


def _actions(actions: Any) -> Tuple[Space, Callable[[Any], Order]]:
    if isinstance(actions, tuple) and len(actions) == 2 and hasattr(actions[0], "sample") and callable(actions[1]):
        return actions[0], actions[1]
    orders: List[Order] = list(actions)
    if not orders:
        raise ValueError("there must be an action")
    for order in orders:
        if order is not None:
            rule_of(order)
    return Discrete(len(orders)), lambda action: orders[int(action)]


def _paths(observe: Any) -> List[str]:
    """The paths among what is to be observed; none if a function observes."""
    if isinstance(observe, str):
        return [observe]
    return [each for each in observe if isinstance(each, str)]


def _add_paths(node: Node, before: str, paths: Set[str], deepest: int = 6) -> None:
    """Adds the paths of all elements below a node."""
    for attribute in node:
        paths.add(before + attribute)
        for value in node.all(attribute):
            if isinstance(value, Node) and deepest > 0:
                _add_paths(value, f"{before}{attribute}.", paths, deepest - 1)


def _observations(observe: Any) -> Tuple[Space, Callable[[Agent], Any]]:
    if isinstance(observe, tuple) and len(observe) == 2 and hasattr(observe[0], "sample") and callable(observe[1]):
        return observe[0], observe[1]
    paths = [observe] if isinstance(observe, str) else list(observe)
    if not paths or not all(isinstance(path, str) and path for path in paths):
        raise ValueError("observe names percepts by their paths: [\"self.health\"]")

    def look(agent: Agent) -> Any:
        percepts = agent.percepts
        return array([_number(percepts, path) for path in paths])

    return Box(-math.inf, math.inf, (len(paths),)), look


def _number(percepts: Node, path: str) -> float:
    value: Any = percepts
    for attribute in path.split("."):
        if not isinstance(value, Node) or attribute not in value:
            return 0.0
        value = value[attribute]
    if value in ("yes", "no"):
        return float(value == "yes")
    if isinstance(value, (int, float)):
        return float(value)
    what = "has values of its own" if isinstance(value, Node) else f"is the word {value!r}"
    raise ValueError(f"^{path} {what}, no number: observe it with a space and a function")
