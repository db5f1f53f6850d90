"""Whether something else of a tree stops the robot when a node sends no commands any more."""

from __future__ import annotations

import ast
from collections.abc import Collection
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.commands.repeating import is_held
from bringup_lint.graph.nodes.questions.ending.safe_state import is_watched_relay
from bringup_lint.graph.nodes.sources.age import COMMENTS
from bringup_lint.graph.nodes.sources.age import looks_at_age
from bringup_lint.graph.nodes.sources.halting import firmware_looks_at_time
from bringup_lint.graph.nodes.sources.halting import gate
from bringup_lint.graph.nodes.sources.halting import timed_topics
from bringup_lint.graph.nodes.sources.motion import is_velocity
from bringup_lint.graph.nodes.sources.motion import moves
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def is_stopped_elsewhere(nodes: Nodes, command: Endpoint, own: Collection[object]) -> bool:
    """``own``: the nodes that send the command, in Python or in C++."""
    topic = (command.name or "").rpartition("/")[2]
    if gate(nodes) is not None or firmware_looks_at_time(nodes) or topic in timed_topics(nodes):
        return True
    others = [node for node in nodes.classes if node not in own]
    if any(is_watched_relay(node, command) or _times_commands(nodes, node) for node in others):
        return True
    drivers = (each for each in nodes.cpp if each not in own and any(map(is_held, each.endpoints)))
    return any(looks_at_age(COMMENTS.sub("", with_header(nodes, each.source))) for each in drivers)


def _times_commands(nodes: Nodes, node: NodeClass) -> bool:
    """Whether a node receives velocities, keeps the time of the last one and has a timer that can compare it."""
    syntax = nodes.syntax(nodes.file_of(node))
    heard = [each for each in node.all_endpoints if each.role == "subscription" and (moves(each) or is_velocity(each))]
    methods = [method for each in heard if (method := node.method(each.callback or "")) is not None]
    calls = [call for method in methods for call in own_calls(body_of(method.node))]
    return bool(node.all_timers) and any(_is_clock(syntax, call) for call in calls)


def _is_clock(syntax: Syntax, call: ast.Call) -> bool:
    if syntax.qualified(call) in ("time.time", "time.monotonic"):
        return True
    return isinstance(call.func, ast.Attribute) and call.func.attr == "now"
