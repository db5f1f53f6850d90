"""Which units read which environment files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.systemd import own_units
from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units


def environment_edges(units: Units) -> Iterator[Edge]:
    """``loads-env``; a file that the tree does not hold goes by its path on the robot."""
    for unit, node in own_units(units):
        for file in units.environment_files(unit):
            if file.source is not None:
                target = file_node("env-file", file.source)
            elif file.path is not None:
                target = Node("env-file", file.path)
            else:
                continue
            why = "EnvironmentFile=-" if file.optional else "EnvironmentFile="
            yield Edge("loads-env", node, target, file.value.span, why)


def environment_places(units: Units) -> Iterator[tuple[Node, Span]]:
    for unit, _ in own_units(units):
        for file in units.environment_files(unit):
            if file.source is not None:
                yield file_node("env-file", file.source), file_place(file.source)
