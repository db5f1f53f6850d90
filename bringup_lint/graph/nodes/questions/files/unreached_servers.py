"""Servers to which a node connects once, in its constructor and outside every ``try``."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import OF_SYSTEM
from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import is_restarted
from bringup_lint.graph.nodes.sources.drivers import driver_of
from bringup_lint.graph.nodes.sources.drivers import first_uncaught
from bringup_lint.graph.nodes.sources.drivers import made_of
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

MENTIONED = regex(r"\bpaho\b", hints="paho")
_CLIENT = "paho.mqtt.client.Client"
_REFUSED = OF_SYSTEM | {"ConnectionError", "ConnectionRefusedError"}


class Unreached(NamedTuple):
    file: NodeSource
    node: ast.expr
    """What raises, or the call that leads to it."""
    where: Span | None
    """The connection, where it is in another class."""


def unreached_servers(nodes: Nodes) -> Iterator[Unreached]:
    """For each node the first connection that its constructor makes and whose failure nothing takes."""
    for file, cls in nodes.node_classes:
        made = cls.methods.get("__init__")
        if made is None or not any(each.source.matches(MENTIONED) for each in nodes.imported(file) or ()):
            continue
        look = Uncaught(nodes.syntax(file), cls, _REFUSED, partial(_connection, nodes, nodes.syntax(file), cls))
        first = next(look.of(body_of(made.node)), None)
        if first is not None and not is_restarted(nodes, file):
            yield Unreached(file, *first)


def _connection(nodes: Nodes, syntax: Syntax, cls: NodeClass, node: ast.AST) -> tuple[ast.expr, Span | None] | None:
    if not isinstance(node, ast.Call):
        return None
    if _connects(syntax, node):
        return node, None
    if isinstance(node.func, ast.Attribute):
        made, method = made_of(syntax, cls, node.func.value), node.func.attr
    else:
        made, method = node, "__init__"
    driver = driver_of(nodes, syntax.file, made) if made is not None else None
    if driver is None or not driver.file.source.matches(MENTIONED):
        return None
    connects = partial(_connects, nodes.syntax(driver.file))
    first = first_uncaught(nodes, driver, method, _REFUSED, connects)
    return (node, driver.file.span_of(first)) if first is not None else None


def _connects(syntax: Syntax, call: ast.Call) -> bool:
    """Whether a call is ``connect()`` of a client of MQTT that the file makes."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr != "connect":
        return False
    return ast.unparse(function.value) in syntax.once(_clients)


def _clients(syntax: Syntax) -> frozenset[str]:
    """What alone holds a client of MQTT, as it is written: ``self.client``."""
    held: dict[str, set[bool]] = {}
    for node in syntax.file.nodes:
        if isinstance(node, ast.Assign) and not (isinstance(node.value, ast.Constant) and node.value.value is None):
            is_client = isinstance(node.value, ast.Call) and syntax.qualified(node.value) == _CLIENT
            for target in node.targets:
                held.setdefault(ast.unparse(target), set()).add(is_client)
    return frozenset(name for name, kinds in held.items() if kinds == {True})
