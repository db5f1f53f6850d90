"""Readings of a C++ file that take the frame of the message they are made of, and the time of now."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Restamped
from bringup_lint.model.node_source import DERIVED
from bringup_lint.model.node_source import MEASURED
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

RESTAMPS = regex(r"\bframe_id\s{0,4}=[^=;]{1,100}\bheader\s{0,4}(?:\.|->)\s{0,4}frame_id\b", hints="frame_id")
INTENDED = regex(
    r"(?i)re_?stamp|time_?sync|use_(?!sim_)\w{0,20}(?:time|stamp|clock)|clock_?offset|override_\w{0,20}(?:time|stamp)"
)
"""What says that the clock of the sender is not that of the robot."""
_TARGET = regex(r"(?:this->)?(?P<name>\w{1,80})(?:\.|->)header(?:\.|->)(?P<field>stamp|frame_id)\Z")
_TAKEN = regex(r"(?P<message>\w{1,80})(?:\.|->)header(?:\.|->)frame_id\Z")
_NOW = regex(r"[\w.:()]{0,80}\bnow\(\)\Z")
_PARAMETER = regex(
    r"\b(?P<type>[A-Z]\w{0,80})(?:::\w{0,40}Ptr)?\s{0,4}>?\s{0,4}(?:const\s{0,4})?&{0,2}\s{0,4}(?P<name>\w{1,80})\Z"
)


def restamped(code: Code) -> Iterator[Restamped]:
    """Each variable of a function once."""
    if INTENDED.search(code.source.text):
        return
    stamps: dict[tuple[int, str], Node] = {}
    frames: dict[tuple[int, str], tuple[Node, str, Node]] = {}
    for node in code.written.get("assignment", ()):
        target = _TARGET.match("".join(code.text(node.child_by_field_name("left")).split()))
        body = code.body_of(node) if target is not None else None
        if target is None or body is None:
            continue
        value = "".join(code.text(node.child_by_field_name("right")).split())
        taken = _TAKEN.match(value)
        if target["field"] == "stamp" and _NOW.match(value.replace("->", ".")) and not _is_chosen(code, node):
            stamps[body.id, target["name"]] = node
        elif target["field"] == "frame_id" and taken is not None:
            frames[body.id, target["name"]] = node, taken["message"], body
    for key, (frame, message, body) in frames.items():
        measured = _parameters(code, body).get(message) if key in stamps else None
        made = _made(code, body, key[1], message, measured) if measured in MEASURED else None
        if made in DERIVED:
            yield Restamped(code.span(stamps[key]), code.span(frame), key[1], str(made), message)


def _is_chosen(code: Code, node: Node) -> bool:
    """Whether a condition decides about a stamp; a loop or a handler may."""
    for outer in code.above(node):
        if outer.type in FUNCTIONS:
            return False
        if outer.type in ("if_statement", "switch_statement", "conditional_expression"):
            return True
    return False


def _parameters(code: Code, body: Node) -> dict[str, str]:
    """The parameters of a function, and the last name of the type of each."""
    declarator = body.child_by_field_name("declarator")
    while declarator is not None and declarator.child_by_field_name("parameters") is None:
        declarator = declarator.child_by_field_name("declarator")
    given = declarator.child_by_field_name("parameters") if declarator is not None else None
    every = given.named_children if given is not None else []
    found = (_PARAMETER.search(" ".join(code.text(each).split())) for each in every)
    return {each["name"]: each["type"] for each in found if each is not None}


def _made(code: Code, body: Node, name: str, message: str, measured: str | None) -> str | None:
    """The type of a local variable, by its declaration."""
    word = re.escape(name)
    text = code.text(body)
    if name == message or re.search(rf"\b{word}\s*(?:=\s*|\(|\{{)\*?\s*{re.escape(message)}\s*[;)}}]", text):
        return measured
    declared = re.search(rf"\bmsg::(\w{{1,80}})\s*&?\s+{word}\s*[;({{=]", text)
    made = re.search(rf"\b{word}\s*=[^;=]{{0,120}}\bmsg::(\w{{1,80}})\s*[>({{]", text)
    found = declared or made
    return found[1] if found is not None else None
