# SPDX-License-Identifier: BSD-2-Clause
"""The picture of a recorded or watched client: bodies, lines and texts, as elements below ^soarbox.scene.

    import soar_sml as sml
    from soarbox import Scene
    kernel = sml.Kernel.CreateKernelInNewThread()
    kernel.record("run.soarrec")
    robot = kernel.CreateAgent("robot")
    scene = Scene(robot)
    scene.line(0, 0, 4, 0)
    scene.body("robot", x=1, y=2, heading=90)

Positions are in metres: x to the right, y to the front. Headings are in degrees, counter-clockwise; 0 is along x. Colours:
white, black, gray, red, green, blue, yellow, orange. An element is changed only if its value changes. See
docs/client_recordings.md.
"""
from typing import Any, Dict, Optional, Union

Value = Union[float, str]


class Shape:
    """A body, a line or a text of a scene."""

    def __init__(self, parent: Any, kind: str) -> None:
        self._place: Any = parent.CreateIdWME(kind)
        self._elements: Dict[str, Any] = {}

    def set(self, **values: Optional[Value]) -> None:
        """Sets values, such as x, y, to_x, heading, size, color, text; None leaves a value as it is."""
        for name, value in values.items():
            if value is None:
                continue
            number = float(value) if not isinstance(value, str) else None
            attribute = name.replace("_", "-")
            element = self._elements.get(name)
            if element is not None:
                # Text attributes stay texts, and numbers stay numbers.
                if element.GetValue() != (value if number is None else number):
                    element.Update(value if number is None else number)
            elif number is None:
                self._elements[name] = self._place.CreateStringWME(attribute, value)
            else:
                self._elements[name] = self._place.CreateFloatWME(attribute, number)

    def remove(self) -> None:
        """Removes the shape from the picture."""
        self._place.DestroyWME()
        self._elements.clear()


class Scene:
    """The picture that a client describes to one of its agents (soar_sml.Agent)."""

    def __init__(self, agent: Any) -> None:
        self._scene: Any = agent.GetInputLink().CreateIdWME("soarbox").CreateIdWME("scene")
        self._bodies: Dict[str, Shape] = {}

    def body(self, name: str, x: float, y: float, heading: float = 0, size: Optional[float] = None,
             color: Optional[str] = None) -> Shape:
        """Puts a body there, or moves the body of this name. The name of an agent means the agent's own body."""
        shape = self._bodies.get(name)
        if shape is None:
            shape = self._bodies[name] = Shape(self._scene, "body")
            shape.set(name=name)
        shape.set(x=x, y=y, heading=heading, size=size, color=color)
        return shape

    def line(self, x: float, y: float, to_x: float, to_y: float, color: Optional[str] = None) -> Shape:
        """Draws a line on the ground."""
        shape = Shape(self._scene, "line")
        shape.set(x=x, y=y, to_x=to_x, to_y=to_y, color=color)
        return shape

    def text(self, text: str, x: float, y: float, color: Optional[str] = None) -> Shape:
        """Writes a text above this place."""
        shape = Shape(self._scene, "text")
        shape.set(text=text, x=x, y=y, color=color)
        return shape
