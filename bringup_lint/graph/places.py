"""From a line of the tree to the node that the line is about."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict

from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span


class _Lines(NamedTuple):
    first: int
    last: int
    node: Node


class Places:
    """The places of a graph's nodes, as they are now."""

    def __init__(self, graph: Graph) -> None:
        self._lines: dict[str, list[_Lines]] = defaultdict(list)
        for node, known in graph.places.items():
            for where in known:
                self._lines[where.path].append(_Lines(where.line, max(where.end_position.line, where.line), node))
        for lines in self._lines.values():
            lines.sort(key=lambda each: (each.first, -each.last, each.node))

    def of(self, where: Span) -> list[Node]:
        """The nodes of the innermost lines that hold a place; several when one definition makes several nodes."""
        return self.at(where.path, where.line)

    def at(self, path: str, line: int) -> list[Node]:
        lines = self._lines.get(path, [])
        before = bisect_right(lines, line, key=lambda each: each.first)
        holding = next((each for each in reversed(lines[:before]) if each.last >= line), None)
        return [each.node for each in lines[:before] if each[:2] == holding[:2]] if holding else []
