"""What an exception that nothing catches ends: the program, one of its threads, or all callbacks."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable
from functools import cached_property

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk
from bringup_lint.pattern import regex

_TAKES = regex(r"create_|add_|register|set_\w+_callback|\w*(?:Subscriber|Action(?:Server|Client)|Synchronizer|Updater)")
"""Functions and classes of ROS that take callbacks."""
EXITS = "the node exits"
PROGRAM = "the program ends"
THREAD = "its thread ends, while the node goes on"
THREAD_ALONE = "its thread ends, while the program goes on"
SPINNING = "the thread that spins ends: no callback runs any more"
CALLBACK = "the callback goes no further"
"""Of a MultiThreadedExecutor, which older releases do not let an exception out of."""
CALLER = "what called it gets the exception"
TRY_BLOCK = "what follows in its try block never runs"


def end_of(syntax: Syntax, node: ast.AST, *, caught: bool = False) -> str:
    """What ends where a node of the syntax raises, in words. ``caught``: a handler around it takes the exception."""
    if caught:
        return TRY_BLOCK
    function = syntax.function(node)
    threads = syntax.once(_Threads)
    if not syntax.once(_knows_ros):
        if function in threads.own:
            return THREAD_ALONE
        ends = function is None or (function in threads.of_main and syntax.file.main is not None)
        return PROGRAM if ends else CALLER
    if function is None or function in threads.of_main:
        return EXITS
    if function in threads.own:
        return THREAD
    return threads.end_of_callbacks if function in threads.of_callbacks else threads.end_of_others


def _knows_ros(syntax: Syntax) -> bool:
    """Whether a file has to do with nodes itself, and is no module or program beside them."""
    imported = (name or "" for name in syntax.file.imports.values())
    return bool(syntax.file.classes) or any(name.startswith("rclpy") for name in imported)


def end_where_called(syntax: Syntax, node: ast.AST) -> str:
    """As ``end_of``, but of what is handed to code that is none of ROS only that this code gets the exception."""
    threads, function = syntax.once(_Threads), syntax.function(node)
    handed = function in threads.of_callbacks and function not in threads.of_main | threads.own
    return CALLER if handed and function not in threads.of_ros else end_of(syntax, node)


def end_of_callbacks(syntax: Syntax) -> str:
    """What ends where a callback raises, in words."""
    return syntax.once(_Threads).end_of_callbacks


class _Threads:
    """Which functions of one file run in which threads."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax

    @cached_property
    def of_main(self) -> set[FunctionNode]:
        """``main``, constructors, what the file calls, and what these call: all in the thread of the program."""
        begin = {"main", "__init__", *self._calls[None]}
        return self._reached(each for name in begin for each in self._named[name])

    @cached_property
    def of_callbacks(self) -> set[FunctionNode]:
        """What the file hands over, and what it calls."""
        return self._reached(each for name in self._handed_over for each in self._named[name])

    @cached_property
    def of_ros(self) -> set[FunctionNode]:
        """What the file hands to ROS, and what it calls."""
        takers = (each for each in self._syntax.calls if _TAKES.match(last_name(each.func)))
        given = (
            each
            for call in takers
            for value in (call.args + [word.value for word in call.keywords])
            for each in walk(value)
        )
        return self._reached(each for name in map(last_name, given) for each in self._named[name])

    def _reached(self, begin: Iterable[FunctionNode]) -> set[FunctionNode]:
        found: set[FunctionNode] = set()
        todo = list(begin)
        while todo:
            function = todo.pop()
            if function not in found:
                found.add(function)
                todo.extend(each for name in self._calls[function] for each in self._named[name])
        return found

    @cached_property
    def own(self) -> set[FunctionNode]:
        """What runs only in threads that the file starts for it, or for all that mention it."""
        waits = {name: len(users) for name, users in self._users.items()}
        mentions: dict[FunctionNode | None, list[str]] = defaultdict(list)
        for name, users in self._users.items():
            for user in users:
                mentions[user].append(name)
        todo = [each for name in self._begun for each in self._named[name] if not waits.get(name)]
        todo += [each for each in self._named["run"] if self._is_thread(each) and not waits.get("run")]
        found: set[FunctionNode] = set()
        while todo:
            function = todo.pop()
            if function not in found:
                found.add(function)
                for name in mentions[function]:
                    waits[name] -= 1
                    todo.extend(self._named[name] if not waits[name] else ())
        return found

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
        handed = {each for given in self._given for each in walk(given)}
        spins = [each for each in self._syntax.calls if last_name(each.func).startswith("spin")]
        own = [each for each in spins if each not in handed and self._syntax.function(each) not in self.own]
        return not own and (bool(spins) or any(last_name(each) == "spin" for each in handed))

    def _is_thread(self, function: FunctionNode) -> bool:
        """Whether a method is one of a class of threads."""
        owner = self._syntax.definition(function)
        return owner is not None and any(last_name(base) == "Thread" for base in owner.bases)

    @cached_property
    def _named(self) -> dict[str, list[FunctionNode]]:
        found: dict[str, list[FunctionNode]] = defaultdict(list)
        for node in self._syntax.file.nodes:
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                found[node.name].append(node)
        return found

    @cached_property
    def _given(self) -> list[ast.expr]:
        """What the file hands to threads."""
        calls = [call for call in self._syntax.calls if last_name(call.func) in ("Thread", "submit")]
        targets = [word.value for call in calls for word in call.keywords if word.arg == "target"]
        return targets + [call.args[0] for call in calls if last_name(call.func) == "submit" and call.args]

    @property
    def _begun(self) -> set[str]:
        return {last_name(each) for each in self._given}

    @cached_property
    def _users(self) -> dict[str, set[FunctionNode | None]]:
        """Name -> the functions that call or hand over what has it, but to a thread; None: the file itself does."""
        found: dict[str, set[FunctionNode | None]] = defaultdict(set)
        given = set(self._given)
        for node in self._syntax.file.nodes:
            if _is_read(node) and node not in given:
                function = self._syntax.function(node)
                if function is None or function.name != last_name(node):
                    found[last_name(node)].add(function)
        return found

    @cached_property
    def _calls(self) -> dict[FunctionNode | None, set[str]]:
        """Function -> what it calls at once; None: the file itself."""
        found: dict[FunctionNode | None, set[str]] = defaultdict(set)
        for call in self._syntax.calls:
            if not self._is_in_lambda(call):
                found[self._syntax.function(call)].add(last_name(call.func))
        return found

    @cached_property
    def _handed_over(self) -> set[str]:
        """The names of what is not called where it is mentioned, but may be called later."""
        given = set(self._given)
        now = {call.func for call in self._syntax.calls if not self._is_in_lambda(call)} | given
        return {last_name(node) for node in self._syntax.file.nodes if _is_read(node) and node not in now}

    def _is_in_lambda(self, node: ast.AST) -> bool:
        return any(isinstance(outer, ast.Lambda) for outer, _ in self._syntax.above(node))


def _is_read(node: ast.AST) -> bool:
    return isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Load)
