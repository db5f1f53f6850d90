"""Robot descriptions, in URDF or for xacro: the plugins of ros2_control that they name, and their parameters."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.xml import Element
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source


@dataclass(eq=False, slots=True)
class Description:
    source: Source
    plugins: list[Located] = field(default_factory=list)
    """The classes of hardware and of transmissions, without those that xacro computes."""
    parameters: list[tuple[Located, Located]] = field(default_factory=list)
    """Name and literal value of the parameters for the hardware."""
    problems: list[Problem] = field(default_factory=list)


def parse(source: Source) -> Description:
    """Read any text; never raises."""
    root = parse_xml(source).root
    found = Description(source)
    if root is None:
        return found
    for control in _controls(root):
        for element in control.walk():
            value = element.text
            if not value or "$" in value:
                continue
            if element.local == "plugin" and not element.attributes:
                found.plugins.append(value)
            name = element.get("name")
            if element.local == "param" and name is not None:
                found.parameters.append((name, value))
    return found


def _controls(root: Element) -> Iterator[Element]:
    return (element for element in root.walk() if element.local == "ros2_control")
