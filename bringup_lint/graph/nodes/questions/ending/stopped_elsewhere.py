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
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_own
from bringup_lint.model.python import walk

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def is_stopped_elsewhere(nodes: Nodes, command: Endpoint, senders: Collection[object]) -> bool:
    """``senders``: the nodes that send the command, in Python or in C++."""
    topic = (command.name or "").rpartition("/")[2]
    if gate(nodes) is not None or firmware_looks_at_time(nodes) or topic in timed_topics(nodes):
        return True
    others = [node for node in nodes.classes if node not in senders]
    if any(is_watched_relay(node, command) or _times_commands(nodes, node, topic) for node in others):
        return True
    drivers = (each for each in nodes.cpp if each not in senders and any(map(is_held, each.endpoints)))
    return any(looks_at_age(COMMENTS.sub("", with_header(nodes, each.source))) for each in drivers)


def _times_commands(nodes: Nodes, node: NodeClass, topic: str) -> bool:
    """Whether a node receives velocities from a topic, keeps the time of the last one and looks at it elsewhere, and
    has a timer."""
    syntax = nodes.syntax(nodes.file_of(node))
    heard = [
        each
        for each in node.all_endpoints
        if each.role == "subscription" and (each.name or "").rpartition("/")[2] == topic
        if moves(each) or is_velocity(each)
    ]
    methods = [method.node for each in heard if (method := node.method(each.callback or "")) is not None]
    kept = {attribute for method in methods for attribute in _kept_times(syntax, method)}
    others = [each.node for cls in node.lineage for each in cls.methods.values() if each.node not in methods]
    return bool(kept and node.all_timers) and any(_looks_at(each, kept) for each in others)


def _kept_times(syntax: Syntax, method: FunctionNode) -> set[str]:
    """The attributes in which a method keeps the time."""
    kept: set[str] = set()
    times: set[str] = set()
    for each in own(body_of(method)):
        if isinstance(each, ast.Assign) and any(_is_time(syntax, part, times) for part in walk(each.value)):
            kept.update(target.attr for target in each.targets if is_own(target))
            times.update(target.id for target in each.targets if isinstance(target, ast.Name))
    return kept


def _is_time(syntax: Syntax, part: ast.AST, times: set[str]) -> bool:
    """Whether it is a call of a clock, or a variable that holds what one said."""
    return (isinstance(part, ast.Call) and _is_clock(syntax, part)) or (isinstance(part, ast.Name) and part.id in times)


def _looks_at(method: FunctionNode, kept: set[str]) -> bool:
    """Whether a method compares an attribute, or takes the difference to it."""
    looks = (each for each in walk(method) if isinstance(each, (ast.Compare, ast.BinOp)))
    return any(is_own(part) and part.attr in kept for each in looks for part in walk(each))


def _is_clock(syntax: Syntax, call: ast.Call) -> bool:
    if syntax.qualified(call) in ("time.time", "time.monotonic"):
        return True
    return isinstance(call.func, ast.Attribute) and call.func.attr == "now"
