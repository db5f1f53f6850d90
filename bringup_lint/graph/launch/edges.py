"""Launch files as edges of the robot's graph: units run them, they include others, start nodes, load parameters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import display_name
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch


def file_node(file: LaunchFile) -> Node:
    return Node("launch-file", file.source.name)


def ros_node(node: Started) -> Node:
    """By its full name; without one, by what is started and where."""
    name = node.fqn
    if name is not None:
        return Node("ros-node", name)
    return Node("ros-node", node.label(), f"{node.span.path}:{node.span.line}")


def launch_edges(launch: Launch) -> Iterator[Edge]:
    """``runs`` from units, ``includes``, ``starts`` and ``loads-params``; an open condition stands in ``why``."""
    for command in launch.commands:
        if command.file is not None and command.process is not None:
            unit = Node("unit", command.process.unit.name)
            yield Edge("runs", unit, file_node(command.file), command.target.span, "ros2 launch")
    for expansion in launch.expansions:
        for include in expansion.includes:
            if include.source is expansion.entry and include.target is not None:
                why = f"include{_only(include.conditions)}"
                yield Edge("includes", file_node(expansion.entry), file_node(include.target), include.action.span, why)
    for expansion in launch.entries:
        for node in expansion.nodes:
            if node.is_node:
                started = ros_node(node)
                yield Edge("starts", file_node(node.file), started, node.span, f"node{_only(node.conditions)}")
                yield from _parameters(launch, node, started)


def _parameters(launch: Launch, node: Started, started: Node) -> Iterator[Edge]:
    for source in node.parameters:
        value = _file_of(source)
        found = launch.find(value)
        target = place(value)
        if found is not None and found.file is not None:
            yield Edge(
                "loads-params", started, Node("parameter-file", display_name(found.file)), source.span, "parameters"
            )
        elif target is not None and not target.base and target.path.startswith("/"):
            yield Edge("loads-params", started, Node("parameter-file", target.path), source.span, "parameters")


def _file_of(source: Value) -> Value:
    while isinstance(source, (ParameterFile, DerivedFile)):
        source = source.file if isinstance(source, ParameterFile) else source.base
    return source


def _only(conditions: tuple[Condition, ...]) -> str:
    """The open conditions, as they are written."""
    words = [f"{condition.kind} {' '.join(condition.span.text.split())[:60]}" for condition in conditions]
    return f" ({', '.join(words)})" if words else ""
