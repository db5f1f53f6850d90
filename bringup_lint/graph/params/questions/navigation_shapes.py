"""The shape that Navigation2 gives a robot, and zones of the collision monitor inside of it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import cos
from math import hypot
from math import pi
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name
from bringup_lint.graph.params.questions.navigation_blocks import number_of
from bringup_lint.graph.params.values import items
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

Point = tuple[float, float]

_NUMBER = regex(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?\Z")
_CORNERS = 3
_SIDES = 16
"""A robot with a radius is a polygon of so many corners (nav2_costmap_2d, footprint.cpp)."""
_FAR = 1.25
"""How many times as large one radius must be to be that of another robot, and not one with a margin."""
_REACTIONS = ("stop", "slowdown", "limit")
"""What a zone does when points are in it; with ``approach`` it moves along with the robot."""


def hidden_zones(file: ParameterFile, monitor: Block) -> Iterator[NavigationProblem]:
    """The listed zones that lie inside of the robot of the local costmap, the first with the names of all."""
    costmaps = [by_name(each) for each in file.blocks if each.node_name == "local_costmap"]
    shape = shape_of(costmaps[0]) if len(costmaps) == 1 else None
    radius = inscribed_radius(shape) if shape is not None else None
    if shape is None or radius is None:
        return
    if shape.name == "robot_radius":
        radius = number_of(shape) or 0.0
    named = by_name(monitor)
    listed = [item.text for item in items(named["polygons"])] if "polygons" in named else []
    inside = [(name, where) for name in listed if (where := _zone(named, name, radius)) is not None]
    if inside:
        names = ", ".join(name for name, _ in inside)
        yield NavigationProblem("zone", inside[0][1].span, names, f"{radius:.2f} m", shape.span)


def two_radii(file: ParameterFile, costmap: Block) -> Iterator[NavigationProblem]:
    """A radius of the robot in the local costmap that is far from the one in the global costmap."""
    own = shape_of(by_name(costmap))
    others = [shape_of(by_name(each)) for each in file.blocks if each.node_name == "global_costmap"]
    other = others[0] if len(others) == 1 else None
    if own is None or other is None or own.name != "robot_radius" or other.name != own.name:
        return
    here, there = number_of(own), number_of(other)
    if here is not None and there is not None and 0 < min(here, there) * _FAR < max(here, there):
        yield NavigationProblem("radii", own.span, "robot_radius", f"{here:g} m, {there:g} m", other.span)


def _zone(named: dict[str, Parameter], name: str, radius: float) -> Parameter | None:
    """What says how large a zone is, when nothing of it is outside of a circle."""
    action, enabled = named.get(f"{name}.action_type"), named.get(f"{name}.enabled")
    if action is None or action.value.data not in _REACTIONS or (enabled is not None and not enabled.value.data):
        return None
    size = named.get(f"{name}.radius")
    if size is not None:
        reach = number_of(size)
        return size if reach is not None and 0 < reach <= radius else None
    corners = named.get(f"{name}.points")
    points = points_of(corners.value.data) if corners is not None and isinstance(corners.value.data, str) else None
    return corners if points and max(hypot(*each) for each in points) <= radius else None


def shape_of(named: dict[str, Parameter]) -> Parameter | None:
    """What gives a costmap the shape of the robot: its footprint, or the radius where there is none."""
    footprint = named.get("footprint")
    if footprint is None or footprint.value.data in ("", "[]"):
        return named.get("robot_radius")
    return footprint


def points_of(text: str) -> list[Point] | None:
    """The corners of a footprint as nav2_costmap_2d reads them (array_parser.cpp): blanks separate, too."""
    words = text.replace("[", " [ ").replace("]", " ] ").replace(",", " ").split()
    depth = 0
    points: list[Point] = []
    numbers: list[float] = []
    for word in words:
        if word == "[":
            depth, numbers = depth + 1, []
        elif word == "]":
            depth -= 1
            if depth == 1 and len(numbers) != len(("x", "y")):
                return None
            if depth == 1:
                points.append((numbers[0], numbers[1]))
        elif depth == len(("list", "point")) and _NUMBER.match(word):
            numbers.append(float(word))
        else:
            return None
    return points if depth == 0 and len(points) >= _CORNERS else None


def inscribed_radius(shape: Parameter) -> float | None:
    """The radius of the largest circle about the origin that is inside of the robot, in metres."""
    if shape.name == "footprint":
        points = points_of(str(shape.value.data))
        return min(_distance(one, other) for one, other in pairwise([*points, points[0]])) if points else None
    radius = number_of(shape)
    return radius * cos(pi / _SIDES) if radius is not None else None


def _distance(one: Point, other: Point) -> float:
    """Of the origin from the line between two points."""
    length = hypot(other[0] - one[0], other[1] - one[1])
    if length == 0:
        return hypot(*one)
    along = -(one[0] * (other[0] - one[0]) + one[1] * (other[1] - one[1])) / length**2
    along = min(1.0, max(0.0, along))
    return hypot(one[0] + along * (other[0] - one[0]), one[1] + along * (other[1] - one[1]))
