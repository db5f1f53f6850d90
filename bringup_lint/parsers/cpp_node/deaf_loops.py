"""Loops of C++ programs that go on after rclcpp has shut down: no signal but SIGKILL ends them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import DeafLoop
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import LEAVES
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.parsers.cpp_node.waits import runs
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

_ASKS = regex(
    r"\bok\s{0,4}\(|\bspin\w{0,40}\s{0,4}\(|(?i:stop|run|quit|exit|abort|terminat|shut|sig|alive|done|finish|cancel|kill)"
)
"""Words by which a loop may know that it is to end, also in a condition."""
_SLEEPS = regex(r"\b(?:sleep_for|sleep|usleep|nanosleep)\s{0,4}\(")
_HANDLES = regex(r"\b(?:signal|sigaction|shutdown_on_signal|InitOptions|install_signal_handlers)\b")
"""The program treats signals in a way of its own."""
_NODE = regex(r"\b(?:rclcpp::|rclcpp_lifecycle::)?(?:Lifecycle)?Node\s{0,4}[({]")
_FOREVER = ("true", "1")


def deaf_loops(code: Code) -> Iterator[DeafLoop]:
    """Those of ``main`` after ``rclcpp::init``, and of the constructors of nodes."""
    text = code.source.text
    if _HANDLES.search(text):
        return
    for function in code.written.get("function", ()):
        name = code.defined_name(function) or ""
        if name == "main":
            yield from _of_main(code, function)
        elif _is_constructor(code, function, name):
            for each in Bodies(code).reached(function):
                if not isinstance(each, Call):
                    yield from _deaf(code, each, name.rpartition("::")[2])


def _of_main(code: Code, function: Node) -> Iterator[DeafLoop]:
    started = [call.node.start_byte for call in code.calls if call.qualified == "rclcpp::init"]
    if not started:
        return
    for loop in (*code.written.get("while", ()), *code.written.get("for", ())):
        if loop.start_byte > started[0] and runs(function, loop):
            yield from _deaf(code, loop, "main")


def _is_constructor(code: Code, function: Node, name: str) -> bool:
    """Whether a definition has no type, and calls the constructor of a node."""
    if function.child_by_field_name("type") is not None or "~" in name:
        return False
    lists = [each for each in function.children if each.type == "field_initializer_list"]
    return any(_NODE.search(code.text(each)) for each in lists)


def _deaf(code: Code, loop: Node, function: str) -> Iterator[DeafLoop]:
    if _ASKS.search(code.text(loop)) or _leaves(loop):
        return
    is_forever = _condition(code, loop) in _FOREVER
    if is_forever or (loop.type == "while_statement" and _SLEEPS.search(code.text(loop.child_by_field_name("body")))):
        yield DeafLoop(_head(code, loop), function, is_forever)


def _head(code: Code, loop: Node) -> Span:
    """``while (...)`` alone."""
    body = loop.child_by_field_name("body")
    whole = code.span(loop)
    end = code.span(body).start if body is not None else whole.end
    written = whole.source.text[whole.start : end].rstrip()
    return whole.source.span(whole.start, whole.start + len(written))


def _condition(code: Code, loop: Node) -> str:
    """``true`` for ``for (;;)``."""
    condition = loop.child_by_field_name("condition")
    if condition is None:
        return "true" if loop.type == "for_statement" else ""
    text = "".join(code.text(condition).split())
    return text[1:-1] if text.startswith("(") else text


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
