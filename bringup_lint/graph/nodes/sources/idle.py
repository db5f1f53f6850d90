"""What of a node source hardly runs: stubs, functions that nothing calls, and what comes after the work is done."""

from __future__ import annotations

import ast
from collections import defaultdict
from functools import cached_property

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.uncalled.module import BY_NAME
from bringup_lint.graph.uncalled.module import PLAIN_BASES
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk
from bringup_lint.pattern import regex

_DEPTH = 3
"""Functions in a row that nothing else mentions."""
_RUN_BY_OTHERS = regex(r"main$|__\w+__$|on_[a-z]+$|destroy_node$|run$|setup$")
"""Functions that are called by name from elsewhere."""
_QUIET_BASES = PLAIN_BASES | {"Thread", "Enum", "IntEnum"}
"""Bases that call no methods but those."""
_COMPUTED = regex(BY_NAME.format(""), hints="getattr setattr")
_UNFINISHED = regex(r"(?i)not implemented|do not (?:run|use|call)")


def is_idle(syntax: Syntax, node: ast.expr) -> bool:
    """Whether the function is only a stub, or nothing in its file mentions it but functions that nothing mentions."""
    function = syntax.function(node)
    return function is not None and syntax.once(_Idleness).begins(function) < node.lineno


def is_late(syntax: Syntax, node: ast.expr) -> bool:
    """Whether the function spins, or waits for the end of a thread, before: the node has done its work."""
    function = syntax.function(node)
    return function is not None and syntax.once(_Idleness).ends.get(function, node.lineno) < node.lineno


class _Idleness:
    """The idle functions of one file, each asked for once."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax
        self._begins: dict[FunctionNode, float] = {}

    def begins(self, function: FunctionNode) -> float:
        """The line after which a function is idle: 0 when it is as a whole, infinite when it is not."""
        if function not in self._begins:
            names = (each for each in walk(function) if isinstance(each, (ast.Name, ast.Constant)))
            unfinished = (each.lineno for each in names if _says_unfinished(each))
            line = 0 if self._is_unmentioned(function, _DEPTH) else min(unfinished, default=float("inf"))
            self._begins[function] = line
        return self._begins[function]

    @cached_property
    def ends(self) -> dict[FunctionNode, int]:
        """Function -> the first line that waits until the work of the node is done."""
        found: dict[FunctionNode, int] = {}
        for call in self._syntax.calls:
            function = self._syntax.function(call) if _waits_for_the_end(call) else None
            if function is not None:
                found.setdefault(function, call.lineno)
        return found

    @cached_property
    def _users(self) -> dict[str, set[FunctionNode | None]]:
        """Name -> the functions that call or hand over what has it; None: the file itself does."""
        found: dict[str, set[FunctionNode | None]] = defaultdict(set)
        for node in self._syntax.file.nodes:
            name = _mentioned(node)
            if name is not None:
                found[name].add(self._syntax.function(node))
        return found

    def _is_unmentioned(self, function: FunctionNode, depth: int) -> bool:
        if _RUN_BY_OTHERS.match(function.name) or function.decorator_list or self._may_be_called_unseen(function):
            return False
        users = self._users.get(function.name, set()) - {function}
        known = [each for each in users if each is not None and depth]
        return len(known) == len(users) and all(self._is_unmentioned(each, depth - 1) for each in known)

    def _may_be_called_unseen(self, function: FunctionNode) -> bool:
        """Whether the file gets methods by names that it computes, or the class builds on one that calls its own."""
        owner = self._syntax.definition(function)
        return self._reflects or (owner is not None and not self._has_plain_bases(owner))

    @cached_property
    def _reflects(self) -> bool:
        return _COMPUTED.search(self._syntax.file.source.text) is not None

    @cached_property
    def _classes(self) -> dict[str, ast.ClassDef]:
        return {each.name: each for each in self._syntax.file.nodes if isinstance(each, ast.ClassDef)}

    def _has_plain_bases(self, cls: ast.ClassDef, depth: int = _DEPTH) -> bool:
        """Whether a class builds on those of the file and plain ones alone."""
        inner = [self._classes.get(name) for name in map(last_name, cls.bases) if name not in _QUIET_BASES]
        return all(each is not None and depth > 0 and self._has_plain_bases(each, depth - 1) for each in inner)


def _waits_for_the_end(call: ast.Call) -> bool:
    """``join`` of a thread takes nothing, that of a text does."""
    attribute = call.func.attr if isinstance(call.func, ast.Attribute) else ""
    return attribute == "spin" or (attribute == "join" and not call.args)


def _mentioned(node: ast.AST) -> str | None:
    """The function that a node may call or hand over, by itself or as a method; a text may name it."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _says_unfinished(node: ast.Name | ast.Constant) -> bool:
    if isinstance(node, ast.Name):
        return node.id == "NotImplementedError"
    return isinstance(node.value, str) and bool(_UNFINISHED.search(node.value))
