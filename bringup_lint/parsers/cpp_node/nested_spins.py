"""Callbacks of a C++ file that hand their own node to another executor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import NestedSpin
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import DEPTH
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

SPINS = frozenset(f"rclcpp::{name}" for name in ("spin", "spin_some", "spin_all", "spin_until_future_complete"))
_OWN = regex(
    r"(?:(?:this->)?(?:get_node_base_interface|shared_from_this)\(\)(?:->get_node_base_interface\(\))?|this)\Z"
)


def nested_spins(code: Code, callbacks: list[Callback]) -> Iterator[NestedSpin]:
    """Each call once."""
    if "rclcpp::spin" not in code.source.text:
        return
    bodies, seen = Bodies(code), set()
    for name, body in _run(code, bodies, callbacks):
        for call, is_caught in _reached(code, bodies, body):
            if call.node.id not in seen and spins_itself(code, call):
                seen.add(call.node.id)
                yield NestedSpin(code.span(call.node), call.qualified, name, is_caught)


def _reached(code: Code, bodies: Bodies, body: Node) -> Iterator[tuple[Call, bool]]:
    """The calls that a body runs, itself and through methods of the file, each with whether a ``try`` is around it."""
    todo, seen = [(body, 0, False)], {body.id}
    while todo:
        current, depth, is_tried = todo.pop()
        for call in bodies.own(current):
            is_caught = is_tried or _is_tried(code, current, call)
            yield call, is_caught
            inner = bodies.functions.get(call.name, [])
            is_own = call.qualified in (call.name, f"this->{call.name}") and len(inner) == 1
            if is_own and inner[0].id not in seen and depth < DEPTH:
                seen.add(inner[0].id)
                todo.append((inner[0], depth + 1, is_caught))


def _is_tried(code: Code, body: Node, call: Call) -> bool:
    for outer in code.above(call.node):
        if outer.id == body.id:
            return False
        if outer.type == "try_statement":
            return True
    return False


def spins_itself(code: Code, call: Call) -> bool:
    """Whether a call gives the node that it is in to an executor of its own."""
    own = "".join(code.text(call.arguments[0]).split()) if call.qualified in SPINS and call.arguments else ""
    return bool(_OWN.match(own))


def _run(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[tuple[str, Node]]:
    """What the executor of a node runs, each with its name in a sentence."""
    for callback in callbacks:
        body = bodies.of(callback)
        if body is not None:
            yield f"{callback.name}()" if callback.name is not None else "a lambda", body
