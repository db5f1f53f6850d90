"""Serial ports that a node uses outside every ``try``, so that an unplugged adapter ends it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cached_property
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.resolved.starting import is_supervised
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.drivers import Driver
from bringup_lint.graph.nodes.sources.drivers import driver_of
from bringup_lint.graph.nodes.sources.drivers import first_uncaught
from bringup_lint.graph.nodes.sources.drivers import made_of
from bringup_lint.graph.nodes.sources.stored_values import module_values
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.uncaught import Uncaught
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_PORTS = ("serial.Serial", "serial.serial_for_url")
_READS = frozenset({"read", "readline", "readlines", "read_until", "write"})
_ASKS = frozenset({"in_waiting", "inWaiting", "out_waiting"})
_IMPORTED = regex(r"^[ \t]*(?:import|from)[ \t]+serial\b", re.M)
_ON_BOARD = regex(r"/dev/(?:ttyTHS|ttyAMA|ttyS\d|serial[01]\b)", hints="/dev/ttyTHS /dev/ttyAMA /dev/ttyS /dev/serial")
_ADAPTER = regex(r"/dev/(?:ttyUSB|ttyACM|serial/)", hints="/dev/ttyUSB /dev/ttyACM /dev/serial/")
OF_SYSTEM = frozenset({"OSError", "IOError", "EnvironmentError", "error"})
_OF_PORT = OF_SYSTEM | {"SerialException", "SerialTimeoutException"}
_Use = tuple[ast.expr, Span]
"""What raises, and where the port is opened."""


class Unplugged(NamedTuple):
    file: NodeSource
    node: ast.expr
    """What raises."""
    opened: Span
    name: str
    """The function that uses the port."""
    raises: str
    is_thread: bool


def unplugged_ports(nodes: Nodes) -> Iterator[Unplugged]:
    """For each node the first use of a serial port in a callback or thread where nothing takes its exception."""
    drivers = _Drivers(nodes)
    for file, cls in nodes.node_classes:
        if _is_on_board(file) or not any(each.source.matches(_IMPORTED) for each in nodes.imported(file) or ()):
            continue
        syntax = nodes.syntax(file)
        bodies = [(*code_of(nodes.ending(file), cls, each), False) for each in cls.callbacks]
        bodies += [(name, body_of(cls.methods[name].node), True) for name in threads(syntax, cls)]
        looks = _looks(drivers, syntax, cls)
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


def _looks(drivers: _Drivers, syntax: Syntax, cls: NodeClass) -> list[tuple[str, Uncaught[_Use]]]:
    """The looks for uses of a port, each after the exception that it raises."""
    return [
        (raises, Uncaught(syntax, cls, caught, use))
        for use, caught, raises in (
            (partial(_asked, syntax, cls), OF_SYSTEM, "OSError"),
            (partial(_read, syntax, cls), _OF_PORT, "SerialException"),
            (partial(_in_driver, drivers, syntax, cls), _OF_PORT, "SerialException"),
        )
    ]


def _asked(syntax: Syntax, cls: NodeClass, node: ast.AST) -> _Use | None:
    """How many bytes wait: pyserial asks the system for it, and hands on its OSError."""
    if not isinstance(node, ast.Attribute) or node.attr not in _ASKS:
        return None
    return _of_port(syntax, cls, node, node.value)


def _read(syntax: Syntax, cls: NodeClass, node: ast.AST) -> _Use | None:
    function = node.func if isinstance(node, ast.Call) else None
    if not isinstance(node, ast.Call) or not isinstance(function, ast.Attribute) or function.attr not in _READS:
        return None
    return _of_port(syntax, cls, node, function.value)


def _of_port(syntax: Syntax, cls: NodeClass, node: ast.expr, port: ast.expr) -> _Use | None:
    if is_own(port):
        values = stored(syntax, cls, port)
    elif isinstance(port, ast.Name):
        values = module_values(syntax).get(port.id, [])
    else:
        return None
    opened = _opened(syntax, values)
    return (node, syntax.file.span_of(opened)) if opened is not None else None


def _opened(syntax: Syntax, values: list[ast.expr | None]) -> ast.Call | None:
    """The first call that opens a port, where all values but None are such calls."""
    opened = [each for each in values if isinstance(each, ast.Call) and syntax.qualified(each) in _PORTS]
    return opened[0] if opened and len(opened) == len(values) else None


def _in_driver(drivers: _Drivers, syntax: Syntax, cls: NodeClass, node: ast.AST) -> _Use | None:
    """A call of a method of another class of the workspace, which uses a port that its object keeps."""
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
        return None
    made = made_of(syntax, cls, node.func.value)
    driver = drivers.of(syntax, made) if made is not None else None
    opened = driver.opened(node.func.attr) if driver is not None else None
    return (node, opened) if opened is not None else None


class _Drivers:
    """The classes of the workspace whose objects use ports, each looked at once for all nodes."""

    def __init__(self, nodes: Nodes) -> None:
        self._nodes = nodes
        self._made: dict[tuple[NodeSource, str | None, str], _PortDriver | None] = {}
        self._known: dict[tuple[ast.FunctionDef, ...], _PortDriver] = {}

    def of(self, syntax: Syntax, made: ast.Call) -> _PortDriver | None:
        """The class whose object a call makes."""
        key = (syntax.file, syntax.qualified(made), made.func.id if isinstance(made.func, ast.Name) else "")
        if key not in self._made:
            self._made[key] = self._of(syntax.file, made)
        return self._made[key]

    def _of(self, file: NodeSource, made: ast.Call) -> _PortDriver | None:
        driver = driver_of(self._nodes, file, made)
        if driver is None or not driver.file.source.matches(_IMPORTED) or _is_on_board(driver.file):
            return None
        return self._known.setdefault(tuple(driver.methods.values()), _PortDriver(self._nodes, driver))


class _PortDriver:
    """A class that may use ports: what it opens, and what each of its methods uses, is looked for once."""

    def __init__(self, nodes: Nodes, driver: Driver) -> None:
        self._nodes = nodes
        self._driver = driver

    @cached_property
    def _opened(self) -> dict[str, ast.Call]:
        return _ports(self._nodes.syntax(self._driver.file), self._driver)

    @memo
    def opened(self, method: str) -> Span | None:
        """Where the port is opened that a method uses where nothing takes its exception."""
        ports = self._opened
        used = first_uncaught(self._nodes, self._driver, method, _OF_PORT, lambda call: _port_used(call) in ports)
        return self._driver.file.span_of(ports[_port_used(used)]) if used is not None else None


def _port_used(call: ast.Call) -> str:
    """The attribute whose method to read or write is called: ``self.port``; empty where it is none."""
    function = call.func
    is_use = isinstance(function, ast.Attribute) and function.attr in _READS and is_own(function.value)
    return written(function.value) if is_use else ""  # type: ignore[attr-defined]


def _ports(syntax: Syntax, driver: Driver) -> dict[str, ast.Call]:
    """The attributes that hold nothing but ports, each with the first call that opens it."""
    values: dict[str, list[ast.expr | None]] = {}
    for node in own(each for method in driver.methods.values() for each in method.body):
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and not _is_none(node.value):
            for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                if is_own(target):
                    values.setdefault(written(target), []).append(node.value)
    opened = {name: _opened(syntax, given) for name, given in values.items()}
    return {name: call for name, call in opened.items() if call is not None}


def _is_none(value: ast.expr | None) -> bool:
    return isinstance(value, ast.Constant) and value.value is None


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
