"""Which nodes of a graph lead to which others, for many pairs: each node gets a rank once, and edges never lead to a
higher one."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.graph import Node

Following = Callable[[Node], Iterable[Node]]


class Reachability:
    """Nodes with the same rank lead to each other; others lead only to lower ranks. Between two nodes, only those with
    a rank between theirs are looked at."""

    def __init__(self, nodes: Iterable[Node], following: Following) -> None:
        self._following = following
        self._ranks = dict(ranked(nodes, following))

    def leads(self, starts: Collection[Node], goal: Node) -> bool:
        """Whether one of the starts leads to a goal that is none of them."""
        lowest = self._ranks.get(goal)
        if lowest is None or goal in starts:
            return False
        higher = {node for node in starts if self._ranks.get(node, -1) >= lowest}
        pending = deque(higher)
        while pending:
            node = pending.popleft()
            if self._ranks[node] == lowest:
                return True
            for other in self._following(node):
                if other not in higher and self._ranks[other] >= lowest:
                    higher.add(other)
                    pending.append(other)
        return False


def ranked(nodes: Iterable[Node], following: Following) -> Iterator[tuple[Node, int]]:
    """Each node with its rank: the strongly connected components, in the order in which Tarjan's algorithm ends
    them."""
    seen: dict[Node, int] = {}
    lowest: dict[Node, int] = {}
    waiting: list[Node] = []
    done: set[Node] = set()
    rank = 0

    def enter(node: Node) -> tuple[Node, Iterator[Node]]:
        seen[node] = lowest[node] = len(seen)
        waiting.append(node)
        return node, iter(following(node))

    for root in nodes:
        path = [] if root in seen else [enter(root)]
        while path:
            node, others = path[-1]
            other = next(others, None)
            if other is None:
                path.pop()
                if path:
                    above = path[-1][0]
                    lowest[above] = min(lowest[above], lowest[node])
                if lowest[node] == seen[node]:
                    yield from ((each, rank) for each in _ended(waiting, node, done))
                    rank += 1
            elif other not in seen:
                path.append(enter(other))
            elif other not in done:
                lowest[node] = min(lowest[node], seen[other])


def _ended(waiting: list[Node], first: Node, done: set[Node]) -> Iterator[Node]:
    """Take the nodes of a component from those that wait for their rank."""
    while True:
        node = waiting.pop()
        done.add(node)
        yield node
        if node == first:
            return
