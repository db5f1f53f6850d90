"""Strongly connected components, without networkx: to import it costs more than most runs."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Hashable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.type_names import TypeVar

Node = TypeVar("Node", bound=Hashable)


def in_order(nodes: Iterable[Node], following: Callable[[Node], Iterable[Node]]) -> Iterator[set[Node]]:
    """The components, those of one node too, each after those that it leads to: Tarjan's algorithm without recursion.
    ``following`` gives the ends of the edges of a node."""
    number: dict[Node, int] = {}
    """In the order of the visits."""
    lowest: dict[Node, int] = {}
    """The smallest number that the node leads back to, as long as its component is not complete."""
    way: list[tuple[Node, Iterator[Node]]] = []
    """The nodes from the root to the present one, each with the ends of its edges that are still to be looked at."""
    for root in nodes:
        if root in number:
            continue
        number[root] = lowest[root] = len(number)
        way.append((root, iter(following(root))))
        while way:
            node, rest = way[-1]
            low = lowest[node]
            for other in rest:
                if other not in number:
                    lowest[node] = low
                    number[other] = lowest[other] = len(number)
                    way.append((other, iter(following(other))))
                    break
                if other in lowest and number[other] < low:
                    low = number[other]
            else:
                way.pop()
                lowest[node] = low
                if way and low < lowest[way[-1][0]]:
                    lowest[way[-1][0]] = low
                if low == number[node]:
                    yield _close(node, lowest)


def _close(root: Node, lowest: dict[Node, int]) -> set[Node]:
    """Take the nodes that were visited since the root of a component out of those that are not complete."""
    found = set()
    while root in lowest:
        node, _ = lowest.popitem()
        found.add(node)
    return found
