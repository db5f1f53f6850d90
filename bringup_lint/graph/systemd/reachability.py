"""Which nodes of a graph lead to which others, for many pairs: each node gets a rank once, and edges never lead to a
higher one."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable

from bringup_lint.graph.components import in_order
from bringup_lint.graph.graph import Node

Following = Callable[[Node], Iterable[Node]]


class Reachability:
    """Nodes with the same rank lead to each other; others lead only to lower ranks. Between two nodes, only those with
    a rank between theirs are looked at."""

    def __init__(self, nodes: Iterable[Node], following: Following) -> None:
        self._following = following
        self._ranks: dict[Node, int] = {}
        self.components: list[set[Node]] = []
        """The sets of several nodes that all lead to each other."""
        for rank, members in enumerate(in_order(nodes, following)):
            self._ranks.update(dict.fromkeys(members, rank))
            if len(members) > 1:
                self.components.append(members)

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
