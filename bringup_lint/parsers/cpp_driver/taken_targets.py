"""Targets of UDP packets that each packet which comes in replaces by its sender."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import TakenTarget
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

RECEIVES = regex(r"\basync_receive_from\s{0,4}\(", hints="async_receive_from")
SOCKETS = 40
"""Receiving calls of one file that are looked at."""
_SENDS = ("async_send_to", "send_to")
_NAME = regex(r"(?:this->)?([A-Za-z_]\w{0,80})\Z")


def taken_targets(code: Code) -> Iterator[TakenTarget]:
    """The first call that sends to what ``async_receive_from`` fills with the sender, and something else sets."""
    receivers = islice((call for call in code.calls if call.name == "async_receive_from"), SOCKETS)
    received = {_at(code, call.arguments): call.node for call in receivers}
    for call in code.calls:
        name = _at(code, call.arguments) if call.name in _SENDS else None
        node = received.get(name)
        if name is not None and node is not None and _is_set(code, name) and not _is_asked(code, name):
            yield TakenTarget(code.span(node), code.span(call.node), name)
            return


def _at(code: Code, arguments: list[Node]) -> str | None:
    """The variable in the place of the endpoint."""
    found = _NAME.match(code.text(arguments[1])) if len(arguments) > 1 else None
    return found[1] if found is not None else None


def _is_set(code: Code, name: str) -> bool:
    """Whether something else gives the variable an address: otherwise the sender is who is to be answered."""
    assigned = (code.text(each.child_by_field_name("left")) for each in code.written.get("assignment", ()))
    initializers = (each for each in code.written.get("initializer", ()) if each.named_children)
    initialized = (code.text(each.named_children[0]) for each in initializers)
    return any(each.removeprefix("this->") == name for each in (*assigned, *initialized))


def _is_asked(code: Code, name: str) -> bool:
    """Whether something compares the sender with who may send."""
    word = re.escape(name)
    return re.search(rf"\b{word}\b[^;=]{{0,40}}[!=]=|[!=]=\s*(?:this->)?{word}\b", code.source.text) is not None
