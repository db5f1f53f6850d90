"""Serial ports that a node uses outside every ``try``, so that an unplugged adapter ends it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.resolved.starting import is_supervised
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.stored_values import module_values
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_PORTS = ("serial.Serial", "serial.serial_for_url")
_READS = frozenset({"read", "readline", "readlines", "read_until", "write"})
_ASKS = frozenset({"in_waiting", "inWaiting", "out_waiting"})
_IMPORTED = regex(r"^[ \t]*(?:import|from)[ \t]+serial\b", re.M)
_ON_BOARD = regex(r"/dev/(?:ttyTHS|ttyAMA|ttyS\d|serial[01]\b)", hints="/dev/ttyTHS /dev/ttyAMA /dev/ttyS /dev/serial")
_ADAPTER = regex(r"/dev/(?:ttyUSB|ttyACM|serial/)", hints="/dev/ttyUSB /dev/ttyACM /dev/serial/")
OF_SYSTEM = frozenset({"OSError", "IOError", "EnvironmentError", "error"})
_OF_LIBRARY = frozenset({"SerialException", "SerialTimeoutException"})


class Unplugged(NamedTuple):
    file: NodeSource
    node: ast.expr
    """What raises."""
    opened: ast.expr
    name: str
    """The function that uses the port."""
    raises: str
    is_thread: bool


def unplugged_ports(nodes: Nodes) -> Iterator[Unplugged]:
    """For each node the first use of a serial port in a callback or thread where nothing takes its exception."""
    for file, cls in nodes.node_classes:
        if not file.source.matches(_IMPORTED) or _is_on_board(file):
            continue
        syntax = nodes.syntax(file)
        bodies = [(*code_of(nodes.ending(file), cls, each), False) for each in cls.callbacks]
        bodies += [(name, body_of(cls.methods[name].node), True) for name in threads(syntax, cls)]
        looks = _looks(syntax, cls)
        found = (
            Unplugged(file, node, opened, name, raises, is_thread)
            for name, body, is_thread in bodies
            for raises, look in looks
            for node, opened in look.of(body)
        )
        first = next(found, None)
        if first is not None and (first.is_thread or not is_restarted(nodes, file)):
            yield first


def _is_on_board(file: NodeSource) -> bool:
    """Whether a file names serial ports of the board alone, which nobody unplugs."""
    return file.source.matches(_ON_BOARD) and not file.source.matches(_ADAPTER)


def _looks(syntax: Syntax, cls: NodeClass) -> list[tuple[str, Uncaught[tuple[ast.expr, ast.expr]]]]:
    """The looks for uses of a port, each after the exception that it raises."""
    return [
        (raises, Uncaught(syntax, cls, caught, partial(use, syntax, cls)))
        for use, caught, raises in (
            (_asked, OF_SYSTEM, "OSError"),
            (_read, OF_SYSTEM | _OF_LIBRARY, "SerialException"),
        )
    ]


def _asked(syntax: Syntax, cls: NodeClass, node: ast.AST) -> tuple[ast.expr, ast.expr] | None:
    """How many bytes wait: pyserial asks the system for it, and hands on its OSError."""
    if not isinstance(node, ast.Attribute) or node.attr not in _ASKS:
        return None
    return _of_port(syntax, cls, node, node.value)


def _read(syntax: Syntax, cls: NodeClass, node: ast.AST) -> tuple[ast.expr, ast.expr] | None:
    function = node.func if isinstance(node, ast.Call) else None
    if not isinstance(node, ast.Call) or not isinstance(function, ast.Attribute) or function.attr not in _READS:
        return None
    return _of_port(syntax, cls, node, function.value)


def _of_port(syntax: Syntax, cls: NodeClass, node: ast.expr, port: ast.expr) -> tuple[ast.expr, ast.expr] | None:
    if is_own(port):
        values = stored(syntax, cls, port)
    elif isinstance(port, ast.Name):
        values = module_values(syntax).get(port.id, [])
    else:
        return None
    opened = [each for each in values if isinstance(each, ast.Call) and syntax.qualified(each) in _PORTS]
    return (node, opened[0]) if opened and len(opened) == len(values) else None


def threads(syntax: Syntax, cls: NodeClass) -> list[str]:
    """The methods that the class starts in threads."""
    calls = (each for each in cls.inner if isinstance(each, ast.Call) and syntax.qualified(each) == "threading.Thread")
    targets = (word.value for each in calls for word in each.keywords if word.arg == "target")
    return [each.attr for each in targets if isinstance(each, ast.Attribute) and each.attr in cls.methods]


def is_restarted(nodes: Nodes, file: NodeSource) -> bool:
    """Whether something may start the program again: ``respawn``, or a unit or container that runs it by itself."""
    programs = [file, *nodes.importers(file.source)]
    launched = [started for each in programs for started in nodes.launched(each)]
    if not launched:
        return any(is_supervised(nodes, each) for each in programs)
    return any("respawn" in each.options or "on_exit" in each.options for each in launched)
