"""Programs that command a motion and end without a stop command."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.ending.safe_state import commands
from bringup_lint.graph.nodes.questions.ending.safe_state import has_safe_state
from bringup_lint.graph.nodes.questions.ending.safe_state import relays
from bringup_lint.graph.nodes.questions.ending.safe_state import stops_itself
from bringup_lint.graph.nodes.questions.ending.safe_state import uncovered_sigterm
from bringup_lint.graph.nodes.questions.ending.stopped_elsewhere import is_stopped_elsewhere
from bringup_lint.graph.nodes.resolved.starting import stopped_by
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


class UnsafeEnd(NamedTuple):
    file: NodeSource
    command: Endpoint
    """The publisher whose last message stays in force."""
    spin: ast.Call
    init: ast.Call | None
    """The ``rclpy.init`` that leaves SIGTERM to the system; None where the end itself sends no stop command."""
    is_caught: bool
    """Something else may stop the robot: a filter in front of the motors, a timeout, the source of what is relayed."""


def unsafe_ends(nodes: Nodes) -> Iterator[UnsafeEnd]:
    """The programs whose spin ends without a stop command, as far as their end is known."""
    for file in nodes.robot_sources:
        ending = nodes.ending(file)
        made = [node for node in nodes.made(file) if _sent(nodes, node)]
        if not made or not ending.spins or ending.signals is None:
            continue
        init = uncovered_sigterm(ending, made)
        if init is None and has_safe_state(ending, made):
            continue
        if init is not None and stopped_by(nodes, file) == {"SIGINT"}:
            continue
        command = _sent(nodes, made[0])[0]
        yield UnsafeEnd(file, command, ending.spins[0].call, init, _is_caught(nodes, ending, made, command))


def _sent(nodes: Nodes, node: NodeClass) -> list[Endpoint]:
    """The commands of a node but those whose publisher nothing uses."""
    found = commands(node)
    if not found:
        return []
    used = {name for each in node.lineage for name in _loaded(nodes.file_of(each))}
    return [each for each in found if each.attribute is None or each.attribute.rpartition(".")[2] in used]


def _loaded(file: NodeSource) -> Iterator[str]:
    for each in file.nodes:
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load):
            yield each.attr
        elif isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load):
            yield each.id


def _is_caught(nodes: Nodes, ending: Ending, made: list[NodeClass], command: Endpoint) -> bool:
    if made[0].is_lifecycle or all(relays(node) or stops_itself(ending.syntax, node) for node in made):
        return True
    return is_stopped_elsewhere(nodes, command, made)
