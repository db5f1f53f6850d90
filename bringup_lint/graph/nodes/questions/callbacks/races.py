"""Messages of C++ nodes that two threads share, without a lock in the source or in its header."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_source import MessageRace
from bringup_lint.parsers.cpp_node.races import LOCKS

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def races(nodes: Nodes) -> Iterator[list[MessageRace]]:
    """Those of one file together."""
    for node in nodes.cpp:
        if node.races and not LOCKS.search(with_header(nodes, node.source)):
            yield node.races
