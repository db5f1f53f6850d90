"""Strongly connected components, without networkx: to import it costs more than most runs."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Hashable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import Generic
from typing import TypeVar

Node = TypeVar("Node", bound=Hashable)


def components(nodes: Iterable[Node], following: Callable[[Node], Iterable[Node]]) -> list[set[Node]]:
    """The sets of several nodes that all lead to each other. ``following`` gives the ends of the edges of a node."""
    return [found for found in in_order(nodes, following) if len(found) > 1]


def in_order(nodes: Iterable[Node], following: Callable[[Node], Iterable[Node]]) -> Iterator[set[Node]]:
    """The components, those of one node too, each after those that it leads to."""
    search = _Search(following)
    for node in nodes:
        if node not in search.number:
            yield from search.from_root(node)


class _Search(Generic[Node]):
    """Tarjan's algorithm without recursion."""

    def __init__(self, following: Callable[[Node], Iterable[Node]]) -> None:
        self.following = following
        self.number: dict[Node, int] = {}
        """In the order of the visits."""
        self.lowest: dict[Node, int] = {}
        """The smallest number that the node leads back to."""
        self.open: dict[Node, None] = {}
        """The nodes whose component is not complete yet, in the order of the visits."""

    def from_root(self, root: Node) -> Iterator[set[Node]]:
        way = [(root, self._visit(root))]
        while way:
            node, rest = way[-1]
            other = self._next(node, rest)
            if other is not None:
                way.append((other, self._visit(other)))
                continue
            way.pop()
            if way:
                self._lower(way[-1][0], self.lowest[node])
            if self.lowest[node] == self.number[node]:
                yield self._close(node)

    def _next(self, node: Node, rest: Iterator[Node]) -> Node | None:
        """The next node to visit; edges to nodes that were visited before are taken note of."""
        for other in rest:
            if other not in self.number:
                return other
            if other in self.open:
                self._lower(node, self.number[other])
        return None

    def _visit(self, node: Node) -> Iterator[Node]:
        self.number[node] = self.lowest[node] = len(self.number)
        self.open[node] = None
        return iter(self.following(node))

    def _lower(self, node: Node, number: int) -> None:
        self.lowest[node] = min(self.lowest[node], number)

    def _close(self, root: Node) -> set[Node]:
        found = set()
        while root in self.open:
            node, _ = self.open.popitem()
            found.add(node)
        return found
