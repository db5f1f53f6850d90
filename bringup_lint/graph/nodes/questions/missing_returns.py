"""Functions of C++ nodes that end without the value that they owe, and whether something calls them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.threads import package_sources
from bringup_lint.model.cpp_source import MissingReturn
from bringup_lint.model.cpp_text import blanked
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_SCOPE = regex(r"\b(?:\w{1,80}\s{0,4}::\s{0,4}){1,4}\Z")
_TYPE = regex(r"(?:\w|(?<!-)>)\s{0,4}[*&]{0,2}\s{0,40}\Z")
_WORD = regex(r"\b(?:return|else|case|co_return|do)\s{1,40}\Z")
_OF_BASES = regex(r"on_\w{1,40}\Z|(?:read|write|update|init|tick|export_\w{1,40})\Z")
"""What the classes of ros2_control, of lifecycle nodes and of behaviour trees call."""
WINDOW = 200
"""Code points before a name that are looked at."""


def missing_returns(nodes: Nodes) -> Iterator[tuple[Source, MissingReturn, bool]]:
    """Each with whether its package calls it, or a base class does."""
    for node in nodes.cpp:
        for found in node.missing_returns:
            yield node.source, found, _is_called(nodes, node.source, found.function)


def _is_called(nodes: Nodes, source: Source, name: str) -> bool:
    """Whether a source of the package names a function other than to declare or define it, or a base class may."""
    if _OF_BASES.match(name):
        return True
    for each in package_sources(nodes.files, nodes.launch.workspace.owner(source), source):
        if each is not None and name in each.text and _names(blanked(each.text), name):
            return True
    return False


def _names(plain: str, name: str) -> bool:
    named = re.compile(rf"\b{re.escape(name)}\b(?P<rest>\s{{0,4}}\([^;{{}}]{{0,400}}\)[\w\s]{{0,40}}\boverride\b)?")
    return any(found["rest"] or not _is_declared(plain, found.start()) for found in named.finditer(plain))


def _is_declared(plain: str, start: int) -> bool:
    """Whether a type is written before a name."""
    before = plain[max(0, start - WINDOW) : start]
    scope = _SCOPE.search(before)
    before = before[: scope.start()] if scope is not None else before
    return _TYPE.search(before) is not None and _WORD.search(before) is None
