"""Publishers and subscriptions without a quality of service: rclpy raises a TypeError when they are made."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.named_tuple import NamedTuple

_NEEDED = {"create_publisher": 3, "create_subscription": 4}
_QOS = "qos_profile"


class MissingQos(NamedTuple):
    call: ast.Call
    wrong: str
    """What is wrong with it, in words."""


def without_qos(syntax: Syntax) -> Iterator[list[MissingQos]]:
    """Publishers and subscriptions of the classes of a file that get no quality of service, those of one function
    together: the first one keeps the others from being reached."""
    groups: dict[ast.AST | None, list[MissingQos]] = {}
    for found in _without_qos(syntax):
        groups.setdefault(syntax.function(found.call), []).append(found)
    yield from groups.values()


def _without_qos(syntax: Syntax) -> Iterator[MissingQos]:
    made = {each.span.start: node for node in syntax.file.classes for each in node.endpoints}
    for call in syntax.calls:
        name = call.func.attr if isinstance(call.func, ast.Attribute) else ""
        node = made.get(syntax.file.span_of(call).start) if name in _NEEDED else None
        if node is None or node.is_node is not True or _is_overridden(node, name) or _is_open(call):
            continue
        given = {each.arg for each in call.keywords}
        if "queue_size" in given:
            yield MissingQos(call, "has no argument 'queue_size'")
        elif _QOS not in given and len(call.args) + len(given) < _NEEDED[name]:
            yield MissingQos(call, f"needs '{_QOS}'")


def _is_overridden(node: NodeClass, name: str) -> bool:
    return node.method(name) is not None


def _is_open(call: ast.Call) -> bool:
    """Whether ``*`` or ``**`` may hide arguments."""
    return any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords)
