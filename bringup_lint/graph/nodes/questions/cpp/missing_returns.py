"""Functions of C++ nodes that end without the value that they owe, and whether something calls them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.threads import package_sources
from bringup_lint.model.cpp_source import MissingReturn
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_IDENTIFIER = regex(r"[A-Za-z_]\w*")
_OVERRIDES = regex(r"\s{0,4}\([^;{}]{0,400}\)[\w\s]{0,40}\boverride\b")
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
        called = _called(nodes, node.source, {each.function for each in node.missing_returns})
        yield from ((node.source, each, each.function in called) for each in node.missing_returns)


def _called(nodes: Nodes, source: Source, functions: set[str]) -> set[str]:
    """The functions that a source of the package names other than to declare or define them, or a base class may."""
    called = {name for name in functions if _OF_BASES.match(name)}
    if functions == called:
        return called
    for each in package_sources(nodes, source):
        if each is not None:
            called.update(_named(plain_of(each), functions))
    return called


def _named(plain: str, functions: set[str]) -> Iterator[str]:
    for found in _IDENTIFIER.finditer(plain):
        if found[0] in functions:
            overrides = _OVERRIDES.match(plain, found.end())
            if overrides is not None or not _is_declared(plain, found.start()):
                yield found[0]


def _is_declared(plain: str, start: int) -> bool:
    """Whether a type is written before a name."""
    before = plain[max(0, start - WINDOW) : start]
    scope = _SCOPE.search(before)
    before = before[: scope.start()] if scope is not None else before
    return _TYPE.search(before) is not None and _WORD.search(before) is None
