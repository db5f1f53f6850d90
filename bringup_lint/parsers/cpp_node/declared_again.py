"""Parameters of a C++ file that each transition "configure" declares, although the node has them since the first."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_text import plain_of
from bringup_lint.model.declared_again import GUARD
from bringup_lint.model.declared_again import RETAKES
from bringup_lint.model.declared_again import DeclaredAgain
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

DECLARES = "declare_parameter"
CALLS = 400
"""Calls of one file whose guards are looked for."""
FUNCTIONS = 40
"""Functions of one file that configure a node and are looked into."""
DEPTH = 3
"""Calls of methods of the same file that are followed."""
_STEP = regex(r"(?:\w+::)*(?:on_?[cC]|c)onfigure\Z")
_PLUGIN = "configure"
"""The same step of the plugins of Nav2, which get a node that lives longer than they do."""
_DECLARER = regex(r"(?:(?:this|\w{0,64}node\w{0,64}|get_node\(\))(?:->|\.))?declare_parameter\Z")
_FAILS = regex(r"\bFAILURE\b|\bERROR\b|\bthrow\b|\breturn\s+false\b")
"""What a handler answers that only reports the exception."""
_LEAVES = regex(r"\b(?:return|continue)\b")
_FLAG = regex(r"\b([a-zA-Z_]\w*)\s*=\s*(?:true|false)\b")
_WORD = regex(r"[a-zA-Z_]\w*")


def declared_again(code: Code) -> Iterator[DeclaredAgain]:
    """The first unguarded declaration of each function that configures a node."""
    text = plain_of(code.source) if DECLARES in code.source.text else ""
    if DECLARES not in text or RETAKES.search(text):
        return
    bodies = Bodies(code)
    if DECLARES in bodies.functions:
        return
    guards = _Guards(code)
    for function, step in islice(_steps(code), FUNCTIONS):
        call = _first(code, bodies, function, guards)
        if call is not None:
            yield DeclaredAgain(code.span(call.node), step)


def _steps(code: Code) -> Iterator[tuple[Node, str]]:
    """The functions that configure a node, with their names."""
    for function in code.written.get("function", ()):
        name = code.defined_name(function) or ""
        step = name.rpartition("::")[2]
        is_plugin = "WeakPtr" in code.text(function.child_by_field_name("declarator"))
        if _STEP.match(name) and (step != _PLUGIN or is_plugin):
            yield function, step


def _first(code: Code, bodies: Bodies, function: Node, guards: _Guards) -> Call | None:
    """The first declaration that a function makes, itself or through methods of its file, and that nothing guards."""
    todo, seen = [(function, 0)], {function.id}
    while todo:
        body, depth = todo.pop(0)
        for call in bodies.own(body):
            declares = bool(call.arguments) and _DECLARER.match(call.qualified) is not None
            inner = bodies.functions.get(call.name, [])
            own = call.qualified in (call.name, f"this->{call.name}")
            follows = own and len(inner) == 1 and inner[0].id not in seen and depth < DEPTH
            if not (declares or follows) or guards.of(call, body):
                continue
            if declares:
                return call
            seen.add(inner[0].id)
            todo.append((inner[0], depth + 1))
    return None


class _Guards:
    """What is around calls and before them; each statement is looked at once for a function."""

    def __init__(self, code: Code) -> None:
        self.code = code
        self._asked = 0
        self._flags: dict[int, frozenset[str]] = {}
        self._known: dict[tuple[int, int], bool] = {}
        self._left: dict[tuple[int, int], bool] = {}
        self._taken: dict[int, bool] = {}

    def of(self, call: Call, body: Node) -> bool:
        """Whether a condition that may know of the first time is around a call or returns before it, or a handler that
        goes on. True where too many were asked for."""
        self._asked += 1
        inner = call.node
        for outer in self.code.above(call.node):
            if self._asked > CALLS or (outer.type == "if_statement" and self._knows(outer, body)):
                return True
            if outer.type == "try_statement" and self._takes(outer):
                return True
            before = (each for each in outer.named_children if each.end_byte <= inner.start_byte)
            if outer.type == "compound_statement" and any(self._returns(each, body) for each in before):
                return True
            if outer.id == body.id:
                break
            inner = outer
        return False

    def _takes(self, attempt: Node) -> bool:
        if attempt.id not in self._taken:
            handlers = [each for each in attempt.named_children if each.type == "catch_clause"]
            self._taken[attempt.id] = not all(_FAILS.search(self.code.text(each)) for each in handlers)
        return self._taken[attempt.id]

    def _returns(self, statement: Node, body: Node) -> bool:
        """Whether a statement leaves the function or this round of its loop, and not for a failure, where the node has
        been configured before."""
        key = (statement.id, body.id)
        if key not in self._left:
            text = self.code.text(statement.child_by_field_name("consequence"))
            is_left = _LEAVES.search(text) is not None and not _FAILS.search(text)
            self._left[key] = is_left and self._knows(statement, body)
        return self._left[key]

    def _knows(self, branch: Node, body: Node) -> bool:
        """Whether a condition has a name of the first time, or a flag that the function sets."""
        key = (branch.id, body.id)
        if key not in self._known:
            condition = self.code.text(branch.child_by_field_name("condition"))
            has_flag = not self._flags_of(body).isdisjoint(_WORD.findall(condition))
            self._known[key] = has_flag or GUARD.search(condition) is not None
        return self._known[key]

    def _flags_of(self, body: Node) -> frozenset[str]:
        if body.id not in self._flags:
            self._flags[body.id] = frozenset(_FLAG.findall(self.code.text(body)))
        return self._flags[body.id]
