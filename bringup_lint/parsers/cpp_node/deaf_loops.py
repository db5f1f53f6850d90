"""Loops of C++ programs that go on after rclcpp has shut down: no signal but SIGKILL ends them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import DeafLoop
from bringup_lint.model.cpp_source import MakingLoop
from bringup_lint.parsers.cpp_node.awaited import LEAVES
from bringup_lint.parsers.cpp_node.early_pointers import while_made
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.parsers.cpp_node.waits import runs
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

_ASKS = regex(
    r"\bspin\w{0,40}\s{0,4}\(|(?i:ok\s{0,4}\(|is_?valid|stop|run|quit|exit|abort|terminat|shut|sig|alive|done|finish"
    r"|cancel|kill)"
)
"""Words by which a loop may know that it is to end, also in a condition."""
_RUNS = "rclcpp::ok()"
_SPINS = regex(r"(?i)spin|exit|abort|shutdown")
"""Words by which a loop runs callbacks, or ends."""
_SLEEPS = regex(r"\b(?:sleep_for|sleep|usleep|nanosleep)\s{0,4}\(")
_HANDLES = regex(
    r"\bsigaction\b|\bsignal\b|InitOptions|(?:[Ss]ignal|SIGNAL)[Ss]?_?(?:[Hh]andlers?|HANDLERS?)?\s{0,4}\(",
    hints="sigaction ignal SIGNAL InitOptions",
)
"""The program treats signals in a way of its own."""
_NODE = regex(r"\b(?:rclcpp::|rclcpp_lifecycle::)?(?:Lifecycle)?Node\s{0,4}[({]")
_GIVES_BACK = ("rclcpp::shutdown", "rclcpp::uninstall_signal_handlers")
"""Calls after which signals end the program again (rclcpp, utilities.cpp)."""
_LOOPS = ("while", "for")
_FOREVER = ("true", "1")
_BOUNDED = regex(r"(?i)time_?out|timed|expire|elapsed|deadline|empty|has_?next")
"""Words of conditions that end by themselves."""
_ORDERS = frozenset({"<", ">", "<=", ">="})
_LITERALS = ("true", "false")


def deaf_loops(code: Code) -> Iterator[DeafLoop]:
    """Those of ``main`` after ``rclcpp::init``, and of the constructors of nodes."""
    if code.written.keys().isdisjoint(_LOOPS) or _HANDLES.search(code.source.text):
        return
    for function in code.written.get("function", ()):
        name = code.defined_name(function) or ""
        if name == "main":
            yield from _of_main(code, function)
        elif _is_constructor(code, function, name):
            for each in Bodies(code).reached(function):
                if not isinstance(each, Call):
                    yield from _deaf(code, each, name.rpartition("::")[2])


def making_loops(code: Code) -> Iterator[MakingLoop]:
    """Loops that run while a node is made, and end only with rclcpp. Those that ask for nothing at all are deaf."""
    if _RUNS not in code.source.text:
        return
    bodies = Bodies(code)
    for owner, function, through in while_made(code, bodies):
        for loop in code.written.get("while", ()):
            is_own = runs(function, loop) and not code.is_conditional(loop)
            if is_own and _condition(code, loop) == _RUNS and not _SPINS.search(code.text(loop)) and not _leaves(loop):
                yield MakingLoop(_head(code, loop), owner, through)


def _of_main(code: Code, function: Node) -> Iterator[DeafLoop]:
    started = [call.node.start_byte for call in code.calls if call.qualified == "rclcpp::init"]
    if not started:
        return
    ended = [call.node.start_byte for call in code.calls if call.qualified in _GIVES_BACK and _is_step(function, call)]
    for loop in (*code.written.get("while", ()), *code.written.get("for", ())):
        is_handled = started[0] < loop.start_byte < max(ended, default=loop.end_byte)
        if is_handled and runs(function, loop):
            yield from _deaf(code, loop, "main")


def _is_step(function: Node, call: Call) -> bool:
    """Whether a call is a statement of a function itself, which no condition leaves out."""
    body = function.child_by_field_name("body")
    outer = call.node.parent.parent if call.node.parent is not None else None
    return body is not None and outer is not None and outer.id == body.id


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
    if is_forever or _waits(code, loop):
        yield DeafLoop(_head(code, loop), function, is_forever)


def _waits(code: Code, loop: Node) -> bool:
    """Whether a loop sleeps until something else comes, and counts neither time nor tries."""
    if loop.type != "while_statement" or not _SLEEPS.search(code.text(loop.child_by_field_name("body"))):
        return False
    return not _BOUNDED.search(_condition(code, loop)) and not any(_is_count(code, each) for each in _below(loop))


def _is_count(code: Code, node: Node) -> bool:
    """``i++``, ``i += n``, ``i < n``, and ``waiting = false``."""
    if node.type == "update_expression":
        return True
    operator = code.text(node.child_by_field_name("operator"))
    if node.type == "assignment_expression":
        return operator != "=" or code.text(node.child_by_field_name("right")) in _LITERALS
    return node.type == "binary_expression" and operator in _ORDERS and not _is_result(code, node)


def _is_result(code: Code, node: Node) -> bool:
    """``ioctl(...) < 0``: whether a call failed, which counts nothing."""
    left = node.child_by_field_name("left")
    return left is not None and left.type == "call_expression" and code.text(node.child_by_field_name("right")) in "0-1"


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
    return any(each.type in LEAVES for each in _below(loop))


def _below(loop: Node) -> Iterator[Node]:
    """The nodes of a loop, without those of lambdas."""
    stack = [loop]
    while stack:
        current = stack.pop()
        if current.type != "lambda_expression":
            yield current
            stack += current.named_children
