"""Loops of Python nodes that ask again and again whether there is something, and never wait."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_FALLS, _ROUND = "falls", "round"
"""How a block ends when nothing has come: what follows it runs, or the next turn of the loop."""
_RAISE_EMPTY = ("get_nowait", "get")
_EMPTY = frozenset({"Empty", "QueueEmpty", "Exception"})
_LOGS = regex(r"(?i)(?:.*\.)?(?:log|logger|logging|get_logger\(\))\.(?:debug|info|warn|warning|error)|print")
_FLAGS = regex(r"(?:.*\.)?(?:is_set|ok|is_alive|is_open|isOpen)")
"""Calls that only say whether the loop goes on."""
_CLOCKS = ("time.time", "time.monotonic", "time.perf_counter")
_NONE_OF = {"pymavlink": ("recv_match", "recv_msg"), "serial": ("inWaiting",)}
"""Module -> its calls that return nothing, or 0, when nothing has come."""
_PINS = frozenset(("RPi.GPIO.input", "Jetson.GPIO.input", "lgpio.gpio_read", "wiringpi.digitalRead"))
"""Functions that read a pin: which of two values it has nobody knows, and both may last."""
_BLOCKS = ("blocking", "timeout")


class BusyLoop(NamedTuple):
    loop: ast.While
    asked: ast.expr
    """What it asks."""
    reads_pin: bool


def busy_loops(syntax: Syntax) -> Iterator[BusyLoop]:
    for node in syntax.file.nodes:
        if isinstance(node, ast.While) and not node.orelse and not syntax.is_dead(node):
            turn = _Turn(syntax)
            if turn.goes_on(node.test) and turn.block(node.body) is not None and turn.asked:
                asked = turn.asked[0]
                yield BusyLoop(node, asked, isinstance(asked, ast.Call) and syntax.qualified(asked) in _PINS)


class _Turn:
    """One turn of a loop in which nothing has come."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax
        modules = {(dotted or "").partition(".")[0] for dotted in syntax.file.imports.values()}
        self._polls = {name for module, names in _NONE_OF.items() if module in modules for name in names}
        self._has_serial = "serial" in modules
        self._has_queues = not modules.isdisjoint(("queue", "multiprocessing"))
        self._empty: set[str] = set()
        self._levels: dict[str, ast.expr] = {}
        """Name -> the reading of a pin that it has."""
        self.asked: list[ast.expr] = []

    def goes_on(self, test: ast.expr) -> bool:
        """Whether a condition is one that holds until the program ends."""
        if isinstance(test, ast.BoolOp):
            return isinstance(test.op, ast.And) and all(map(self.goes_on, test.values))
        if isinstance(test, ast.UnaryOp):
            return isinstance(test.op, ast.Not) and self.goes_on(test.operand)
        if isinstance(test, ast.Call):
            return not test.args and _FLAGS.fullmatch(written(test.func)) is not None
        return isinstance(test, (ast.Name, ast.Attribute)) or (isinstance(test, ast.Constant) and bool(test.value))

    def block(self, body: list[ast.stmt]) -> str | None:
        """How a block surely ends; None where it may leave the loop, wait or do something."""
        for statement in body:
            ends = self._statement(statement)
            if ends != _FALLS:
                return ends
        return _FALLS

    def _statement(self, statement: ast.stmt) -> str | None:
        if isinstance(statement, ast.Continue):
            return _ROUND
        if isinstance(statement, ast.Pass):
            return _FALLS
        if isinstance(statement, ast.If):
            return self._choice(statement)
        if isinstance(statement, ast.Try):
            return self._tried(statement)
        if isinstance(statement, ast.Assign) and self._is_nothing(statement.value):
            self._empty |= {each.id for each in statement.targets if isinstance(each, ast.Name)}
            return _FALLS
        if isinstance(statement, ast.Assign) and (read := self._pin(statement.value)) is not None:
            self._levels.update((each.id, read) for each in statement.targets if isinstance(each, ast.Name))
        if isinstance(statement, (ast.Assign, ast.AugAssign, ast.Expr)):
            return _FALLS if self._is_quick(statement.value) else None
        return None

    def _choice(self, choice: ast.If) -> str | None:
        holds = self._holds(choice.test)
        if holds is not None:
            return self.block(choice.body if holds else choice.orelse)
        if not self._is_quick(choice.test):
            return None
        if isinstance(choice.body[-1], (ast.Break, ast.Return)):
            return self.block(choice.orelse)
        ways = [self.block(choice.body), self.block(choice.orelse)]
        read = self._pin(choice.test)
        if read is not None and ways != [None, None]:
            self.asked.append(read)
            return _ROUND if _ROUND in ways else _FALLS
        return ways[0] if ways[0] == ways[1] else None

    def _pin(self, value: ast.expr) -> ast.expr | None:
        """The reading of a pin that an expression holds."""
        for each in walk(value):
            if isinstance(each, ast.Call) and self._syntax.qualified(each) in _PINS:
                return each
            if isinstance(each, ast.Name) and each.id in self._levels:
                return self._levels[each.id]
        return None

    def _tried(self, tried: ast.Try) -> str | None:
        """Also where the first statement raises that nothing has come."""
        if tried.orelse or tried.finalbody:
            return None
        asked = self._raises_empty(tried.body[0])
        if asked is None:
            return self.block(tried.body)
        self.asked.append(asked)
        return next((self.block(each.body) for each in tried.handlers if _takes_empty(each)), None)

    def _raises_empty(self, statement: ast.stmt) -> ast.Call | None:
        """The call that raises when a queue is empty."""
        value = statement.value if isinstance(statement, (ast.Assign, ast.Expr)) else None
        function = value.func if isinstance(value, ast.Call) else None
        if not self._has_queues or not isinstance(value, ast.Call) or not isinstance(function, ast.Attribute):
            return None
        given = [*value.args, *(each.value for each in value.keywords if each.arg == "block")]
        waits_not = any(isinstance(each, ast.Constant) and each.value is False for each in given[:1])
        is_get = function.attr == "get" and waits_not and len(value.args) + len(value.keywords) == 1
        return value if is_get or function.attr == "get_nowait" else None

    def _is_nothing(self, value: ast.expr) -> bool:
        """Whether an expression asks for something, and gets None, 0 or nothing."""
        if isinstance(value, ast.Name):
            return value.id in self._empty
        if isinstance(value, ast.Attribute):
            is_asked = value.attr == "in_waiting" and self._has_serial
        else:
            is_asked = isinstance(value, ast.Call) and getattr(value.func, "attr", "") in self._polls
            is_asked = is_asked and not any(_blocks(each) for each in getattr(value, "keywords", ()))
        if is_asked:
            self.asked.append(value)
        return is_asked

    def _holds(self, test: ast.expr) -> bool | None:
        """Whether a condition holds; None when that does not depend on what has come."""
        if self._is_nothing(test):
            return False
        if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
            inner = self._holds(test.operand)
            return None if inner is None else not inner
        if isinstance(test, ast.BoolOp):
            found = [self._holds(each) for each in test.values]
            decides = isinstance(test.op, ast.Or)
            return decides if decides in found else None if None in found else not decides
        if isinstance(test, ast.Compare) and len(test.ops) == 1 and self._is_nothing(test.left):
            right = test.comparators[0]
            known = right.value if isinstance(right, ast.Constant) else ...
            if isinstance(test.ops[0], (ast.Is, ast.IsNot)) and known is None:
                return isinstance(test.ops[0], ast.Is)
            if isinstance(test.ops[0], (ast.Gt, ast.GtE)) and isinstance(known, int):
                return isinstance(test.ops[0], ast.GtE) and known <= 0
        return None

    def _is_quick(self, value: ast.expr) -> bool:
        """Whether an expression surely waits for nothing."""
        for each in walk(value):
            if isinstance(each, (ast.Await, ast.Yield, ast.YieldFrom)):
                return False
            if isinstance(each, ast.Call) and not self._is_quick_call(each):
                return False
        return True

    def _is_quick_call(self, call: ast.Call) -> bool:
        name = written(call.func)
        if name.rpartition(".")[2] == "spin_once":
            given = [each.value for each in call.keywords if each.arg == "timeout_sec"]
            return len(given) == 1 and isinstance(given[0], ast.Constant) and given[0].value == 0
        qualified = self._syntax.qualified(call)
        if _LOGS.fullmatch(name) or qualified in _CLOCKS or qualified in _PINS or name.endswith("get_logger"):
            return True
        return not call.args and _FLAGS.fullmatch(name) is not None


def _takes_empty(handler: ast.ExceptHandler) -> bool:
    names = {getattr(each, "attr", getattr(each, "id", None)) for each in walk(handler.type or ast.Name("Exception"))}
    return not _EMPTY.isdisjoint(names)


def _blocks(keyword: ast.keyword) -> bool:
    value = keyword.value
    return keyword.arg in _BLOCKS and not (isinstance(value, ast.Constant) and not value.value)
