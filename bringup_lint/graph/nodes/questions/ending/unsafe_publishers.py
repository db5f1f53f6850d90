"""C++ programs that publish velocities, and end without a stop command."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.ending.stopped_elsewhere import is_stopped_elsewhere
from bringup_lint.graph.nodes.questions.ending.unsafe_hardware import only_spin
from bringup_lint.graph.nodes.sources.motion import is_velocity
from bringup_lint.graph.nodes.sources.motion import moves
from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.node_source import Endpoint
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


class UnsafePublisher(NamedTuple):
    source: Source
    spin: Span
    command: Endpoint
    """The publisher whose last message stays in force."""
    is_caught: bool
    """Something else may stop the robot: a filter in front of the motors, a timeout, the source of what is relayed."""


def unsafe_publishers(nodes: Nodes) -> Iterator[UnsafePublisher]:
    """Those of files with a ``main`` that only spins the node."""
    for node in nodes.cpp:
        command = next((each for each in node.endpoints if _drives(each)), None)
        spin = only_spin(nodes, node) if command is not None else None
        if command is not None and spin is not None:
            yield UnsafePublisher(node.source, spin, command, _is_caught(nodes, node, command))


def _is_caught(nodes: Nodes, node: CppNode, command: Endpoint) -> bool:
    if any(each.role == "subscription" and (moves(each) or is_velocity(each)) for each in node.endpoints):
        return True
    return is_stopped_elsewhere(nodes, command, [node])


def _drives(endpoint: Endpoint) -> bool:
    return endpoint.role == "publisher" and moves(endpoint) and is_velocity(endpoint)
