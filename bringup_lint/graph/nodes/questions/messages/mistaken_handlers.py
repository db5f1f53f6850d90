"""Calls in a ``try`` that takes other exceptions than those which the calls raise."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.uncaught import is_caught
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

_AT_END = frozenset({"KeyboardInterrupt", "SystemExit"})
_KNOWN = frozenset(name for name in dir(builtins) if name.endswith(("Error", "Iteration"))) | {
    "JSONDecodeError",
    "timeout",
}
_OF_SYSTEM = frozenset({"OSError", "IOError", "EnvironmentError", "error"})
_REFUSED = _OF_SYSTEM | {"ConnectionError", "ConnectionRefusedError"}
_JOYSTICK = ("axes", "buttons")


class Raised(NamedTuple):
    """What a call raises, and what to do instead."""

    what: str
    """``next() raises StopIteration where nothing matches``."""
    takers: frozenset[str]
    """The exceptions of which a handler takes it."""
    advice: str


_NEXT = Raised(
    "next() raises StopIteration where nothing matches",
    frozenset({"StopIteration"}),
    "give next() a default, as in next((...), None), and ask for it",
)
_PORT = Raised(
    "serial.Serial() raises SerialException where the port is missing or busy",
    _OF_SYSTEM | {"SerialException"},
    "catch serial.SerialException",
)
_CONNECT = Raised(
    "connect() raises ConnectionRefusedError where nothing listens, and OSError without a route",
    _REFUSED,
    "catch OSError, of which the timeout is one too",
)
_INDEX = Raised(
    "A joystick with fewer axes or buttons raises IndexError",
    frozenset({"IndexError", "LookupError"}),
    "catch IndexError: the arrays of a message have positions and no keys",
)


class MistakenHandler(NamedTuple):
    node: ast.expr
    raised: Raised
    handler: ast.ExceptHandler


def mistaken_handlers(syntax: Syntax) -> Iterator[MistakenHandler]:
    """The places where a ``try`` is written for the wrong exception."""
    places: list[ast.Call | ast.Subscript] = [*syntax.calls, *_subscripts(syntax)]
    for node in places:
        raised = _raised(syntax, node)
        if raised is None or is_caught(syntax, node, raised.takers):
            continue
        handlers = next(_around(syntax, node), [])
        if handlers and (raised is _NEXT or _are_others(handlers)) and (raised is not _INDEX or _takes_key(handlers)):
            yield MistakenHandler(node, raised, handlers[0])


def _subscripts(syntax: Syntax) -> Iterator[ast.Subscript]:
    if any(f".{each}[" in syntax.file.source.text for each in _JOYSTICK):
        yield from (each for each in syntax.file.nodes if isinstance(each, ast.Subscript))


def _raised(syntax: Syntax, node: ast.Call | ast.Subscript) -> Raised | None:
    if isinstance(node, ast.Subscript):
        is_joystick = isinstance(node.value, ast.Attribute) and node.value.attr in _JOYSTICK
        return (
            _INDEX if is_joystick and isinstance(node.ctx, ast.Load) and not isinstance(node.slice, ast.Slice) else None
        )
    if syntax.qualified(node) in ("serial.Serial", "serial.serial_for_url"):
        return _PORT if node.args or any(each.arg == "port" for each in node.keywords) else None
    if isinstance(node.func, ast.Attribute):
        is_socket = node.func.attr == "connect" and _is_socket(syntax, node, node.func.value)
        return _CONNECT if is_socket else None
    return _NEXT if isinstance(node.func, ast.Name) and node.func.id == "next" and _may_miss(node) else None


def _is_socket(syntax: Syntax, call: ast.Call, owner: ast.expr) -> bool:
    return syntax.file.named(owner, syntax.function(call)) == "socket.socket"


def _may_miss(call: ast.Call) -> bool:
    """Whether a search may find nothing."""
    given = call.args[0] if len(call.args) == 1 else None
    return isinstance(given, ast.GeneratorExp) and any(each.ifs for each in given.generators)


def _around(syntax: Syntax, node: ast.expr) -> Iterator[list[ast.ExceptHandler]]:
    for outer, name in syntax.within(node):
        if isinstance(outer, ast.Try) and name == "body" and outer.handlers:
            yield outer.handlers


def _are_others(handlers: list[ast.ExceptHandler]) -> bool:
    """Whether handlers are for errors, and all of them for known ones."""
    names = _names(handlers)
    return names <= _KNOWN | _AT_END and not names <= _AT_END


def _takes_key(handlers: list[ast.ExceptHandler]) -> bool:
    return "KeyError" in _names(handlers)


def _names(handlers: list[ast.ExceptHandler]) -> set[str]:
    parts = (part for each in handlers if each.type is not None for part in walk(each.type))
    named = (each.id if isinstance(each, ast.Name) else getattr(each, "attr", "") for each in parts)
    return {name for name in named if name} - {"json", "socket"}
