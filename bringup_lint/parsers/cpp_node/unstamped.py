"""Readings that a C++ file publishes without a time stamp."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Unstamped
from bringup_lint.model.cpp_text import COMMENT
from bringup_lint.model.node_source import JOINTS
from bringup_lint.model.node_source import TIMED
from bringup_lint.model.node_source import TRANSFORM
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import reports_joints
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.values import Names
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_SENDS = ("publish", "sendTransform")
_MADE = regex(r"(?:std::make_(?:shared|unique)<(?P<held>[\w:]{1,99})>|(?P<plain>[\w:]{1,99}))(?:\(\)|\{\})\Z")
_PICTURE = regex(r"(?:cv_bridge::)?CvImage\((?:std_msgs::msg::)?Header(?:\(\)|\{\}),.{1,200}\.toImageMsg\(\)\Z")
_CAMERA = regex(r"VideoCapture|isOpened\(\)")
_SENT = regex(r"(?:publish|sendTransform)\s{0,4}\(\s{0,40}(?:std::move\s{0,4}\(\s{0,4})?\*?\s{0,4}\Z")
_FIELD = regex(
    r"\s{0,40}(?:\.|->)\s{0,4}(?:(?!header\b|set__header\b|get\s{0,4}\()\w|header\s{0,4}\.\s{0,4}frame_id\b)"
)
_NAME = regex(r"[A-Za-z_]\w*\Z")
_BEFORE = 80
"""Code points before a name in which the call is written that it is given to."""


def unstamped(code: Code, names: Names, endpoints: list[Endpoint]) -> Iterator[Unstamped]:
    """The messages that are variables of one function, which sets other fields of them and publishes them."""
    if not any(send in code.source.text for send in _SENDS):
        return
    publishers = {each.attribute for each in endpoints if each.role == "publisher"}
    for call in code.calls:
        if call.name in _SENDS and len(call.arguments) == 1 and "static" not in call.qualified.lower():
            found = _sent(code, names, call)
            if found is None or (found.type == JOINTS and not reports_joints(endpoints)):
                continue
            if found.type == TRANSFORM or _receiver(call) in publishers or _is_transport(code, _receiver(call)):
                yield found


def _receiver(call: Call) -> str:
    """The name on which ``publish`` is called. One that is not made as a publisher may set the stamp itself."""
    return call.qualified.removeprefix("this->").removesuffix("publish").rstrip("->.")


def _is_transport(code: Code, name: str) -> bool:
    """Whether a variable is a publisher of pictures."""
    declared = rf"\bimage_transport::\w{{0,40}}Publisher\s{{1,4}}{re.escape(name)}\b"
    return bool(name) and re.search(declared, code.source.text) is not None


def _sent(code: Code, names: Names, call: Call) -> Unstamped | None:
    name = "".join(code.text(call.arguments[0]).split()).removeprefix("std::move(").rstrip(")").lstrip("*")
    if not _NAME.match(name):
        return None
    function = code.body_of(call.node)
    made = _declaration(code, function, name) if function is not None else None
    if function is None or made is None:
        return None
    kind = _type(code, names, made)
    if kind is None or (kind == TRANSFORM) != (call.name == "sendTransform"):
        return None
    return Unstamped(code.span(made), kind, code.span(call.node)) if _only_fields(code, function, made, name) else None


def _declaration(code: Code, function: Node, name: str) -> Node | None:
    """The one declaration of a variable in a function."""
    inside = [
        each
        for each in code.written.get("declaration", ())
        if function.start_byte < each.start_byte < function.end_byte and _variable(code, each) == name
    ]
    return inside[0] if len(inside) == 1 else None


def _variable(code: Code, declaration: Node) -> str:
    declarator = declaration.child_by_field_name("declarator")
    inner = declarator.child_by_field_name("declarator") if declarator is not None else None
    return code.text(inner if inner is not None else declarator)


def _type(code: Code, names: Names, declaration: Node) -> str | None:
    """The type of a message that is made empty; None for any other variable."""
    declarator = declaration.child_by_field_name("declarator")
    value = declarator.child_by_field_name("value") if declarator is not None else None
    written = "".join(code.text(declaration.child_by_field_name("type")).split())
    made = "".join(code.text(value).split())
    if _PICTURE.match(made) and _CAMERA.search(code.source.text):
        return "sensor_msgs/msg/Image"
    found = _MADE.match(made)
    if found is not None:
        written = found["held"] or found["plain"]
    elif made not in ("", "{}"):
        return None
    kind = names.type(written)
    return kind if kind in TIMED else None


def _only_fields(code: Code, function: Node, declaration: Node, name: str) -> bool:
    """Whether a function sets only fields but the stamp, and publishes the message."""
    text = code.span(function).text
    at = code.span(declaration).end - code.span(function).start
    rest = COMMENT.sub("", text[at:])
    for use in re.finditer(rf"\b{re.escape(name)}\b", rest):
        before = rest[max(0, use.start() - _BEFORE) : use.start()]
        if not _FIELD.match(rest, use.end()) and not _SENT.search(before):
            return False
    return True
