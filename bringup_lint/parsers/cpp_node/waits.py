"""Calls in the callbacks of a C++ file that keep the executor busy."""

from __future__ import annotations

from bisect import bisect_left
from bisect import bisect_right
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import FOREVER
from bringup_lint.model.cpp_source import UNTIL_OTHER_NODE
from bringup_lint.model.cpp_source import Waiting
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.awaited import LEAVES
from bringup_lint.parsers.cpp_node.awaited import Partners
from bringup_lint.parsers.cpp_node.endpoints import seconds
from bringup_lint.parsers.cpp_node.sockets import UNTIL_PACKET
from bringup_lint.parsers.cpp_node.sockets import receives
from bringup_lint.parsers.cpp_node.sockets import waiting_sockets
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

SHORT = 0.1
"""Seconds; a shorter sleep delays nothing that matters."""
DEPTH = 3
"""Calls of methods of the same file that are followed."""
_AT_START = regex(r"(?i)_?(?:on_?)?(?:init|setup|start_?up)")
"""Names of callbacks of a timer that runs once, before the node has anything else to do."""
_LOCK = regex(r"\bunique_lock\b\s{0,4}(?:<[^<>;]{0,60}>)?\s{0,4}(?P<name>\w{1,60})\s{0,4}[({]", hints="unique_lock")
_ENDLESS = ("true", "1", "rclcpp::ok()")


class Bodies:
    """The functions of a file by their last name, and the calls and loops that each holds itself."""

    def __init__(self, code: Code) -> None:
        self.code = code
        self.functions: dict[str, list[Node]] = {}
        for node in code.written.get("function", ()):
            name = code.defined_name(node)
            if name is not None:
                self.functions.setdefault(name.rpartition("::")[2], []).append(node)
        self._calls = sorted(code.calls, key=lambda call: call.node.start_byte)
        self._loops = sorted(code.written.get("while", []), key=lambda node: node.start_byte)
        self._call_starts = [call.node.start_byte for call in self._calls]
        self._loop_starts = [node.start_byte for node in self._loops]

    def of(self, callback: Callback) -> Node | None:
        """The definition of a callback; None when there is none, or several."""
        if callback.name is None:
            found = self._lambdas.get(callback.span.start)
            return found if found is not None and self.code.span(found).end == callback.span.end else None
        named = self.functions.get(callback.name, [])
        return named[0] if len(named) == 1 else None

    @cached_property
    def _lambdas(self) -> dict[int, Node]:
        """Where it starts -> the first lambda expression there among the arguments of calls."""
        every = [each for call in self._calls for each in call.arguments if each.type == "lambda_expression"]
        return {self.code.span(each).start: each for each in reversed(every)}

    def own(self, body: Node) -> Iterator[Call]:
        """The calls that a body holds itself."""
        return (call for call in self._calls[_within(self._call_starts, body)] if runs(body, call.node))

    def reached(self, body: Node) -> Iterator[Call | Node]:
        """The calls and loops that a body runs, and those of the methods of the file that it calls."""
        todo, seen = [(body, 0)], {body.id}
        while todo:
            node, depth = todo.pop()
            for loop in self._loops[_within(self._loop_starts, node)]:
                if runs(node, loop):
                    yield loop
            for call in self._calls[_within(self._call_starts, node)]:
                if not runs(node, call.node):
                    continue
                yield call
                inner = self.functions.get(call.name, [])
                own = call.qualified in (call.name, f"this->{call.name}")
                if own and len(inner) == 1 and inner[0].id not in seen and depth < DEPTH:
                    seen.add(inner[0].id)
                    todo.append((inner[0], depth + 1))


def _within(starts: list[int], body: Node) -> slice:
    """Which of the places lie in a body."""
    return slice(bisect_right(starts, body.start_byte), bisect_left(starts, body.end_byte))


def runs(body: Node, node: Node) -> bool:
    """Whether a body holds a node itself, and not in a lambda that something else may run."""
    if not body.start_byte < node.start_byte or node.end_byte > body.end_byte:
        return False
    cursor = body.walk()
    while cursor.goto_first_child_for_byte(node.start_byte) is not None:
        here = cursor.node
        if here is None or here.id == node.id:
            break
        if here.type == "lambda_expression":
            return False
    return True


def waits(code: Code, callbacks: list[Callback]) -> Iterator[Waiting]:
    """The calls that block in the callbacks of a file, each place once."""
    bodies = Bodies(code)
    partners = Partners(code, {each.span.start: body for each in callbacks if (body := bodies.of(each)) is not None})
    locks = frozenset(match["name"] for match in _LOCK.finditer(code.source.text))
    sockets = waiting_sockets(code)
    told: list[Span] = []
    reached: set[int] = set()
    for callback in callbacks:
        body = bodies.of(callback) if not _AT_START.match(callback.name or "") else None
        if body is None or body.id in reached:
            continue
        reached.add(body.id)
        for each in bodies.reached(body):
            found = _waiting(code, each, locks, partners, callback)
            if found is None and isinstance(each, Call) and receives(code, each, sockets):
                found = Waiting(code.span(each.node), f"{each.name}()", UNTIL_PACKET, callback)
            if found is not None and not any(span.start <= found.span.start < span.end for span in told):
                told.append(found.span)
                yield found


def _waiting(
    code: Code, each: Call | Node, locks: frozenset[str], partners: Partners, callback: Callback
) -> Waiting | None:
    """How a call or loop keeps the executor busy; None when it does not."""
    if not isinstance(each, Call):
        condition = partners.loop(each, callback)
        found = (condition, "") if condition is not None else _loop(code, each)
        return Waiting(code.span(each), *found, callback) if found is not None else None
    if each.name in ("get", "wait"):
        function = code.body_of(each.node)
        asked = partners.answer(each, function, callback) if function is not None else None
        if asked is not None:
            return Waiting(code.span(each.node), asked, "", callback, True)
    blocked = _call(code, each, locks)
    return Waiting(code.span(each.node), *blocked, callback) if blocked is not None else None


def _call(code: Code, call: Call, locks: frozenset[str]) -> tuple[str, str] | None:
    """``locks``: the variables on which only condition variables wait."""
    if call.name == "sleep_for" and call.arguments:
        return _sleep(call.name, seconds(code.text(call.arguments[-1])))
    if call.qualified in ("sleep", "::sleep", "usleep", "::usleep") and call.arguments:
        number = code.text(call.arguments[0]).rstrip("uUlL")
        unit = 1e-6 if "usleep" in call.name else 1.0
        return _sleep(call.name, float(number) * unit if number.isdecimal() else None)
    if call.qualified in ("system", "std::system", "::system"):
        text = code.literal(call.arguments[0]) if call.arguments else None
        return None if text is not None and _is_short(text) else (call.name, "as long as the program runs")
    if call.qualified == "rclcpp::spin":
        return call.qualified, FOREVER
    if call.qualified == "rclcpp::spin_until_future_complete" and len(call.arguments) < 3:
        own = call.arguments and ("this" in code.text(call.arguments[0]))
        return (call.qualified, "") if own else None
    if call.name == "wait" and 0 < len(call.arguments) < 3 and code.text(call.arguments[0]) in locks:
        return f"{call.name}({code.text(call.arguments[0])})", "until another thread notifies it"
    if call.name in ("wait_for_service", "wait_for_action_server") and not call.arguments and "." not in call.qualified:
        return f"{call.name}()", UNTIL_OTHER_NODE
    return None


def _sleep(name: str, duration: float | None) -> tuple[str, str] | None:
    if duration is None or duration < SHORT:
        return None
    return f"{name}({duration:g} s)", f"for {duration:g} s"


def _is_short(command: str) -> bool:
    from bringup_lint.facts.short_programs import returns_at_once

    return returns_at_once(command.split())


def _loop(code: Code, node: Node) -> tuple[str, str] | None:
    """A loop without an end: no condition of its own, and no way out."""
    condition = "".join(code.text(node.child_by_field_name("condition")).split())
    if condition.removeprefix("(").removesuffix(")") not in _ENDLESS:
        return None
    stack = [node.child_by_field_name("body")]
    while stack:
        current = stack.pop()
        if current is None or current.type == "lambda_expression":
            continue
        if current.type in LEAVES:
            return None
        stack += current.named_children
    return f"while {condition}", FOREVER
