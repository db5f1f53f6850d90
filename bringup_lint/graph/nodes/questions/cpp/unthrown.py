"""Exceptions that C++ code makes, and does not throw."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_text import plain_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_NAMES = (
    r"std::(?:runtime_error|logic_error|invalid_argument|out_of_range|domain_error|length_error|range_error|exception"
    r"|overflow_error|underflow_error|system_error)"
)
_MADE = regex(rf"{_NAMES}\s{{0,4}}[({{]", hints="std::")
_ALONE = regex(
    rf"(?:[;{{}})]|\belse\b|\b(?:default|case\s[\w:]{{1,80}})\s{{0,4}}:)\s{{0,200}}(?P<made>{_NAMES}\s{{0,4}}"
    r"(?:\((?:[^()\";{}]|\"(?:[^\"\\\n]|\\.)*\"|\([^()]{0,200}\)){0,400}\)"
    r"|\{(?:[^()\";{}]|\"(?:[^\"\\\n]|\\.)*\"|\([^()]{0,200}\)){0,400}\}))\s{0,40};"
)
"""A statement of its own. A base among the initializers of a constructor is not followed by a semicolon."""


def unthrown(nodes: Nodes) -> Iterator[list[Located]]:
    """Those of one source together."""
    for driver in nodes.drivers:
        source = driver.source
        matches = _ALONE.finditer(plain_of(source)) if source.matches(_MADE) else ()
        found = [source.located(*each.span("made")) for each in matches]
        if found:
            yield found
