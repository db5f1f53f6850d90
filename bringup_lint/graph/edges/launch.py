"""Launch files as edges of the robot's graph: they include each other, start nodes and load parameters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import display_name
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Value
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch


def launch_file_node(file: LaunchFile) -> Node:
    return Node("launch-file", file.source.name)


def ros_node(node: Started) -> Node:
    """By its full name and file, as one name in two files need not be one node; else by what is started, and where."""
    name = node.fqn
    if name is not None:
        return Node("ros-node", name, node.span.path)
    return Node("ros-node" if node.is_node else "process", node.label(), f"{node.span.path}:{node.span.line}")


def launch_edges(tree: Tree, launch: Launch) -> Iterator[Edge]:
    """``includes``, ``starts`` and ``loads-params``; with their open conditions."""
    from bringup_lint.graph.params.loads import loads_in

    for expansion in launch.expansions:
        for include in expansion.includes:
            if include.source is expansion.entry:
                target = launch_file_node(include.target) if include.target else _elsewhere(include.file)
                if target is not None:
                    own, where = launch_file_node(expansion.entry), include.action.span
                    yield Edge("includes", own, target, where, "include", condition=_only(include.conditions))
    for expansion in launch.entries:
        for node in expansion.nodes:
            what, condition = "node" if node.is_node else "process", _only(node.conditions)
            yield Edge("starts", launch_file_node(node.file), ros_node(node), node.span, what, condition=condition)
        for load in loads_in(launch, expansion):
            if load.node.is_node:
                file, condition = _parameter_file(tree, load.path), "" if load.certain else "one of several"
                yield Edge("loads-params", ros_node(load.node), file, load.where, "parameters", condition=condition)


def _parameter_file(tree: Tree, path: str) -> Node:
    """By its absolute path in the tree or on the robot."""
    source = None if tree.walks(path) else tree.find(path)
    return Node("parameter-file", source.name if source else display_name(path))


def launch_places(launch: Launch) -> Iterator[tuple[Node, Span]]:
    for file in launch.launch_files:
        yield launch_file_node(file), file_place(file.source)
    for expansion in launch.entries:
        for node in expansion.nodes:
            yield ros_node(node), node.span


def _elsewhere(file: Value) -> Node | None:
    """A launch file of a package that the tree does not hold."""
    target = place(file)
    if target is None or target.base != "share" or not is_plain(target.path):
        return None
    return Node("launch-file", f"{target.package}/{target.path.rpartition('/')[2]}")


def _only(conditions: tuple[Condition, ...]) -> str:
    """The open conditions, as they are written."""
    return ", ".join(f"{condition.kind} {' '.join(condition.span.text.split())[:60]}" for condition in conditions)
