"""Where a C++ file takes the difference of a ROS time and a member that may hold a system time still."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import TimeMember
from bringup_lint.model.cpp_source import TimeUse
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.owners import class_of
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_OPERAND = regex(
    r"(?:-|[<>]=?)\s{0,4}(?:this->)?(?P<right>[A-Za-z_]\w{0,60})\b|\b(?P<left>[A-Za-z_]\w{0,60})(?=\s{0,4}(?:-(?!>)|[<>]))"
)
_ROS_TIME = regex(r"\bnow\s{0,4}\(|\bstamp\b", hints="now stamp")
_NOW = regex(r"(?:this->|\w{0,40}(?i:node)\w{0,40}(?:\(\))?(?:->|\.))?(?:get_clock\(\)->)?now\(\)\Z")
_STAMP = regex(r"(?P<open>(?:rclcpp::)?Time[({])?[\w.>\[\]-]{1,80}\bheader\.stamp(?(open)[)}])\Z")
_TIME = regex(r"(?:rclcpp::)?Time\Z")
_UNSET = regex(r"(?:(?:rclcpp::)?Time)?(?:[({](?:0(?:,0)?(?:,RCL_SYSTEM_TIME)?)?[)}])?\Z")
"""A default with the clock ``RCL_SYSTEM_TIME``, which is that of a time without one (rclcpp, time.hpp)."""
_COMPARED = frozenset({"-", "<", ">", "<=", ">="})
"""Operators that throw for times of different clocks (rclcpp, time.cpp)."""
_HELD = regex(r"->\s{0,4}cancel\s{0,4}\(")
"""What holds a timer back until a message starts it."""
_LEAVES = regex(r"\b(?:return|throw|continue)\b")
_CHOOSES = frozenset({"if_statement", "while_statement", "conditional_expression"})
_MAY_NOT_RUN = frozenset(
    "for_statement for_range_loop do_statement switch_statement catch_clause try_statement preproc_if preproc_ifdef "
    "else_clause".split()
)
NAMES = 60
"""Names of one file that are looked into."""


def time_members(code: Code) -> Iterator[TimeMember]:
    """The members of type ``rclcpp::Time`` that a class makes with the system clock."""
    for node in code.written.get("field", ()):
        declarators = [each for each in node.named_children if each.type == "field_identifier"]
        if len(declarators) != 1 or not _TIME.match("".join(code.text(node.child_by_field_name("type")).split())):
            continue
        value = "".join(code.text(node.child_by_field_name("default_value")).split())
        if _UNSET.match(value):
            span = code.span(declarators[0])
            yield TimeMember(code.source.located(span.start, span.end), class_of(code, node, ""))


def time_uses(code: Code, callbacks: list[Callback]) -> Iterator[TimeUse]:
    """The first difference of each member in a callback that nothing has set before."""
    text = code.source.text
    if "rclcpp" not in text or not _ROS_TIME.search(text) or not callbacks:
        return
    bodies = Bodies(code)
    if "now" in bodies.functions:
        return
    run = dict(_run_alone(code, bodies, callbacks))
    names = dict.fromkeys(found["right"] or found["left"] for found in _OPERAND.finditer(text))
    for name in list(names)[:NAMES]:
        found = _first_use(code, run, name)
        if found is not None:
            yield found


def _run_alone(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[tuple[int, Callback]]:
    """The bodies that nothing runs but a callback; not those of timers that messages start."""
    known = [(each, body) for each in callbacks if (body := bodies.of(each)) is not None]
    heard = [code.span(body) for each, body in known if each.role == "subscription"]
    for each, body in known:
        method = _method(bodies, body)
        name = (code.defined_name(method) or "").rpartition("::")[2]
        calls = sum(call.name == name for call in code.calls)
        if calls > (method != body):
            continue
        if each.role != "timer" or not any(span.start <= each.span.start < span.end for span in heard):
            yield method.id, each


def _method(bodies: Bodies, body: Node) -> Node:
    """The method of the file that a lambda only calls; else the body itself."""
    statements = body.child_by_field_name("body") if body.type == "lambda_expression" else None
    calls = list(bodies.own(body)) if statements is not None and statements.named_child_count == 1 else []
    inner = bodies.functions.get(calls[0].name, []) if calls else []
    is_own = bool(calls) and calls[0].qualified in (calls[0].name, f"this->{calls[0].name}")
    outer = calls[0].node.parent if calls else None
    is_all = outer is not None and outer.type == "expression_statement" and outer.parent == statements
    return inner[0] if is_own and is_all and len(inner) == 1 else body


def _first_use(code: Code, run: dict[int, Callback], name: str) -> TimeUse | None:
    differences: list[Node] = []
    stores: list[Node] = []
    asked = False
    for use in code.uses(name):
        place = _operand(code, use)
        parent = place.parent if place is not None else None
        if place is None or parent is None:
            return None
        if parent.type == "assignment_expression" and parent.child_by_field_name("left") == place:
            stores.append(parent)
        elif _is_difference(code, parent, place):
            differences.append(parent)
        elif _is_asked(code, parent, place):
            asked = True
        elif not _is_plain(code, parent, place):
            return None
    found = _unset(code, run, name, differences[0], stores) if differences else None
    body = code.body_of(differences[0]) if found is not None and asked else None
    return None if body is not None and _leaves(code, body, differences[0]) else found


def _operand(code: Code, use: Node) -> Node | None:
    """The name itself, or ``this->name``; None for a member of something else."""
    parent = use.parent
    if parent is None or parent.type != "field_expression" or parent.child_by_field_name("field") != use:
        return use
    return parent if code.text(parent.child_by_field_name("argument")) == "this" else None


def _is_difference(code: Code, parent: Node, place: Node) -> bool:
    if parent.type != "binary_expression" or code.text(parent.child_by_field_name("operator")) not in _COMPARED:
        return False
    left, right = parent.child_by_field_name("left"), parent.child_by_field_name("right")
    other = right if left == place else left
    return other is not None and _is_ros_time(code, other)


def _is_ros_time(code: Code, node: Node) -> bool:
    """The clock of a node, or the stamp of a message, also by a variable of the function."""
    written = "".join(code.text(node).split())
    if node.type == "identifier":
        written = _initial(code, node, written)
    return bool(_NOW.match(written) or _STAMP.match(written))


def _initial(code: Code, node: Node, name: str) -> str:
    """The value that the one declaration of a variable gives it; empty when that is not known."""
    body = code.body_of(node)
    inside = [
        each
        for each in code.written.get("made", ())
        if body is not None
        and body.start_byte < each.start_byte < node.start_byte
        and code.text(each.child_by_field_name("declarator")) == name
    ]
    return "".join(code.text(inside[0].child_by_field_name("value")).split()) if len(inside) == 1 else ""


def _is_asked(code: Code, parent: Node, place: Node) -> bool:
    """Whether a place asks a time for its number, as one does to see whether it is set."""
    is_object = parent.type == "field_expression" and parent.child_by_field_name("argument") == place
    return is_object and code.text(parent.child_by_field_name("field")) in ("seconds", "nanoseconds")


def _is_plain(code: Code, parent: Node, place: Node) -> bool:
    """Whether a place only declares the member, or initialises it without a clock."""
    if parent.type == "field_initializer":
        given = "".join(code.text(parent.named_children[-1]).split())
        return bool(_UNSET.match(given))
    return parent.type == "field_declaration" and place.type == "field_identifier"


def _unset(code: Code, run: dict[int, Callback], name: str, use: Node, stores: list[Node]) -> TimeUse | None:
    """The use, when its callback computes it whenever it runs, and before the member was set."""
    body = code.body_of(use)
    callback = run.get(body.id) if body is not None else None
    if body is None or callback is None or not _is_certain(code, use, body):
        return None
    others = [each for each in stores if code.body_of(each) != body]
    if any(each.start_byte < use.end_byte for each in stores if each not in others):
        return None
    if others and _HELD.search(code.source.text):
        return None
    waits = callback.role in ("timer", "subscription") and _comes_later(code, run, others)
    if others and (not waits or _leaves(code, body, use)):
        return None
    method = next((each for each in (body, *code.above(body)) if each.type == "function_definition"), None)
    if method is None:
        return None
    owner = class_of(code, method, (code.defined_name(method) or "").rpartition("::")[0])
    span = code.span(use)
    set_later = code.span(others[0]) if others else None
    return TimeUse(span, name, owner, callback, set_later) if owner else None


def _comes_later(code: Code, run: dict[int, Callback], stores: list[Node]) -> bool:
    """Whether only messages set the member."""
    found = [run.get(body.id) for each in stores if (body := code.body_of(each)) is not None]
    return len(found) == len(stores) and all(each is not None and each.role == "subscription" for each in found)


def _leaves(code: Code, body: Node, use: Node) -> bool:
    whole = code.span(body)
    return bool(_LEAVES.search(whole.source.text[whole.start : code.span(use).start]))


def _is_certain(code: Code, use: Node, body: Node) -> bool:
    """Whether a function computes an expression whenever it comes to that statement."""
    inner = use
    for outer in code.above(use):
        if outer == body:
            return True
        if outer.type in _MAY_NOT_RUN:
            return False
        if outer.type in _CHOOSES and outer.child_by_field_name("condition") != inner:
            return False
        is_logical = outer.type == "binary_expression" and code.text(outer.child_by_field_name("operator")) in (
            "&&",
            "||",
        )
        if is_logical and outer.child_by_field_name("left") != inner:
            return False
        inner = outer
    return False
