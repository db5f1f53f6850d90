"""Parameters of a C++ file that each transition "configure" declares, although the node has them since the first."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import DeclaredAgain
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

DECLARES = "declare_parameter"
DEPTH = 3
"""Calls of methods of the same file that are followed."""
_STEP = regex(r"(?:\w+::)*(?:on_?[cC]|c)onfigure\Z")
_PLUGIN = "configure"
"""The same step of the plugins of Nav2, which get a node that lives longer than they do."""
_RETAKES = regex(r"\bundeclare_parameter\b|\bParameterAlreadyDeclared", hints="Declared undeclare_parameter")
"""What gives parameters back, or takes the exception."""
_DECLARER = regex(r"(?:(?:this|\w{0,64}node\w{0,64}|get_node\(\))(?:->|\.))?declare_parameter\Z")
_GUARD = regex(r"(?i)has_parameter|declar|first|once|init|configured")
_FAILS = regex(r"\bFAILURE\b|\bERROR\b|\bthrow\b|\breturn\s+false\b")
"""What a handler answers that only reports the exception."""
_LEAVES = regex(r"\b(?:return|continue)\b")
_WORD = regex(r"[a-zA-Z_]\w*")


def declared_again(code: Code) -> Iterator[DeclaredAgain]:
    """The first unguarded declaration of each function that configures a node."""
    text = blanked(code.source.text)
    if DECLARES not in text or _RETAKES.search(text):
        return
    bodies = Bodies(code)
    if DECLARES in bodies.functions:
        return
    for function in code.written.get("function", ()):
        name = code.defined_name(function) or ""
        step = name.rpartition("::")[2]
        is_plugin = "WeakPtr" in code.text(function.child_by_field_name("declarator"))
        if _STEP.match(name) and (step != _PLUGIN or is_plugin):
            call = _first(code, bodies, function)
            if call is not None:
                yield DeclaredAgain(code.span(call.node), step)


def _first(code: Code, bodies: Bodies, function: Node) -> Call | None:
    """The first declaration that a function makes, itself or through methods of its file, and that nothing guards."""
    todo, seen = [(function, 0)], {function.id}
    while todo:
        body, depth = todo.pop(0)
        for call in bodies.own(body):
            if _is_guarded(code, call, body):
                continue
            if call.arguments and _DECLARER.match(call.qualified):
                return call
            inner = bodies.functions.get(call.name, [])
            own = call.qualified in (call.name, f"this->{call.name}")
            if own and len(inner) == 1 and inner[0].id not in seen and depth < DEPTH:
                seen.add(inner[0].id)
                todo.append((inner[0], depth + 1))
    return None


def _is_guarded(code: Code, call: Call, body: Node) -> bool:
    """Whether a condition that may know of the first time is around a call or returns before it, or a handler that goes
    on."""
    inner = call.node
    for outer in code.above(call.node):
        if outer.type == "if_statement" and _knows(code, outer, body):
            return True
        if outer.type == "try_statement":
            handlers = [each for each in outer.named_children if each.type == "catch_clause"]
            if not all(_FAILS.search(code.text(each)) for each in handlers):
                return True
        before = (each for each in outer.named_children if each.end_byte <= inner.start_byte)
        if outer.type == "compound_statement" and any(_returns(code, each, body) for each in before):
            return True
        if outer.id == body.id:
            break
        inner = outer
    return False


def _returns(code: Code, statement: Node, body: Node) -> bool:
    """Whether a statement leaves the function or this round of its loop, and not for a failure, where the node has been
    configured before."""
    text = code.text(statement.child_by_field_name("consequence"))
    return _LEAVES.search(text) is not None and not _FAILS.search(text) and _knows(code, statement, body)


def _knows(code: Code, branch: Node, body: Node) -> bool:
    """Whether a condition has a name of the first time, or a flag that the function sets."""
    condition = code.text(branch.child_by_field_name("condition"))
    written = code.text(body)
    flags = (rf"\b{each}\s*=\s*(?:true|false)\b" for each in _WORD.findall(condition))
    return bool(_GUARD.search(condition)) or any(re.search(each, written) for each in flags)
