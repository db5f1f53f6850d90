"""Signal handlers of Python programs that take the place of those of rclpy and do not end the spin."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.questions.ending.stopping import surely_after
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.ending import Handler
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_self
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_PLAIN = frozenset({"print", "len", "str", "int", "float", "abs", "min", "max", "range", "round", "getattr", "hasattr"})
_DRIVERS = ("pigpio", "serial", "gpiozero", "smbus", "smbus2", "can", "RPi", "Jetson", "lgpio", "gpiod", "adafruit_")
"""Libraries whose objects may be stopped and closed while the program goes on."""


class DeafHandler(NamedTuple):
    call: ast.Call
    signals: frozenset[str]
    spin: ast.Call


def deaf_handlers(ending: Ending) -> Iterator[DeafHandler]:
    direct = [spin for spin in ending.spins if not spin.loop]
    if not direct or len(direct) < len(ending.spins) or ending.signals != "rclpy":
        return
    for handler in ending.handlers:
        cls = ending.syntax.class_of(handler.call)
        if cls is not None and handler.python and surely_after(ending, handler.call):
            body = _body(cls, handler)
            if body and not any(_may_end(ending, cls, each) for each in reached(ending.syntax, body, cls)):
                yield DeafHandler(handler.call, handler.signals, direct[0].call)


def _body(cls: NodeClass, handler: Handler) -> list[ast.AST]:
    if isinstance(handler.handler, ast.Lambda):
        return [handler.handler.body]
    method = cls.methods.get(handler.handler.attr) if isinstance(handler.handler, ast.Attribute) else None
    return body_of(method.node) if method is not None else []


def _may_end(ending: Ending, cls: NodeClass, node: ast.AST, depth: int = 2) -> bool:
    if isinstance(node, (ast.Raise, ast.Global, ast.Await)):
        return True
    if not isinstance(node, ast.Call):
        return False
    function = node.func
    if isinstance(function, ast.Name):
        inner = [each for each in cls.inner if isinstance(each, ast.FunctionDef) and each.name == function.id]
        if len(inner) == 1 and depth:
            return any(_may_end(ending, cls, each, depth - 1) for each in own(inner[0].body))
        return function.id not in _PLAIN
    if not isinstance(function, ast.Attribute):
        return True
    if is_self(function.value):
        return function.attr not in (*cls.methods, "get_logger")
    return not _is_of_driver(ending, cls, function) and not written(function.value).endswith("get_logger()")


def _is_of_driver(ending: Ending, cls: NodeClass, function: ast.Attribute) -> bool:
    made = stored(ending.syntax, cls, function.value)
    names = [written(each.func) if isinstance(each, ast.Call) else "" for each in made]
    return bool(names) and all(name.startswith(_DRIVERS) for name in names)
