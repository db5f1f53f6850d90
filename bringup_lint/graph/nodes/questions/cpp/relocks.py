"""Mutexes that a thread locks twice, with the header that says what kind of mutex they are."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_driver import Relock
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_driver.relocks import PLAIN

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def relocks(nodes: Nodes) -> Iterator[list[Relock]]:
    """Those of one mutex of a file together."""
    for driver in nodes.drivers:
        by_mutex: dict[str, list[Relock]] = {}
        text = blanked(with_header(nodes, driver.source)) if driver.relocks else ""
        for each in driver.relocks:
            if each.is_typed or _is_plain(text, each.mutex):
                by_mutex.setdefault(each.mutex, []).append(each)
        yield from by_mutex.values()


def _is_plain(text: str, name: str) -> bool:
    """Whether a text declares a mutex that one thread may hold only once."""
    declared = re.findall(rf"\b(?:std::)?(\w*mutex)\s+(?:\w+\s*,\s*)?{re.escape(name)}\b\s*[;,{{=]", text)
    return bool(declared) and all(each in PLAIN for each in declared)
