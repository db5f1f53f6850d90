"""Requests for the index of a CAN interface whose failure nobody notices."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import UncheckedIndex
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_ASKS = "SIOCGIFINDEX"
ASKS = regex(_ASKS, hints=_ASKS)
_ARGUMENTS = 3
_ELSEWHERE = regex(r"(?i)netlink|\brtnl_|SIOCGIFFLAGS|/sys/class/net|operstate")
"""What looks at interfaces in another way."""
_CAN = regex(r"\b[AP]F_CAN\b")
_LOOKS = regex(
    r"ifr_ifindex\s{0,4}(?:[<>]|[!=]=)|[!(]\s{0,4}\w{1,40}(?:\.|->)ifr_ifindex\s{0,4}[)&|]|\bif_nametoindex\b"
)
"""What notices an index that nobody set."""


def unchecked_indexes(code: Code) -> Iterator[UncheckedIndex]:
    if not _CAN.search(code.source.text) or _ELSEWHERE.search(code.source.text):
        return
    for call in code.calls:
        if call.name == "ioctl" and len(call.arguments) == _ARGUMENTS and code.text(call.arguments[1]) == _ASKS:
            function = next((each for each in code.above(call.node) if each.type == "function_definition"), None)
            found = _unchecked(code, call, function) if function is not None and _is_dropped(call.node) else None
            if found is not None:
                yield found


def _is_dropped(call: Node) -> bool:
    return call.parent is not None and call.parent.type == "expression_statement"


def _unchecked(code: Code, call: Call, function: Node) -> UncheckedIndex | None:
    text = blanked(code.text(function))
    binds = (each for each in code.calls if each.qualified in ("bind", "::bind"))
    bound = next((each for each in binds if call.node.end_byte < each.node.start_byte < function.end_byte), None)
    if bound is None or _LOOKS.search(text):
        return None
    request = re.escape(code.text(call.arguments[2]).lstrip("& ").removeprefix("this->"))
    zero = re.compile(
        rf"\b{request}\s{{0,4}}(?:=\s{{0,4}})?\{{|\b(?:memset|bzero)\s{{0,4}}\(\s{{0,4}}&\s{{0,4}}(?:this->)?{request}\b"
    )
    is_zero, is_blind = zero.search(text) is not None, _is_dropped(bound.node)
    return UncheckedIndex(code.span(call.node), code.span(bound.node), is_zero, is_blind)
