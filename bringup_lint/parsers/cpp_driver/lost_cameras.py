"""Cameras of a C++ file whose loss a timer or loop survives without opening them again."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.cameras import LOOKED_AFTER
from bringup_lint.model.cpp_driver import LostCamera
from bringup_lint.model.cpp_text import end_of_block
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.endpoints import TIMERS
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import LOOPS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

    from bringup_lint.source import Span

CAMERA = regex(r"\bVideoCapture\b|\bisOpened\s{0,4}\(", hints="VideoCapture isOpened")
_READS = regex(
    r"\b(?P<camera>\w{1,60})\s{0,4}>>\s{0,4}(?P<frame>\w{1,60})\s{0,4};[\s}]{0,400}"
    r"(?P<test>if\s{0,4}\(\s{0,4}(?P=frame)\s{0,4}\.\s{0,4}empty\s{0,4}\(\s{0,4}\)\s{0,4}\))\s{0,40}\{(?P<body>)"
    r"|(?P<check>if\s{0,4}\(\s{0,4}!\s{0,4}(?P<read>\w{1,60})\s{0,4}(?:\.|->)\s{0,4}read\s{0,4}\(\s{0,4}\w{1,60}\s{0,4}\)"
    r"\s{0,4}\))\s{0,40}\{(?P<inside>)"
)
MOST = 20
"""Reads of one file that are looked at."""
MOST_FUNCTIONS = 50
"""In which one camera is opened; over that nothing is known of it."""
_OPENS = (
    r"(?<![\w.>])(?:this->)?{0}\s{{0,4}}(?:(?:\.|->)\s{{0,4}}open\s{{0,4}}\(|=\s{{0,4}}(?:cv::)?VideoCapture\s{{0,4}}[({{])"
    r"|\bVideoCapture\s{{1,4}}{0}\s{{0,4}}[({{=]|(?<=[,:\s]){0}\s{{0,4}}[({{](?=[^;]{{0,200}}\{{)"
)
_PASSIVE = regex(
    r"\bRCLCPP_\w{3,40}\s{0,4}\((?:[^;\"]|\"(?:[^\"\\\n]|\\.)*\"){0,900}\)\s{0,4};"
    r"|\bstd::c(?:err|out)\b(?:[^;\"]|\"(?:[^\"\\\n]|\\.)*\"){0,900};"
    r"|[\w:.>-]{0,60}sleep(?:_for)?\s{0,4}\([^;]{0,200};"
)
_LEAVES = regex(r"\s*(?:return|continue)\s*;\s*\Z")
_ENDS = regex(
    r"\b(?:_?exit|_Exit|quick_exit|abort|terminate|raise|kill)\s{0,4}\(|\bthrow\b",
    hints="exit _Exit abort terminate raise kill throw",
)
"""What ends the node: an exception leaves ``spin``."""
_SHUTS = regex(r"\bshutdown\s{0,4}\(", hints="shutdown")
_KNOWN_USE = r"(?:\.|->)\s{0,4}(?:read|isOpened|get|set|release|open)\s{0,4}\(|>>|[;({]"
"""To declare, open, ask or read a camera."""
_DEVICE = regex(r"[^;\"({]{0,80}[({]\s{0,4}(?:\d{1,3}|\"/dev/[^\"\n]{1,200}\"|(?P<number>\w{1,60}))\s{0,4}[,)}]")
"""The arguments with which a device is opened, not a file or a stream, when the variable is a number."""


def lost_cameras(code: Code) -> Iterator[LostCamera]:
    """One for each read that goes on without a picture."""
    plain = plain_of(code.source)
    if LOOKED_AFTER.search(plain) or _SHUTS.search(plain.partition("int main")[0]):
        return
    ends = [each.start() for each in islice(_ENDS.finditer(plain), MOST)]
    if len(ends) == MOST or not all(_is_of_start(code, each) for each in ends):
        return
    openings: dict[str, tuple[Span, list[Node]] | None] = {}
    for found in islice(_READS.finditer(plain), MOST):
        by_stream = found["camera"] is not None
        start = found.end("body" if by_stream else "inside")
        end = end_of_block(plain, start)
        branch = plain[start:end]
        if not _LEAVES.match(_PASSIVE.sub(" ", branch)) or plain[end + 1 : end + 40].lstrip().startswith("else"):
            continue
        node = code.at(found.start())
        camera = found["camera"] or found["read"]
        if node is None or not _is_repeated(code, node):
            continue
        if camera not in openings:
            openings[camera] = _openings(code, plain, camera)
        opened = _opened(code, openings[camera], node)
        if opened is not None:
            place = code.source.span(found.start(), found.end("frame") if by_stream else found.end("check"))
            test = code.source.span(*found.span("test" if by_stream else "check"))
            yield LostCamera(place, test, opened, _PASSIVE.search(branch) is not None)


def _is_repeated(code: Code, read: Node) -> bool:
    """Whether a timer or loop reads."""
    function = code.body_of(read)
    return function is not None and (_loop(code, read) is not None or _is_of_timer(code, function))


def _opened(code: Code, openings: tuple[Span, list[Node]] | None, read: Node) -> Span | None:
    """Where a camera is opened, when this is before a timer or loop reads it, and not again."""
    if openings is None:
        return None
    first, late = openings
    function = code.body_of(read)
    is_before = not late or (function is not None and _loop(code, read) is not None)
    return first if is_before and all(function is not None and each.id == function.id for each in late) else None


def _openings(code: Code, plain: str, camera: str) -> tuple[Span, list[Node]] | None:
    """Where a camera is first opened, and the functions that open it and may run at any time; None when what happens
    to it is not known."""
    if re.search(rf"(?<![\w.])(?:this->)?{re.escape(camera)}\b(?!\s{{0,4}}(?:{_KNOWN_USE}))", plain) is not None:
        return None
    first: Span | None = None
    functions: dict[int, Node] = {}
    for found in re.compile(_OPENS.format(re.escape(camera))).finditer(plain):
        node = code.at(found.start())
        if node is None or not _is_device(plain, found.end() - 1):
            return None
        outer = code.body_of(node)
        if outer is None or _loop(code, node) is not None:
            return None
        functions[outer.id] = outer
        if len(functions) > MOST_FUNCTIONS:
            return None
        first = first or code.source.span(found.start(), found.end() - 1)
    if first is None:
        return None
    return first, [each for each in functions.values() if not _is_early(code, each)]


def _is_device(plain: str, at: int) -> bool:
    """Whether the arguments there are those of a device."""
    found = _DEVICE.match(plain, at)
    number = found["number"] if found is not None else None
    return found is not None and (number is None or re.search(rf"\bint\s+{re.escape(number)}\b", plain) is not None)


def _is_early(code: Code, function: Node) -> bool:
    """Whether a function is a constructor or ``main``, or is called by these alone."""
    if function.type != "function_definition":
        return False
    name = (code.defined_name(function) or "").rpartition("::")[2]
    if name == "main" or class_made(code, function) is not None:
        return True
    callers = [code.body_of(call.node) for call in code.calls if call.name == name]
    made = [each is not None and _is_start(code, each) for each in callers]
    return len(made) == 1 and all(made) and len(list(code.uses(name))) == 2


def _is_of_start(code: Code, at: int) -> bool:
    """Whether what is at a place runs once, before anything is read."""
    node = code.at(at)
    function = code.body_of(node) if node is not None else None
    return node is not None and function is not None and _loop(code, node) is None and _is_early(code, function)


def _is_start(code: Code, function: Node) -> bool:
    return class_made(code, function) is not None or code.defined_name(function) == "main"


def _is_of_timer(code: Code, function: Node) -> bool:
    """Whether a timer runs a function, itself or through a lambda."""
    name = (code.defined_name(function) or "").rpartition("::")[2] if function.type == "function_definition" else ""
    for call in code.calls:
        if call.name in TIMERS:
            for given in call.arguments:
                if given.id == function.id or (name and re.search(rf"\b{re.escape(name)}\b", code.text(given))):
                    return True
    return False


def _loop(code: Code, node: Node) -> Node | None:
    for outer in code.above(node):
        if outer.type in FUNCTIONS:
            return None
        if outer.type in LOOPS:
            return outer
    return None
