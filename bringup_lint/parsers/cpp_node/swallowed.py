"""The handlers of ``main`` after which a failed node ends as if all had gone well."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Swallowed
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.given_up import LOGS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

_FAILS = regex(
    r"\b(?:quick_)?_?_?[eE]xit\w{0,20}\s{0,4}\(|\b(?:abort|terminate|raise|kill|exec\w{1,4})\s{0,4}\(|\bEXIT_FAILURE\b"
)
"""What may end a program with another status, anywhere in its source."""
_GOES_ON = regex(r"\b(?:throw|return|goto)\b|[^=!<>]=(?!=)|\+\+|--")
"""What a handler does that only reports."""
_RUNS = regex(
    r"while\s{0,4}\(\s{0,4}(?:(?P<first>\w{1,60})\s{0,4}&&\s{0,4}rclcpp::ok\s{0,4}\(\s{0,4}\)"
    r"|rclcpp::ok\s{0,4}\(\s{0,4}\)\s{0,4}&&\s{0,4}(?P<last>\w{1,60}))\s{0,4}\)",
    hints="while",
)
"""A loop that a variable leaves out."""
_ASKED = regex(r"\(\s{0,4}(?P<not>!?)\s{0,4}(?P<name>\w{1,60})\s{0,4}\)\Z")
_TAKES_MUCH = regex(r"\.\.\.|\b(?:exception|runtime_error)\b")
_LOOPS = frozenset({"for_statement", "for_range_loop", "while_statement", "do_statement", "lambda_expression"})


def swallowed(code: Code) -> Iterator[Swallowed]:
    """Those of a ``try`` around a spin, and the loops of ``main`` that a failure leaves out, where it returns 0."""
    text = code.source.text
    if ("catch" not in text and not _RUNS.search(text)) or _FAILS.search(blanked(text)):
        return
    yield from _left_out(code)
    ends: dict[int, bool] = {}
    quiet: dict[int, list[Span]] = {}
    for call in code.calls:
        attempt = _attempt(code, call.node, ends) if call.name == "spin" else None
        if attempt is None:
            continue
        if attempt.id not in quiet:
            handlers = [each for each in attempt.named_children if each.type == "catch_clause"]
            taken = (each.child_by_field_name("parameters") or each for each in handlers if _is_quiet(code, each))
            quiet[attempt.id] = [code.span(each) for each in taken]
        yield from (Swallowed(place, code.span(call.node)) for place in quiet[attempt.id])


def _left_out(code: Code) -> Iterator[Swallowed]:
    """``while (started && rclcpp::ok())``, where ``main`` has logged an error when the first is false."""
    main = next((each for each in code.written.get("function", ()) if code.defined_name(each) == "main"), None)
    logged = _logged(code, main) if main is not None else {}
    if not logged:
        return
    for loop in code.written.get("while", ()):
        found = _RUNS.match(code.text(loop))
        failed = logged.get(found["first"] or found["last"]) if found is not None else None
        body = code.body_of(loop) if failed is not None else None
        if found is None or main is None or failed is None or body is None or body.id != main.id:
            continue
        if failed.end_byte <= loop.start_byte:
            if _returns_zero(code, main):
                start = code.span(loop).start
                yield Swallowed(code.source.span(start, start + found.end()), code.span(failed), False)
            return


def _logged(code: Code, main: Node) -> dict[str, Node]:
    """Variable -> the first branch of ``main`` that logs an error when it is false."""
    found: dict[str, Node] = {}
    todo = [main]
    while todo:
        node = todo.pop()
        asked = _ASKED.match(code.text(node.child_by_field_name("condition"))) if node.type == "if_statement" else None
        if asked is not None:
            branch = node.child_by_field_name("consequence" if asked["not"] else "alternative")
            if branch is not None and asked["name"] not in found and LOGS.search(blanked(code.text(branch))):
                found[asked["name"]] = branch
        todo += reversed(node.named_children)
    return found


def _attempt(code: Code, spin: Node, ends: dict[int, bool]) -> Node | None:
    """The ``try`` that takes what a spin of ``main`` throws, when no loop tries again and ``main`` returns only 0,
    which ``ends`` knows for each function."""
    attempt = None
    for outer in code.above(spin):
        if outer.type in _LOOPS:
            return None
        if outer.type == "try_statement":
            attempt = attempt or outer
        if outer.type == "function_definition":
            if outer.id not in ends:
                ends[outer.id] = code.defined_name(outer) == "main" and _returns_zero(code, outer)
            return attempt if ends[outer.id] else None
    return None


def _returns_zero(code: Code, main: Node) -> bool:
    """Whether ``main`` itself, and not a lambda in it, returns nothing but 0."""
    inside = (each for each in code.written.get("return", ()) if main.start_byte < each.start_byte < main.end_byte)
    own = (code.text(each) for each in inside if (body := code.body_of(each)) is not None and body.id == main.id)
    return all(each.removeprefix("return").rstrip("; ").strip() in ("0", "EXIT_SUCCESS") for each in own)


def _is_quiet(code: Code, handler: Node) -> bool:
    taken = code.text(handler.child_by_field_name("parameters"))
    body = blanked(code.text(handler.child_by_field_name("body")))
    return bool(_TAKES_MUCH.search(taken)) and not _GOES_ON.search(body)
