# SPDX-License-Identifier: BSD-2-Clause
"""Values that describe a mind: objects, commands and reasons."""
from __future__ import annotations

import dataclasses
from typing import Any, Dict, Iterator, List, Mapping, Union

Value = Union[int, float, str, "Node"]


def value_of(text: str) -> Union[int, float, str]:
    """Converts a constant of Soar to Python: an int or a float if the text is a number, otherwise the text."""
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return text


class Node(Mapping[str, Value]):
    """An object of working memory with its attributes and values at the time of the query.

    `node["range"]` is the newest value of ^range. `node.all("agent")` is the list of all values of ^agent, the oldest first.
    Values are numbers, texts or other nodes.
    """

    def __init__(self, elements: List[Dict[str, Any]], name: str = ""):
        self.name = name  #: The identifier, "I2"; empty for the parameters of a command without parameters.
        self._values: Dict[str, List[Value]] = {}
        for element in sorted(elements, key=lambda element: element.get("timetag", 0)):
            # The contents also list elements that were removed in the last tick.
            if element.get("change") == "removed":
                continue
            value: Value
            if element.get("object"):
                value = Node(element.get("elements", []), element["value"])
            else:
                value = value_of(element["value"])
            self._values.setdefault(element["attribute"], []).append(value)

    def __getitem__(self, attribute: str) -> Value:
        return self._values[attribute][-1]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def all(self, attribute: str) -> List[Value]:
        """All values of an attribute; an empty list if it has none."""
        return list(self._values.get(attribute, []))

    def children(self) -> List[Value]:
        """All values of all attributes."""
        return [value for values in self._values.values() for value in values]

    def __repr__(self) -> str:
        parts = []
        for attribute, values in self._values.items():
            parts += [f"^{attribute} {value!r}" if isinstance(value, Node) else f"^{attribute} {value}" for value in values]
        return f"({' '.join([self.name] + parts).strip()})"


@dataclasses.dataclass(frozen=True)
class Command:
    """A command on an agent's output link."""

    name: str  #: "move-to".
    parameters: Node
    status: str  #: "under way", "complete", or the error.


@dataclasses.dataclass(frozen=True)
class Reason:
    """A reason: a sentence, and the reasons below it."""

    text: str
    kind: str  #: "agent", "command", "rule", "percept" or "reason".
    below: List["Reason"] = dataclasses.field(default_factory=list)

    def __str__(self) -> str:
        return "\n".join(self._lines(0))

    def _lines(self, depth: int) -> List[str]:
        lines = ["  " * depth + self.text]
        for reason in self.below:
            lines += reason._lines(depth + 1)
        return lines

    def find(self, text: str) -> List["Reason"]:
        """Returns this reason and those below it with this text in their sentence."""
        found = [self] if text in self.text else []
        for reason in self.below:
            found += reason.find(text)
        return found


def reason_of(json: Dict[str, Any]) -> Reason:
    return Reason(json["text"], json.get("kind", "reason"), [reason_of(each) for each in json.get("below", [])])
