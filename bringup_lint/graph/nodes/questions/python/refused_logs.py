"""Calls of a logger of rclpy that raise an exception instead of writing a line."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.what_ends import EXITS
from bringup_lint.graph.nodes.sources.what_ends import TRY_BLOCK
from bringup_lint.graph.nodes.sources.what_ends import end_where_called
from bringup_lint.model.python import last_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.model.node_source import NodeClass

_ALWAYS = frozenset({"info", "warn", "warning", "error", "fatal"})
"""The levels that are on unless somebody raises the level: the message is written, and must be a text."""
_LEVELS = _ALWAYS | {"debug"}
_OPTIONS = frozenset({"name", "once", "skip_first", "throttle_duration_sec", "throttle_time_source_type"})
_NUMBERS = frozenset({"len", "int", "float", "list", "dict", "tuple", "set"})
"""Functions of Python that make no text."""
_PLACEHOLDER = regex(r"%(?:%|[-+ #0]{0,4}\d{0,4}(?:\.\d{1,4})?[sdrifgexX])")
_LOOPS = (ast.For, ast.AsyncFor, ast.While)
CAUGHT = frozenset({"TypeError", "Exception", "BaseException"})
_ENDING = frozenset({"sys.exit", "os._exit", "rclpy.shutdown", "rclpy.try_shutdown"})
HANDLED = "the line is lost, and the except block runs"
EXITS_THERE = "the except block runs, and ends the node"


class RefusedLog(NamedTuple):
    call: ast.Call
    kind: str
    """``arguments``, ``message`` or ``option``."""
    what: ast.expr | ast.keyword
    """The first argument too many, the message, or the option."""
    end: str
    """What the exception ends, in words."""

    @property
    def ends_node(self) -> bool:
        return self.end in (EXITS, EXITS_THERE)

    @property
    def formats(self) -> bool:
        """Whether the message is a literal with a placeholder for each further argument."""
        message = self.call.args[0]
        if not isinstance(message, ast.Constant) or not isinstance(message.value, str):
            return False
        places = [each for each in _PLACEHOLDER.findall(message.value) if each != "%%"]
        return len(places) == len(self.call.args) - 1


def refused_logs(syntax: Syntax) -> Iterator[RefusedLog]:
    """The calls of loggers with arguments that rclpy does not take."""
    loggers = _Loggers(syntax)
    for call in syntax.calls:
        level = call.func.attr if isinstance(call.func, ast.Attribute) else ""
        if level in _LEVELS and isinstance(call.func, ast.Attribute) and not syntax.is_dead(call):
            found = _wrong(syntax, call, level)
            if found is not None and loggers.has(call.func.value):
                yield RefusedLog(call, *found, _end(syntax, call))


def _end(syntax: Syntax, call: ast.Call) -> str:
    handler = syntax.handler(call, CAUGHT)
    if handler is None:
        return end_where_called(syntax, call)
    if any(isinstance(each, ast.Expr) and _exits(syntax, each.value) for each in handler.body):
        return EXITS_THERE if end_where_called(syntax, call) == EXITS else HANDLED
    return HANDLED if _ends_try(syntax, call, handler) else TRY_BLOCK


def _exits(syntax: Syntax, call: ast.expr) -> bool:
    return isinstance(call, ast.Call) and syntax.qualified(call) in _ENDING


def _ends_try(syntax: Syntax, call: ast.Call, handler: ast.ExceptHandler) -> bool:
    """Whether a call is the last that the ``try`` of a handler does, once."""
    inner: ast.AST = call
    for outer, _ in syntax.within(call):
        if isinstance(inner, ast.stmt) and syntax.after(inner):
            return False
        if isinstance(outer, ast.Try) and handler in outer.handlers:
            return not outer.orelse
        if isinstance(outer, _LOOPS):
            return False
        inner = outer
    return False


def _wrong(syntax: Syntax, call: ast.Call, level: str) -> tuple[str, ast.expr | ast.keyword] | None:
    if any(isinstance(each, ast.Starred) for each in call.args) or not call.args:
        return None
    if len(call.args) > 1:
        return "arguments", call.args[1]
    if level not in _ALWAYS:
        return None
    if _is_no_text(syntax, call.args[0]):
        return "message", call.args[0]
    option = next((each for each in call.keywords if each.arg is not None and each.arg not in _OPTIONS), None)
    return ("option", option) if option is not None else None


def _is_no_text(syntax: Syntax, message: ast.expr) -> bool:
    if isinstance(message, ast.Constant):
        return message.value is not None and not isinstance(message.value, (str, bytes))
    if isinstance(message, ast.Name):
        return _is_exception(syntax, message)
    if isinstance(message, ast.Call):
        return isinstance(message.func, ast.Name) and message.func.id in _NUMBERS
    return isinstance(message, (ast.List, ast.Tuple, ast.Dict, ast.Set))


def _is_exception(syntax: Syntax, name: ast.Name) -> bool:
    """Whether a name is that of the exception which a handler around it caught, and nothing in it sets it anew."""
    outers = (outer for outer, _ in syntax.within(name) if isinstance(outer, ast.ExceptHandler))
    handler = next((each for each in outers if each.name == name.id), None)
    if handler is None:
        return False
    inner = (each for statement in handler.body for each in ast.walk(statement))
    return not any(
        isinstance(each, ast.Name) and each.id == name.id and not isinstance(each.ctx, ast.Load) for each in inner
    )


def _takes_logger_of_rclpy(node: NodeClass) -> bool:
    """Whether all classes that a node builds on are known, and none has a ``get_logger`` of its own."""
    for each in node.lineage:
        others = [base for base in each.bases if base.partition(".")[0] != "rclpy"]
        if "get_logger" in each.methods or len(others) > (each.base is not None):
            return False
    return True


def _is_called_node(value: ast.expr) -> bool:
    """Whether a variable or attribute has the name of a node: other things have loggers too."""
    return "node" in last_name(value).lower()


class _Loggers:
    """What is a logger of rclpy in one file."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax

    def has(self, value: ast.expr) -> bool:
        if isinstance(value, ast.Call):
            return self._is_made(value)
        if not isinstance(value, (ast.Name, ast.Attribute)) or self._is_imported(value):
            return False
        kept = self._kept.get(written(value), [])
        is_made = bool(kept) and all(isinstance(each, ast.Call) and self._is_made(each) for each in kept)
        return is_made and (isinstance(value, ast.Name) or self._is_of_same_class(value, kept))

    def _is_of_same_class(self, value: ast.Attribute, kept: list[ast.AST]) -> bool:
        """Whether the class that uses an attribute of its own also sets it: one of a base may be another logger."""
        return any(self._syntax.definition(value) is self._syntax.definition(each) for each in kept)

    def _is_made(self, call: ast.Call) -> bool:
        """``rclpy.logging.get_logger(name)``, and ``get_logger()`` of a node."""
        if self._syntax.qualified(call) == "rclpy.logging.get_logger":
            return True
        if not isinstance(call.func, ast.Attribute) or call.func.attr != "get_logger" or call.args or self._is_own:
            return False
        owner = call.func.value
        if isinstance(owner, ast.Name) and owner.id == "self":
            node = self._syntax.class_of(call)
            return node is not None and node.is_node is True and _takes_logger_of_rclpy(node)
        return self._uses_rclpy and _is_called_node(owner) and not self._is_imported(owner)

    def _is_imported(self, value: ast.expr) -> bool:
        while isinstance(value, ast.Attribute):
            value = value.value
        return isinstance(value, ast.Name) and value.id in self._syntax.file.imports

    @cached_property
    def _is_own(self) -> bool:
        """Whether the file says itself what ``get_logger()`` is."""
        return "get_logger" in self._defined or "self.get_logger" in self._kept

    @cached_property
    def _uses_rclpy(self) -> bool:
        return any((name or "").partition(".")[0] == "rclpy" for name in self._syntax.file.imports.values())

    @cached_property
    def _defined(self) -> frozenset[str]:
        """The functions and methods of the file."""
        functions = (each for each in self._syntax.file.nodes if isinstance(each, ast.FunctionDef))
        return frozenset(each.name for each in functions)

    @cached_property
    def _kept(self) -> dict[str, list[ast.AST]]:
        """A variable or attribute -> all that the file keeps in it; parameters keep what is not known."""
        found: dict[str, list[ast.AST]] = {}
        for node in self._syntax.file.nodes:
            if isinstance(node, ast.arg):
                found.setdefault(node.arg, []).append(node)
            elif isinstance(node, (ast.Name, ast.Attribute)) and not isinstance(node.ctx, ast.Load):
                outer = next(self._syntax.above(node), (node, ""))[0]
                value = outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None
                found.setdefault(written(node), []).append(value if value is not None else outer)
        return found
