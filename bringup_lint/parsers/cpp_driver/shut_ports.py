"""Serial ports of a C++ file that are used although they may not be open: what takes the exception only logs it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import ShutPort
from bringup_lint.parsers.cpp_driver.only_logged import LEAVES
from bringup_lint.parsers.cpp_driver.only_logged import behind
from bringup_lint.parsers.cpp_driver.only_logged import only_log
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

OPENS_PORT = regex(r"(?:\.|->)\s{0,4}[oO]pen\s{0,4}\(", hints="open Open")
MOST = 50
"""Calls of one file that are looked at."""
_OPENED = regex(r"\b(?P<port>\w+)\s{0,4}(?:\.|->)\s{0,4}(?P<open>[oO]pen)\Z")
_OF_LIBSERIAL = (
    r"(?:Set(?:BaudRate|CharacterSize|Parity|StopBits|FlowControl|DTR|RTS)|FlushIOBuffers|Write|Read|ReadLine)"
)
_OF_SERIAL = r"(?:write|read|readline|readlines|flush|flushInput|flushOutput|available|setDTR|setRTS)"
"""What throws when the port is not open."""
_STOPS = LEAVES + r"|(?i:is_?open)|\b{0}\s{{0,4}}(?:\.|->)\s{{0,4}}[oO]pen\b"
SERIAL_PORT = regex(r"\bserial::|\bLibSerial\b", hints="serial:: LibSerial")


def shut_ports(code: Code) -> Iterator[ShutPort]:
    found_in = ((call, _OPENED.search(call.qualified)) for call in code.calls)
    opens = list(islice(((call, found) for call, found in found_in if found is not None), MOST))
    all_tried = code.written.get("try", ()) if opens else ()
    bodies = [code.span(each) for each in all_tried]
    for tried in all_tried:
        inside = [each for each in opens if tried.start_byte < each[0].node.start_byte < tried.end_byte]
        handler = only_log(code, tried) if inside else None
        if handler is None:
            continue
        for call, found in inside:
            place = _used(code, tried, found)
            if place is not None and not any(body.start < place.start < body.end for body in bodies):
                yield ShutPort(code.span(call.node), code.span(handler), place, found["port"])
                break


def _used(code: Code, tried: Node, opened: re.Match[str]) -> Span | None:
    methods = _OF_LIBSERIAL if opened["open"] == "Open" else _OF_SERIAL
    port = re.escape(opened["port"])
    used = re.compile(rf"\b{port}\s{{0,4}}(?:\.|->)\s{{0,4}}{methods}\s{{0,4}}\(")
    return behind(code, tried, used, re.compile(_STOPS.format(port)))
