"""What C++ nodes throw that handlers of exceptions do not take."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.threads import package_sources
from bringup_lint.model.cpp_driver import Thrown
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_TAKES = regex(
    r"\bcatch\s{0,4}\(\s{0,4}(?:\.\.\.|(?:const\s{1,4})?(?:char|int|unsigned|long|double|float|(?:std::)?string|auto)\b)",
    hints="catch",
)


_MISSES = regex(
    r"\bcatch\s{0,4}\(\s{0,4}(?:const\s{1,4})?(?:std\s{0,2}::|\w{1,60}(?:[eE]xception|[eE]rror)\b)", hints="catch"
)
"""A handler of exceptions."""


def thrown(nodes: Nodes) -> Iterator[tuple[list[Thrown], bool]]:
    """Those of one source together, where no handler of its package takes a text or a number; with whether there is
    one that would take an exception."""
    for driver in nodes.drivers:
        sources = list(package_sources(nodes, driver.source)) if driver.thrown else []
        if driver.thrown and not any(map(_may_take, sources)):
            yield driver.thrown, any(each is not None and each.matches(_MISSES) for each in sources)


def _may_take(source: Source | None) -> bool:
    return source is None or source.matches(_TAKES)
