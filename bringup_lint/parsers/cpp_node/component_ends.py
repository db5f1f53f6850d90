"""Where components and lifecycle nodes of a C++ file end the process that they were loaded into."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import ComponentEnd
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.owners import class_of
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import DEPTH
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_PROCESS = frozenset(
    f"{scope}{name}" for scope in ("", "std::", "::") for name in ("exit", "_exit", "quick_exit", "abort", "terminate")
)
_CONTEXT = "rclcpp::shutdown"
_STEP = regex(r"on_?(?:[cC]onfigure|[aA]ctivate|[dD]eactivate|[cC]leanup|[eE]rror)\Z")
_DECLARED = regex(r"\b(?:void|bool|int|auto)\s+(\w+)\s*\(")
_FORK = ("fork", "vfork")
_OF_LIFECYCLE = regex(r"\bCallbackReturn\b|\bState\b|\bCallback\w{0,20}Return\w{0,20}")
"""What a transition takes or returns; others are called ``on_error``, too."""


def component_ends(code: Code, components: list[str]) -> Iterator[ComponentEnd]:
    """The calls in the methods of components, and in transitions of lifecycle nodes or what those call, in the order
    of the text."""
    ends = [call for call in code.calls if call.qualified == _CONTEXT or call.qualified in _PROCESS]
    if not ends:
        return
    by_class = {each.rpartition("::")[2]: each for each in components}
    own = frozenset(_DECLARED.findall(code.source.text))
    forking = {function.id for call in code.calls if call.name in _FORK and (function := _function(code, call))}
    steps = _steps(code)
    for call in ends:
        is_context = call.qualified == _CONTEXT
        if not is_context and call.qualified in own:
            continue
        function = _function(code, call)
        if function is None or (not is_context and function.id in forking):
            continue
        owner = _method(code, function)[0]
        if owner in by_class:
            is_made = _is_made(code, call, owner)
            yield ComponentEnd(code.span(call.node), call.qualified, by_class[owner], None, is_context, is_made)
        elif owner and (step := steps.get(function.id)) is not None:
            yield ComponentEnd(code.span(call.node), call.qualified, owner, step, is_context, False)


def _steps(code: Code) -> dict[int, str]:
    """Function -> the transition that runs it: itself, or a method of the file that it calls."""
    bodies = Bodies(code)
    own: dict[int, str] = {}
    found: dict[int, str] = {}
    inside: dict[int, tuple[set[int], list[Node]]] = {}
    for name in filter(_STEP.match, bodies.functions):
        level = [
            each
            for each in bodies.functions[name]
            if _method(code, each)[0] and _OF_LIFECYCLE.search(_head(code, each))
        ]
        own.update((each.id, name) for each in level)
        seen = {each.id for each in level}
        for _ in range(DEPTH + 1):
            following = []
            for function in level:
                if function.id not in inside:
                    inside[function.id] = _inside(code, bodies, function)
                holders, called = inside[function.id]
                for holder in holders:
                    found.setdefault(holder, name)
                following += called
            level = list({each.id: each for each in following if each.id not in seen}.values())
            seen.update(each.id for each in level)
    return {**found, **own}


def _inside(code: Code, bodies: Bodies, function: Node) -> tuple[set[int], list[Node]]:
    """The functions in which the calls of a function are, and the methods of the file that it calls."""
    holders: set[int] = set()
    called: dict[int, Node] = {}
    for call in bodies.own(function):
        holder = _function(code, call)
        if holder is not None:
            holders.add(holder.id)
        named = bodies.functions.get(call.name, [])
        if len(named) == 1 and call.qualified in (call.name, f"this->{call.name}"):
            called[named[0].id] = named[0]
    return holders, list(called.values())


def _function(code: Code, call: Call) -> Node | None:
    return next((each for each in code.above(call.node) if each.type == "function_definition"), None)


def _is_made(code: Code, call: Call, owner: str) -> bool:
    """Whether the constructor of a class makes a call itself, and not in what runs later."""
    body = code.body_of(call.node)
    return body is not None and body.type == "function_definition" and class_made(code, body) == owner


def _method(code: Code, function: Node) -> tuple[str, str]:
    """The class and the name of a method; no class where it is a function."""
    qualifier, _, name = (code.defined_name(function) or "").rpartition("::")
    return class_of(code, function, qualifier), name


def _head(code: Code, function: Node) -> str:
    """What a function returns and takes."""
    return " ".join(code.text(function.child_by_field_name(each)) for each in ("type", "declarator"))
