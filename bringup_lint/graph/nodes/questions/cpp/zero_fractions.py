"""Fractions of whole numbers in C++, which are 0."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_text import plain_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FRACTION = regex(
    r"\"(?:[^\"\\\n]|\\.){0,400}\""
    r"|(?:[(=,?:{]|\breturn\b|[\w)\]]\s{1,4}[-+])\s{0,4}(?P<all>(?P<part>[1-9]\d{0,8})\s{0,4}/\s{0,4}(?P<whole>[1-9]\d{0,8}))(?![\w.'])",
)
"""A quotient of two literals at the start of a product, so that it is worked out first. Strings are passed over."""

_QUOTIENT = regex(r"\d\s{0,4}/\s{0,4}[1-9]", hints="/")


def zero_fractions(nodes: Nodes) -> Iterator[list[Located]]:
    """Those of one source together."""
    for driver in nodes.drivers:
        matches = _FRACTION.finditer(plain_of(driver.source)) if driver.source.matches(_QUOTIENT) else ()
        found = [each for each in matches if each["all"] is not None and int(each["part"]) < int(each["whole"])]
        if found:
            yield [driver.source.located(*each.span("all")) for each in found]
