# SPDX-License-Identifier: BSD-2-Clause
"""A world and its agents."""
from __future__ import annotations

import contextlib
import os
import pathlib
import tempfile
from typing import Any, Dict, Iterator, List, Optional, Union

from . import reports
from .engine import Engine, EngineGone
from .rules import check_text
from .values import Command, Node, Reason, reason_of


_PANELS = ["agents", "links", "why", "memory"]


class WorldError(RuntimeError):
    """The world cannot be created, or refused a request. The text has the reason and a hint."""


class WorldEnded(WorldError):
    """The world is over: it was closed, or its scenario has ended."""


class World:
    """A scenario that runs in a separate process, tick by tick.

    `scenario` is the same as for `soarbox run`: a name (`soarbox list` prints them), a folder, a scenario file, or a file of
    rules for one agent in a field. Instead, you can pass `rules`, the text of rules for one agent in a field. All random
    numbers come from `seed`; without it, from the scenario's seed. The world begins at tick 0 and waits until you call step().

    Raises WorldError if there is no such scenario, and RuleError if `rules` have errors.
    """

    def __init__(self, scenario: Union[str, "os.PathLike[str]", None] = None, seed: Optional[int] = None, *,
                 rules: Optional[str] = None):
        if (scenario is None) == (rules is None):
            raise TypeError("World takes a scenario or rules, not both")
        if seed is not None and (not isinstance(seed, int) or isinstance(seed, bool) or seed < 0):
            raise TypeError(f"a seed is a whole number from 0, not {seed!r}")
        self._engine: Optional[Engine] = None
        self._folder: Optional[tempfile.TemporaryDirectory[str]] = None
        if rules is not None:
            check_text(rules)
            self._folder = tempfile.TemporaryDirectory(prefix="soarbox-rules-")
            file = pathlib.Path(self._folder.name) / "agent.soar"
            file.write_text(rules, encoding="utf-8")
            run = str(file)
        else:
            run = os.fspath(scenario)  # type: ignore[arg-type]
            # An existing path is made absolute; the engine looks for other names in more places.
            if os.path.exists(run):
                run = os.path.abspath(run)
        self._engine = Engine(run, seed)
        try:
            self._ask({"request": "look", "panels": _PANELS})
        except WorldEnded as ended:
            self.close()
            raise WorldError(str(ended)) from None
        self.seed: int = self._engine.hello["seed"]  #: The seed of all random numbers.
        self.step_s: float = self._engine.hello["step_s"]  #: Simulated seconds of a tick.
        self.turn_ticks: int = self._engine.hello.get("turn_ticks", 1)  #: Ticks of a turn in a game; otherwise 1.
        self._selected = ""

    # Time ------------------------------------------------------------------------------------------------------------

    @property
    def tick(self) -> int:
        """Ticks since the beginning."""
        return int(self._contents("moment")["time"]["last_tick"])

    @property
    def time(self) -> float:
        """Simulated seconds since the beginning."""
        return self.tick * self.step_s

    def step(self, ticks: int = 1) -> None:
        """Runs the world for this many ticks. Raises WorldEnded if it ends earlier."""
        if not isinstance(ticks, int) or isinstance(ticks, bool) or ticks < 0:
            raise TypeError(f"ticks are a whole number from 0, not {ticks!r}")
        goal = self.tick + ticks
        while self.tick < goal:
            # The engine delays some of the requests if there are too many at once.
            count = min(goal - self.tick, 50)
            before = self.tick
            self._ask(*[{"request": "flow", "what": "step-tick"}] * count)
            self._ask()
            if self.tick == before:
                raise WorldError("the world does not go on")

    def step_turns(self, turns: int = 1) -> None:
        """Runs a game to the end of this turn, or for this many turns. Without turns, a turn is a tick."""
        if not isinstance(turns, int) or isinstance(turns, bool) or turns < 0:
            raise TypeError(f"turns are a whole number from 0, not {turns!r}")
        self.step(max(0, turns * self.turn_ticks - self.tick % self.turn_ticks))

    def run(self, seconds: float) -> None:
        """Runs the world for this many simulated seconds, rounded to ticks."""
        if not seconds >= 0:
            raise ValueError(f"seconds are a number from 0, not {seconds!r}")
        self.step(round(seconds / self.step_s))

    def restart(self, seed: Optional[int] = None) -> None:
        """Begins again at tick 0, with the same seed or another one, as a new World would, but much faster.

        Rules, scripts and the scenario are read again.
        """
        if seed is not None and (not isinstance(seed, int) or isinstance(seed, bool) or seed < 0):
            raise TypeError(f"a seed is a whole number from 0, not {seed!r}")
        self._ask({"request": "flow", "what": "begin-again", "seed": self.seed if seed is None else seed})
        if self._engine is not None:
            self.seed = self._engine.hello["seed"]

    # Agents ----------------------------------------------------------------------------------------------------------

    @property
    def agents(self) -> Dict[str, "Agent"]:
        """All agents by name, as they are now."""
        return {each["name"]: Agent(self, each["name"]) for each in self._contents("agents")["agents"]}

    def __getitem__(self, name: str) -> "Agent":
        if name not in self.agents:
            raise KeyError(f"there is no agent {name!r}; there are: {', '.join(self.agents)}")
        return Agent(self, name)

    def __iter__(self) -> Iterator["Agent"]:
        return iter(self.agents.values())

    def __len__(self) -> int:
        return len(self.agents)

    def why(self, agent: str, about: str = "agent", what: str = "") -> Reason:
        """Returns why an agent does what it does, or does not do something, as a tree of reasons, which you can print.

        `about` is "agent", "operator", "command" or "not". For the last three, `what` is the name of the operator or command.
        With "not", the answer says why there was no operator, command or rule of that name.
        """
        self._select(agent)
        self._ask({"request": "ask", "about": about, "what": what})
        answer = self._contents("why")["answer"]
        if answer is None:
            raise WorldError(f"there is no answer about {what or agent!r}")
        return reason_of(answer)

    def report(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the report page of the run so far, up to the last whole simulated second (docs/report.md)."""
        recorded = self._recording()
        if recorded is None:
            raise WorldError("nothing is recorded yet: run the world for a simulated second")
        reports.report_of_live_run(recorded, file)

    def _repr_html_(self) -> Optional[str]:
        """A notebook shows a world that has run for at least a second as its report page."""
        recorded = self._recording() if self._engine is not None else None
        return reports.page_in_notebook(recorded, is_live=True) if recorded is not None else None

    def _recording(self) -> Optional[pathlib.Path]:
        if self._engine is None:
            raise WorldEnded("this world is closed")
        if self.time < 1 + self.step_s:
            return None
        return self._engine.recording()

    # The process -----------------------------------------------------------------------------------------------------

    def close(self) -> None:
        """Ends the world's process. May be called twice."""
        engine, self._engine = self._engine, None
        if engine is not None:
            engine.close()
        if self._folder is not None:
            self._folder.cleanup()

    def __enter__(self) -> "World":
        return self

    def __exit__(self, *ignored: object) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_engine", None) is not None:
            self.close()

    def _ask(self, *requests: Dict[str, Any]) -> None:
        if self._engine is None:
            raise WorldEnded("this world is closed")
        try:
            self._engine.ask(*requests)
            refused = self._engine.synchronize()
        except EngineGone as gone:
            raise WorldEnded(str(gone)) from None
        if refused:
            raise WorldError("\n".join(refused))

    def _contents(self, name: str) -> Any:
        if self._engine is None:
            raise WorldEnded("this world is closed")
        return self._engine.contents[name]

    def _percept_names(self) -> List[str]:
        """The paths of all percepts that the program knows, without those of scripts."""
        return list(self._engine.hello.get("percepts", [])) if self._engine is not None else []

    @contextlib.contextmanager
    def _looking_at(self, panel: str, agent: str) -> Iterator[None]:
        """Within this context, the contents of one more panel are sent, for this agent."""
        self._select(agent)
        self._ask({"request": "look", "panels": _PANELS + [panel]})
        yield
        self._ask({"request": "look", "panels": _PANELS})

    def _select(self, agent: str) -> None:
        self[agent]  # Raises KeyError, with the names of the agents, if there is no such agent.
        if self._contents("moment")["agent"] != agent:
            self._ask({"request": "select", "agent": agent})


class Agent:
    """An agent of a world. It stores no state: each property is read from the current world."""

    def __init__(self, world: World, name: str):
        self._world = world
        self.name = name

    @property
    def _row(self) -> Dict[str, Any]:
        for each in self._world._contents("agents")["agents"]:
            if each["name"] == self.name:
                return dict(each)
        raise KeyError(f"{self.name} is not in the world any more")

    @property
    def team(self) -> str:
        """The name of its team; may be empty."""
        return str(self._row["team"])

    @property
    def alive(self) -> bool:
        return bool(self._row["alive"])

    @property
    def health(self) -> float:
        """Health, from 100 (unhurt) to 0."""
        return float(self._row["health"])

    @property
    def has_mind(self) -> bool:
        """Whether it has a Soar mind."""
        return bool(self._row["mind"])

    @property
    def decisions(self) -> int:
        """The number of its decisions so far."""
        return int(self._row["decisions"])

    @property
    def operator(self) -> str:
        """The operator that it selected last, such as "go (O3)"; empty if there is none yet."""
        return str(self._row["operator"] or self._row["last_operator"] or "")

    @property
    def percepts(self) -> Node:
        """Its percepts: the input link (docs/percepts.md has the units)."""
        io = self._io()
        return Node(io["input"]["elements"], io["input"]["id"])

    @property
    def output(self) -> Node:
        """Its output link."""
        io = self._io()
        return Node(io["output"]["elements"], io["output"]["id"])

    @property
    def commands(self) -> List[Command]:
        """The commands on its output link (docs/commands.md)."""
        io = self._io()
        parameters = {value.name: value for value in self.output.children()
                      if isinstance(value, Node)}
        return [Command(each["command"], parameters.get(each["id"], Node([])), each.get("status", ""))
                for each in io["commands"]]

    def why(self, about: str = "agent", what: str = "") -> Reason:
        """Same as World.why for this agent."""
        return self._world.why(self.name, about, what)

    def _io(self) -> Dict[str, Any]:
        if not self.has_mind:
            raise WorldError(f"{self.name} has no Soar mind: a script decides for it")
        self._world._select(self.name)
        return dict(self._world._contents("links")["io"])

    def __repr__(self) -> str:
        return f"<soarbox.Agent {self.name}>"
