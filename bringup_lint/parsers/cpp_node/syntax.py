"""The syntax tree of a C++ file, and its calls, as tree-sitter reads them. An error costs the construct that has it."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cache
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.budget import OutOfTime
from bringup_lint.dataclass import dataclass
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node
    from tree_sitter import Query
    from tree_sitter import Tree

DEPTH = 200
"""Nodes above a call that are looked at."""
STEPS = 2_000
STEPS_A_BYTE = 0.1
"""Reports of progress after which tree-sitter stops: recovery from errors may not end. Seven times the most of 15,000
files of public robots."""
_CHUNK = 65_536
"""Bytes that tree-sitter is given at once: it reports no progress on a whole text."""
_WRITTEN = """
(call_expression) @call
(assignment_expression) @assignment
(init_declarator) @made
(declaration) @declaration
(field_initializer) @initializer
(function_definition) @function
(class_specifier) @class
(struct_specifier) @class
(using_declaration) @using
(alias_declaration) @alias
(string_literal) @string
(while_statement) @while
(for_statement) @for
(new_expression) @new
(field_declaration) @field
(throw_statement) @throw
(return_statement) @return
(else_clause) @else
(try_statement) @try
(lambda_expression) @lambda
"""
_EXPORTED = regex(
    rb"[csA-Z](?<!\w[csA-Z])(?:(?:(?<=c)lass|(?<=s)truct)[ \t\r\n]+(?P<macro>[A-Z][A-Z0-9_]+)"
    rb"(?=[ \t\r\n]+[A-Za-z_]\w*[ \t\r\n]*(?:final\b|[:{]))"
    rb"|(?<=[A-Z])[A-Z0-9_]*_(?:PUBLIC|LOCAL|EXPORT|API)\b(?![ \t]*[(:]))"
)
"""Macros that say what a shared library shows; the grammar takes them for the name or type."""
_SWITCH = regex(rb"^[ \t]*#[ \t]*(?P<word>if|ifdef|ifndef|elif|else|endif)\b[ \t]*(?P<given>[^\r\n]*)", re.M)
_NEVER = regex(rb"(?:0|false)[ \t]*(?:/[/*]|\Z)")
"""The condition of what the preprocessor leaves out."""
_MAY_BE_DEAD = (b"if 0", b"if false")
_INK = regex(rb"[^\r\n]")
_WIDE = regex(r"[^\x00-\x7f]")
"""A character of several bytes."""
_BRANCHES = frozenset(
    "if_statement for_statement for_range_loop while_statement do_statement switch_statement catch_clause "
    "conditional_expression lambda_expression".split()
)
FUNCTIONS = frozenset({"function_definition", "lambda_expression"})
LOOPS = frozenset({"for_statement", "for_range_loop", "while_statement", "do_statement"})


@cache
def _query() -> Query:
    import tree_sitter
    import tree_sitter_cpp

    return tree_sitter.Query(tree_sitter.Language(tree_sitter_cpp.language()), _WRITTEN)


def _parsed(data: bytes) -> Tree:
    import tree_sitter
    import tree_sitter_cpp

    plain = _EXPORTED.sub(_blanked, _without_dead(data))
    parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))
    left = iter(range(STEPS + int(STEPS_A_BYTE * len(plain))))
    try:
        return parser.parse(
            lambda at, _: plain[at : at + _CHUNK], progress_callback=lambda *_: next(left, None) is None
        )
    except ValueError as error:
        raise OutOfTime from error


def _without_dead(data: bytes) -> bytes:
    """The text with what ``#if 0`` leaves out as blanks, so that every place stays as it is."""
    if not any(each in data for each in _MAY_BE_DEAD):
        return data
    parts, at = [], 0
    for start, end in _dead(data):
        parts += [data[at:start], _INK.sub(b" ", data[start:end])]
        at = end
    return b"".join((*parts, data[at:]))


def _dead(data: bytes) -> Iterator[tuple[int, int]]:
    """Where text begins and ends that is left out, with the lines that say so."""
    open_dead: list[bool] = []
    start, level = -1, 0
    for found in _SWITCH.finditer(data):
        word = found["word"]
        if word.startswith(b"if"):
            is_dead = start < 0 and word == b"if" and _NEVER.match(found["given"]) is not None
            open_dead.append(is_dead)
            if is_dead:
                start, level = found.start(), len(open_dead)
            continue
        if start >= 0 and len(open_dead) == level:
            yield start, found.end()
            start = -1
        elif start < 0 and open_dead and open_dead[-1]:
            yield found.span()
        if word == b"endif" and open_dead:
            open_dead.pop()


def _blanked(found: re.Match[bytes]) -> bytes:
    """The match with its macro as blanks, so that every place stays as it is."""
    start, end = found.span("macro" if found["macro"] is not None else 0)
    written = found[0]
    return written[: start - found.start()] + b" " * (end - start) + written[end - found.start() :]


@dataclass(frozen=True, eq=False)
class Call:
    """``owner.name<template>(arguments)``."""

    node: Node
    name: str
    qualified: str
    """The function as it is written, without blanks and template arguments."""
    template: Node | None
    arguments: list[Node]


class Code:
    """One file."""

    def __init__(self, source: Source) -> None:
        import tree_sitter

        self.source = source
        self._data = source.text.encode("utf-8", "surrogatepass")
        self.tree = _parsed(self._data)
        found = tree_sitter.QueryCursor(_query()).captures(self.tree.root_node)
        self.written: dict[str, list[Node]] = {
            name: sorted(nodes, key=lambda node: (node.start_byte, -node.end_byte)) for name, nodes in found.items()
        }
        """Kind of construct -> where it is written, in the order of the text."""

    @cached_property
    def _wide(self) -> list[tuple[int, int]] | None:
        """Where characters of several bytes end: byte offset, and how many bytes are too many up to there."""
        if len(self._data) == len(self.source.text):
            return None
        found, extra = [(0, 0)], 0
        for wide in _WIDE.finditer(self.source.text):
            extra += len(wide[0].encode("utf-8", "surrogatepass")) - 1
            found.append((wide.end() + extra, extra))
        return found

    def offset(self, byte: int) -> int:
        """The place of a byte in code points."""
        if self._wide is None:
            return byte
        return byte - self._wide[bisect_right(self._wide, (byte, len(self._data))) - 1][1]

    def at(self, offset: int) -> Node | None:
        """The innermost node at a place in code points."""
        byte = offset if self._wide is None else len(self.source.text[:offset].encode("utf-8", "surrogatepass"))
        return self.tree.root_node.descendant_for_byte_range(byte, byte)

    def span(self, node: Node) -> Span:
        return Span(self.source, self.offset(node.start_byte), self.offset(node.end_byte))

    def text(self, node: Node | None) -> str:
        return self._data[node.start_byte : node.end_byte].decode("utf-8", "replace") if node is not None else ""

    def literal(self, node: Node | None) -> Located | None:
        """The text of a string literal without escapes, also in ``std::string("...")`` or braces."""
        node = self.unwrapped(node)
        if node is None or node.type != "string_literal":
            return None
        text = self.text(node)
        if not text.startswith('"') or "\\" in text or len(text) < 2:
            return None
        span = self.span(node)
        return self.source.located(span.start + 1, span.end - 1)

    def unwrapped(self, node: Node | None) -> Node | None:
        """What is inside ``std::string(...)``, ``rclcpp::ParameterValue(...)`` or parentheses."""
        for _ in range(4):
            if node is None or node.type not in (
                "call_expression",
                "parenthesized_expression",
                "compound_literal_expression",
            ):
                return node
            if node.type == "parenthesized_expression":
                node = node.named_children[0] if node.named_child_count == 1 else None
                continue
            wrapper = node.child_by_field_name("function") or node.child_by_field_name("type")
            given = node.child_by_field_name("arguments") or node.child_by_field_name("value")
            if given is None or self.text(wrapper).replace(" ", "") not in _WRAPPERS or given.named_child_count != 1:
                return node
            node = given.named_children[0]
        return node

    def uses(self, name: str) -> Iterator[Node]:
        """Where code names a variable or member."""
        # A pattern that begins with letters is found many times as fast as one that begins with the end of a word.
        for found in re.finditer(rb"%s\b(?<=\b%s)" % ((re.escape(name.encode()),) * 2), self._data):
            node = self.tree.root_node.descendant_for_byte_range(*found.span())
            if node is not None and node.type in ("identifier", "field_identifier"):
                yield node

    @cached_property
    def calls(self) -> list[Call]:
        return [call for node in self.written.get("call", ()) if (call := self.call(node)) is not None]

    def call(self, node: Node) -> Call | None:
        function, given = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or given is None:
            return None
        template = None
        name = function
        for _ in range(8):
            if name.type in ("template_function", "template_method"):
                template = name.child_by_field_name("arguments")
            inner = name.child_by_field_name("field" if name.type == "field_expression" else "name")
            if name.type == "dependent_name" and name.named_child_count:
                inner = name.named_children[0]
            if inner is None:
                break
            name = inner
        written = self.text(function)
        if template is not None:
            at = template.start_byte - function.start_byte
            written = written.encode()[:at].decode("utf-8", "replace")
        arguments = [each for each in given.named_children if each.type != "comment"]
        return Call(node, self.text(name), "".join(written.split()), template, arguments)

    def above(self, node: Node) -> Iterator[Node]:
        """What a node is in, innermost first."""
        current = node.parent
        for _ in range(DEPTH):
            if current is None:
                return
            yield current
            current = current.parent

    def body_of(self, node: Node) -> Node | None:
        """The innermost function or lambda that a node is in."""
        return next((outer for outer in self.above(node) if outer.type in FUNCTIONS), None)

    def is_conditional(self, node: Node) -> bool:
        """Whether a branch, loop or handler of its function decides about a node."""
        for outer in self.above(node):
            if outer.type in _BRANCHES:
                return True
            if outer.type == "function_definition":
                return False
        return False

    def function_name(self, node: Node) -> str | None:
        """``Class::method`` or ``function`` for the definition that a node is in."""
        for outer in self.above(node):
            if outer.type == "function_definition":
                return self.defined_name(outer)
        return None

    def defined_name(self, definition: Node) -> str | None:
        """The name of a function definition, without blanks."""
        declarator = definition.child_by_field_name("declarator")
        for _ in range(6):
            if declarator is None or declarator.type == "function_declarator":
                break
            declarator = declarator.child_by_field_name("declarator")
        name = declarator.child_by_field_name("declarator") if declarator is not None else None
        return "".join(self.text(name).split()) or None

    def kept(self, node: Node) -> str | None:
        """The variable or member that a value is assigned to, or initialises."""
        for outer in self.above(node):
            if outer.type == "assignment_expression":
                return self.text(outer.child_by_field_name("left")).removeprefix("this->")
            if outer.type == "init_declarator":
                return self.text(outer.child_by_field_name("declarator")).lstrip("*& ")
            if outer.type == "field_initializer":
                return self.text(outer.named_children[0]) if outer.named_child_count else None
            if outer.type not in ("call_expression", "field_expression", "argument_list", "parenthesized_expression"):
                return None
        return None

    def is_inside_function(self, node: Node) -> bool:
        return self.body_of(node) is not None


_WRAPPERS = frozenset({"std::string", "rclcpp::ParameterValue", "ParameterValue", "std::string_view", "string"})
