"""Executors of micro-ROS programs that have less room than handles are added."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.cpp_source import FewHandles
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

_INIT = "rclc_executor_init"
_ADD = "rclc_executor_add_"
_NUMBER = regex(r"(?:0|[1-9][0-9]{0,4})\Z")


def few_handles(code: Code) -> Iterator[FewHandles]:
    """Those that one function makes with a literal number, and to which it adds more whatever is the case."""
    if _INIT not in code.source.text:
        return
    for call in code.calls:
        if call.name != _INIT or len(call.arguments) != 4:
            continue
        number = code.text(call.arguments[2]).rstrip("uUlL")
        if not _NUMBER.match(number):
            continue
        added, room = list(_added(code, call)), int(number)
        if len(added) > room:
            yield FewHandles(code.span(call.arguments[2]), room, len(added), code.span(added[room].node))


def _added(code: Code, init: Call) -> Iterator[Call]:
    function, executor = code.function_name(init.node), code.text(init.arguments[0])
    for call in code.calls:
        is_added = call.name.startswith(_ADD) and call.arguments and code.text(call.arguments[0]) == executor
        is_after = call.node.start_byte > init.node.start_byte and code.function_name(call.node) == function
        if is_added and is_after and function is not None and not code.is_conditional(call.node):
            yield call
