"""What an exception that nothing catches ends: the program, one of its threads, or all callbacks."""

from __future__ import annotations

import ast
from collections import defaultdict
from functools import cached_property
from typing import Union

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import walk

Function = Union[ast.FunctionDef, ast.AsyncFunctionDef]

EXITS = "the node exits"
THREAD = "its thread ends, while the node goes on"
SPINNING = "the thread that spins ends: no callback runs any more"
CALLBACK = "the callback goes no further"
"""Of a MultiThreadedExecutor, which older releases do not let an exception out of."""
CALLER = "what called it gets the exception"
_DEPTH = 3
"""Functions in a row that call each other."""


def end_of(syntax: Syntax, node: ast.AST) -> str:
    """What ends where a node of the syntax raises, in words."""
    function = syntax.function(node)
    threads = syntax.once(_Threads)
    if function is None or threads.is_of_main(function, _DEPTH):
        return EXITS
    if threads.has(function, _DEPTH):
        return THREAD
    return threads.end_of_callbacks if threads.is_of_callback(function, _DEPTH) else threads.end_of_others


def end_of_callbacks(syntax: Syntax) -> str:
    """What ends where a callback raises, in words."""
    return syntax.once(_Threads).end_of_callbacks


class _Threads:
    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax

    def has(self, function: Function, depth: int) -> bool:
        """Whether a function runs only in threads that the file starts for it, or for what calls it."""
        users = self._users.get(function.name, set()) - {function}
        if any(each is None for each in users) or not (users or self._is_handed(function)):
            return False
        return not users or (depth > 0 and all(self.has(each, depth - 1) for each in users if each is not None))

    def is_of_main(self, function: Function, depth: int) -> bool:
        """Whether the thread of the program itself calls a function: ``main``, a constructor, and what these call."""
        callers = self._callers.get(function.name, set()) - {function}
        if function.name in ("main", "__init__") or None in callers:
            return True
        return depth > 0 and any(self.is_of_main(each, depth - 1) for each in callers if each is not None)

    def is_of_callback(self, function: Function, depth: int) -> bool:
        """Whether the file hands a function over, or what calls it."""
        if function.name in self._handed_over:
            return True
        callers = self._callers.get(function.name, set()) - {function}
        return depth > 0 and any(self.is_of_callback(each, depth - 1) for each in callers if each is not None)

    @cached_property
    def end_of_others(self) -> str:
        """What ends where a function raises of which it is not known what calls it."""
        return CALLER if self._spins_aside else EXITS

    @cached_property
    def end_of_callbacks(self) -> str:
        if self._spins_aside:
            return SPINNING
        return CALLBACK if "MultiThreadedExecutor" in self._syntax.file.source.text else EXITS

    @cached_property
    def _spins_aside(self) -> bool:
        """Whether a thread spins, and the program itself does not."""
        handed = [each for given in self._given for each in walk(given)]
        spins = [each for each in self._syntax.calls if _name(each.func).startswith("spin")]
        own = [each for each in spins if each not in handed and not self._is_of_thread(each)]
        return not own and (len(own) < len(spins) or any(_name(each) == "spin" for each in handed))

    def _is_of_thread(self, node: ast.AST) -> bool:
        function = self._syntax.function(node)
        return function is not None and self.has(function, _DEPTH)

    def _is_handed(self, function: Function) -> bool:
        if function.name == "run":
            owner = self._syntax.definition(function)
            return owner is not None and any(_name(base) == "Thread" for base in owner.bases)
        return any(_name(each) == function.name for each in self._given)

    @cached_property
    def _given(self) -> list[ast.expr]:
        """What the file hands to threads."""
        calls = [call for call in self._syntax.calls if _name(call.func) in ("Thread", "submit")]
        targets = [word.value for call in calls for word in call.keywords if word.arg == "target"]
        return targets + [call.args[0] for call in calls if _name(call.func) == "submit" and call.args]

    @cached_property
    def _users(self) -> dict[str, set[Function | None]]:
        """Name -> the functions that call or hand over what has it, but to a thread; None: the file itself does."""
        found: dict[str, set[Function | None]] = defaultdict(set)
        given = set(self._given)
        for node in self._syntax.file.nodes:
            if _is_read(node) and node not in given:
                found[_name(node)].add(self._syntax.function(node))
        return found

    @cached_property
    def _callers(self) -> dict[str, set[Function | None]]:
        found: dict[str, set[Function | None]] = defaultdict(set)
        for call in self._syntax.calls:
            if not self._is_in_lambda(call):
                found[_name(call.func)].add(self._syntax.function(call))
        return found

    @cached_property
    def _handed_over(self) -> frozenset[str]:
        """The names of what is not called where it is mentioned, but may be called later."""
        given = set(self._given)
        now = {call.func for call in self._syntax.calls if not self._is_in_lambda(call)} | given
        return frozenset(_name(node) for node in self._syntax.file.nodes if _is_read(node) and node not in now)

    def _is_in_lambda(self, node: ast.AST) -> bool:
        return any(isinstance(outer, ast.Lambda) for outer, _ in self._syntax.above(node))


def _is_read(node: ast.AST) -> bool:
    return isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Load)


def _name(node: ast.expr | ast.AST) -> str:
    """The last part of a dotted name; empty for anything else."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""
