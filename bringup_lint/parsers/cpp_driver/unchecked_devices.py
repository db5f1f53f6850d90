"""Devices and files that a C++ file opens, and whose failure nothing of the file notices."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import UncheckedDevice
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_POINTERS = frozenset(
    {
        *("gpiod_chip_open", "gpiod_chip_open_by_name", "gpiod_chip_open_by_number", "gpiod_chip_open_by_label"),
        *("gpiod_chip_open_lookup", "gpiod_chip_get_line", "fopen", "opendir", "hid_open", "hid_open_path"),
        "libusb_open_device_with_vid_pid",
    }
)
"""Functions that return NULL when they fail; what is called with that then crashes."""
_NUMBERS = frozenset(
    {
        *("open", "wiringPiI2CSetup", "wiringPiI2CSetupInterface", "wiringPiSPISetup", "serialOpen", "i2cOpen"),
        *("spiOpen", "serOpen", "i2c_open", "spi_open", "serial_open", "pigpio_start", "lgGpiochipOpen", "lgI2cOpen"),
        *("lgSpiOpen", "lgSerialOpen"),
    }
)
"""Functions that return a negative number when they fail."""
DEVICES = 40
"""Results of one file that are looked at."""
OPENS = regex(
    rf"\b(?:{'|'.join(sorted(_POINTERS | _NUMBERS))})\s{{0,4}}\(", hints="gpio open Open I2CSetup SPISetup pigpio_start"
)
_NAME = regex(r"[*&\s]{0,8}(?:this->)?([A-Za-z_]\w{0,80})\Z")
_FLAG = regex(
    r"\(\s{0,8}\w{0,80}?(?:(?<![A-Za-z])(?:[Dd]ebug|[Ll]og|[Rr]ecord|[Dd]ump|[Tt]rac|[Tt]est|[Vv]erbos)"
    r"|(?<=[a-z])(?:Debug|Log|Record|Dump|Trac|Test|Verbos)|DEBUG|TRACE|VERBOSE)(?:e|g?ing|s)?(?![a-z])\w{0,80}\s{0,8}\)\Z"
)
"""A flag whose name says that it is for those who look for mistakes."""
_CASTS = ("cast_expression", "parenthesized_expression")


def unchecked_devices(code: Code) -> Iterator[UncheckedDevice]:
    """Each name that gets the result, once, where the file asks nothing about it and uses it."""
    for name, call in islice(_opened(code).items(), DEVICES):
        function = _function(call)
        used = [] if is_asked(code.source.text, name) else _used(code, name, function in _NUMBERS)
        for first in used[:1]:
            is_optional = all(_is_optional(code, each) for each in used)
            is_pointer = function in _POINTERS
            yield UncheckedDevice(code.span(call.node), code.span(first), function, name, is_pointer, is_optional)


def _opened(code: Code) -> dict[str, Call]:
    """Name -> the first call whose result it gets."""
    opened: dict[str, Call] = {}
    for call in code.calls:
        function = _function(call)
        name = _kept(code, call.node) if function in _POINTERS or function in _NUMBERS else None
        if name is not None:
            opened.setdefault(name, call)
    return opened


def _function(call: Call) -> str:
    return call.qualified.removeprefix("::")


def _kept(code: Code, node: Node) -> str | None:
    """The variable or member that alone gets a result, in a statement of its own."""
    outer = node.parent
    while outer is not None and outer.type in _CASTS:
        outer = outer.parent
    if outer is None or outer.type not in ("init_declarator", "assignment_expression"):
        return None
    if outer.parent is None or outer.parent.type not in ("declaration", "expression_statement"):
        return None
    found = _NAME.match(code.text(outer.child_by_field_name("declarator") or outer.child_by_field_name("left")))
    return found[1] if found is not None else None


def is_asked(text: str, name: str) -> bool:
    """Whether a text compares a name, gives it to a macro or function that may, or hands it out."""
    word = rf"(?:this->)?\b{re.escape(name)}\b"
    asked = (
        rf"{word}\s*(?:[<>?]|[!=]=|&&|\|\|)|(?:[!|]|(?<!-)[<>]|&&|[=!]=)\s*{word}|\breturn\s+{word}"
        rf"|\b(?:if|while|assert|\w{{0,40}}(?i:check|valid|ok|fail|error|ensure)\w{{0,40}})\s*\(\s*!?\s*{word}"
    )
    return re.search(asked, blanked(text)) is not None


def _used(code: Code, name: str, is_number: bool) -> list[Node]:
    """The calls that get what was opened; none when one of those that fail with a number that is no device is asked for
    its result."""
    word = f"this->{name}"
    calls = [
        call
        for call in code.calls
        if any(code.text(each) in (name, word) for each in call.arguments) and not _is_given(code, call.node, name)
    ]
    if is_number and any(call.node.parent is None or call.node.parent.type != "expression_statement" for call in calls):
        return []
    return [call.node for call in calls]


def _is_given(code: Code, node: Node, name: str) -> bool:
    """Whether the function around a call takes an argument of this name, which is another variable."""
    function = code.body_of(node)
    declared = code.text(function.child_by_field_name("declarator")) if function is not None else ""
    return re.search(rf"\b{re.escape(name)}\s*[,)]", declared) is not None


def _is_optional(code: Code, used: Node) -> bool:
    """Whether a flag for those who look for mistakes decides about a call."""
    branches = (outer for outer in code.above(used) if outer.type == "if_statement")
    return any(_FLAG.match(code.text(each.child_by_field_name("condition"))) for each in branches)
