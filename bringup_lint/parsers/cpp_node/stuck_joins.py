"""Threads of a C++ node that run as long as rclcpp does, where the node is to go away before and waits for them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import StuckJoin
from bringup_lint.parsers.cpp_node.awaited import LEAVES
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.parsers.cpp_node.waits import runs
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

STARTS = "std::thread"
THREADS = 40
"""Threads of one file that are looked at."""
_STARTED = regex(
    r"std::(?:thread|make_unique<std::thread>|make_shared<std::thread>)[({]"
    r"(?:&(?:\w+::)*(?P<method>\w+),|\[(?:this|[&=])\](?:\(\))?\{(?:this->)?(?P<called>\w+)\(\);\})"
)
_TARGET = regex(r"(?:this->)?(?P<name>\w+)\Z")
_STEPS = frozenset({"on_cleanup", "on_deactivate"})
_ENDLESS = "(rclcpp::ok())"
_ENDS = regex(r"\bshutdown\s{0,4}\(")


def stuck_joins(code: Code, components: list[str]) -> Iterator[StuckJoin]:
    """The joins in transitions, and in the destructors of components."""
    if STARTS not in code.source.text or _ENDS.search(code.source.text):
        return
    bodies = Bodies(code)
    destructors = {f"~{each.rpartition('::')[2]}" for each in components}
    started = islice(_threads(code, bodies), THREADS)
    loops = {name: loop for name, body in started if (loop := _endless(code, body)) is not None}
    joins = [call for call in code.calls if call.name == "join"] if loops else []
    for call in joins:
        owner = call.qualified.removeprefix("this->").removesuffix("join").rstrip("->.")
        function = (code.function_name(call.node) or "").rpartition("::")[2]
        if owner in loops and (function in _STEPS or function in destructors):
            loop = loops[owner]
            head = code.span(loop.child_by_field_name("condition") or loop)
            yield StuckJoin(code.span(call.node), head, owner, function, function not in _STEPS)


def _threads(code: Code, bodies: Bodies) -> Iterator[tuple[str, Node]]:
    """What holds a thread, and the function that this runs."""
    for node in code.written.get("assignment", ()):
        target = _TARGET.match(code.text(node.child_by_field_name("left")))
        found = _STARTED.match("".join(code.text(node.child_by_field_name("right")).split()))
        if target is not None and found is not None:
            named = bodies.functions.get(found["method"] or found["called"], [])
            if len(named) == 1:
                yield target["name"], named[0]


def _endless(code: Code, body: Node) -> Node | None:
    """The loop of a function that nothing but the end of rclcpp ends."""
    for loop in code.written.get("while", ()):
        condition = "".join(code.text(loop.child_by_field_name("condition")).split())
        if condition == _ENDLESS and runs(body, loop) and not _leaves(loop):
            return loop
    return None


def _leaves(loop: Node) -> bool:
    stack = [loop.child_by_field_name("body")]
    while stack:
        current = stack.pop()
        if current is None or current.type == "lambda_expression":
            continue
        if current.type in LEAVES:
            return True
        stack += current.named_children
    return False
