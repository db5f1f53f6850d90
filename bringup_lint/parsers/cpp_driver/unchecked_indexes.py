"""Requests for the index of a CAN interface whose failure nobody notices."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import UncheckedIndex
from bringup_lint.model.cpp_text import plain_of
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
_COPIES = regex(r"\b(?P<name>[A-Za-z_]\w{0,60})\s{0,4}=\s{0,4}[\w.>-]{0,60}\b(?:ifr|can)_ifindex\b", hints="ifindex")
_ASKED = (
    r"\b(?:{0})\s{{0,4}}(?:[<>?]|[!=]=)"
    r"|\b(?:if|while|switch|\w{{0,40}}(?i:check|verif|valid|assert|ensure|require|expect|throw)\w{{0,40}})\s{{0,4}}"
    r"\([^;{{}}]{{0,300}}\b(?:{0})\b"
)
"""What looks at one of these names."""
_SETS = (
    r"\b{0}\s{{0,4}}(?:\.|->)\s{{0,4}}ifr_ifindex\s{{0,4}}=(?!=|\s{{0,4}}0\s{{0,4}};)"
    r"|\b(?:memset|fill\w{{0,4}})\s{{0,4}}\([^;]{{0,80}}ifr_ifindex"
)
"""What gives a request an index of its own."""
_ZERO = (
    r"\b{0}\s{{0,4}}(?:=\s{{0,4}}(?:(?:struct\s{{1,4}})?ifreq\s{{0,4}})?)?(?:\{{|\(\s{{0,4}}\))"
    r"|\bbzero\s{{0,4}}\([^;,]{{0,60}}&\s{{0,4}}(?:this->)?{0}\s{{0,4}},"
    r"|\bmemset\s{{0,4}}\([^;,]{{0,60}}&\s{{0,4}}(?:this->)?{0}\s{{0,4}}\)?\s{{0,4}},\s{{0,4}}(?:0|0x0+|'\\0')\s{{0,4}},"
    r"|\bfill_n\s{{0,4}}\([^;,]{{0,60}}&\s{{0,4}}(?:this->)?{0}\b(?!\.|->)[^;]{{0,60}},\s{{0,4}}0\s{{0,4}}\)"
    r"|\b{0}\s{{0,4}}(?:\.|->)\s{{0,4}}ifr_ifindex\s{{0,4}}=\s{{0,4}}0\s{{0,4}};"
    r"|\bstatic\s{{1,4}}(?:struct\s{{1,4}})?ifreq\s{{1,4}}{0}\b"
)
"""What makes a request zero in a function."""
_LOCAL = r"\b(?:ifreq|auto)\b[\s&*]{{1,6}}{0}\b"
_ZERO_OF_FILE = (
    r"\bifreq\s{{1,4}}{0}\s{{0,4}}(?:=\s{{0,4}})?\{{"
    r"|^(?:static\s{{1,4}})?(?:struct\s{{1,4}})?ifreq\s{{1,4}}{0}\s{{0,4}};"
)
"""What makes a request zero that is a member or a global variable."""
MOST = 20
"""Requests of one file that are looked at."""


def unchecked_indexes(code: Code) -> Iterator[UncheckedIndex]:
    if not _CAN.search(code.source.text) or _ELSEWHERE.search(code.source.text):
        return
    asked = (
        each
        for each in code.calls
        if each.name == "ioctl" and len(each.arguments) == _ARGUMENTS and code.text(each.arguments[1]) == _ASKS
    )
    for call in islice(asked, MOST):
        function = next((each for each in code.above(call.node) if each.type == "function_definition"), None)
        found = _unchecked(code, call, function) if function is not None and _is_dropped(call.node) else None
        if found is not None:
            yield found


def _is_dropped(call: Node) -> bool:
    return call.parent is not None and call.parent.type == "expression_statement"


def _unchecked(code: Code, call: Call, function: Node) -> UncheckedIndex | None:
    plain, whole, asked = plain_of(code.source), code.span(function), code.span(call.node)
    binds = (each for each in code.calls if each.qualified in ("bind", "::bind"))
    bound = next((each for each in binds if call.node.end_byte < each.node.start_byte < function.end_byte), None)
    request = re.escape(code.text(call.arguments[2]).lstrip("& ").removeprefix("this->"))
    text = plain[whole.start : whole.end]
    if bound is None or _LOOKS.search(text) or re.search(_SETS.format(request), text):
        return None
    taken = code.span(bound.node)
    between = plain[asked.end : taken.start]
    names = {"ifr_ifindex", "can_ifindex", "errno", *(re.escape(each["name"]) for each in _COPIES.finditer(between))}
    if re.search(_ASKED.format("|".join(sorted({*names, request}))), between):
        return None
    is_zero = re.search(_ZERO.format(request), text) is not None
    if not is_zero and not re.search(_LOCAL.format(request), text):
        is_zero = re.search(_ZERO_OF_FILE.format(request), plain, re.M) is not None
    return UncheckedIndex(asked, taken, is_zero, _is_dropped(bound.node))
