"""Servers to which a node connects once, in its constructor and outside every ``try``."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import OF_SYSTEM
from bringup_lint.graph.nodes.questions.hardware.unplugged_ports import is_restarted
from bringup_lint.graph.nodes.sources.drivers import driver_of
from bringup_lint.graph.nodes.sources.drivers import first_uncaught
from bringup_lint.graph.nodes.sources.drivers import made_of
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.graph.nodes.sources.uncaught import is_caught
from bringup_lint.graph.runners.runner import SUPERVISING
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import called_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

MENTIONED = regex(r"\bpaho\b", hints="paho")
_CLIENT = "paho.mqtt.client.Client"
_REFUSED = OF_SYSTEM | {"ConnectionError", "ConnectionRefusedError"}
_WAITS = regex(
    r"\b(?:create_connection|connect_ex|open_connection)\b", hints="create_connection connect_ex open_connection"
)
"""How code tries by itself whether a server answers."""
_LOOP = regex(r"\b(?:while|until)\b[^#]{0,400}?\bros2[ \t]{1,4}(?:run|launch)\b", hints="while until")
_STARTERS = regex(r"(?:^|/)(?:ecosystem\.[\w.]{0,20}|pm2[\w.-]{0,20}|process(?:es)?\.(?:json|ya?ml))$")
"""Files by which other programs start the node, and start it again."""


class Unreached(NamedTuple):
    file: NodeSource
    node: ast.expr
    """What raises, or the call that leads to it."""
    where: Span | None
    """The connection, where it is in another class."""
    is_launched: bool
    """Whether a launch file of the tree starts the node."""


def unreached_servers(nodes: Nodes) -> Iterator[Unreached]:
    """For each node the first connection that its constructor makes and whose failure nothing takes."""
    for file, cls in nodes.node_classes:
        made, sources = cls.methods.get("__init__"), [each.source for each in nodes.imported(file) or ()]
        if made is None or not any(map(_is_of_mqtt, sources)) or any(each.matches(_WAITS) for each in sources):
            continue
        look = Uncaught(nodes.syntax(file), cls, _REFUSED, partial(_connection, nodes, nodes.syntax(file), cls))
        first = next(look.of(body_of(made.node)), None)
        if first is None or is_restarted(nodes, file) or _is_made_again(nodes, cls) or _has_loops(nodes):
            continue
        programs = (file, *nodes.importers(file.source))
        yield Unreached(file, *first, any(nodes.launched(each) for each in programs))


def _is_of_mqtt(source: Source) -> bool:
    return source.matches(MENTIONED)


def _is_made_again(nodes: Nodes, cls: NodeClass) -> bool:
    """Whether code that makes the node takes the failure, around the call or around the function with the call."""
    for file in nodes.makers(cls):
        syntax = nodes.syntax(file)
        calls = [each for each in file.nodes if isinstance(each, ast.Call)]
        makes = [each for each in calls if called_name(each) == cls.name]
        around = {getattr(syntax.function(each), "name", None) for each in makes} - {"__init__", None}
        makes += [each for each in calls if called_name(each) in around]
        if any(is_caught(syntax, each, _REFUSED) for each in makes):
            return True
    return False


@kept
def _has_loops(nodes: Nodes) -> bool:
    """Whether something of the tree starts programs of ROS again and again by itself."""
    if any(map(_STARTERS.search, nodes.files.tree.paths)):
        return True
    return any(each.matches(_LOOP) for each in nodes.files.of_kind("shell-script", *SUPERVISING))


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
    """Whether a call is ``connect()`` of a client of MQTT that the file makes, and no decorator may repeat it."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr != "connect":
        return False
    around = syntax.function(call)
    return written(function.value) in syntax.once(_clients) and not getattr(around, "decorator_list", None)


def _clients(syntax: Syntax) -> frozenset[str]:
    """What alone holds a client of MQTT, as it is written: ``self.client``."""
    held: dict[str, set[bool]] = {}
    for node in syntax.file.nodes:
        if isinstance(node, ast.Assign) and not (isinstance(node.value, ast.Constant) and node.value.value is None):
            is_client = isinstance(node.value, ast.Call) and syntax.qualified(node.value) == _CLIENT
            for target in node.targets:
                held.setdefault(written(target), set()).add(is_client)
    return frozenset(name for name, kinds in held.items() if name and kinds == {True})
