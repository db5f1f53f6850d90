"""Ordering cycles, and what systemd does about them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import lru_cache

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.relations import HARD
from bringup_lint.graph.systemd.relations import PULLING
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.templates import has_control_flow

ROOTS = ("graphical.target", "multi-user.target")
MOST_VISITS = 500_000
"""Edges that the search for cycles of one component goes along; what is found until then is told."""
KEPT = 20
"""Questions of what a unit pulls in whose answers are kept: they are few, as most cycles have a boot target."""
MOST_ROOTS = 100
"""Units that are tried as the one that pulls in all members of a cycle."""


class Cycle(NamedTuple):
    """A shortest ordering cycle: each edge starts where the one before it ends, the last one ends at the
    start."""

    edges: tuple[Edge, ...]
    root: Node | None
    """A unit that pulls in every member, so that they meet in one transaction; None: they may never do."""
    fatal: bool
    """Every member is required by the root: systemd cannot drop any job, so the start fails."""
    droppable: frozenset[Node]
    """The members that nothing requires: systemd leaves one of them out."""

    @property
    def units(self) -> list[str]:
        return [edge.source.name for edge in self.edges]

    @property
    def against_targets(self) -> bool:
        """One unit alone that waits for a target which waits for it, over other targets at most."""
        return sum(not name.endswith(".target") for name in self.units) == 1

    @property
    def uncertain(self) -> bool:
        """Whether lines of it come from a template that decides which of its lines a unit has."""
        sources = (edge.where.source for edge in self.edges if edge.where)
        return any(source.template and has_control_flow(source.text) for source in sources)

    @property
    def waits(self) -> list[Edge]:
        """The edges as systemd tells them: who waits for whom, starting with a line of the tree."""
        edges = list(reversed(self.edges))
        first = next((at for at, edge in enumerate(edges) if edge.where and edge.where.source.judged), 0)
        return edges[first:] + edges[:first]

    def __str__(self) -> str:
        """``a.service → (After=, a.service:4) b.service → …``"""
        waits = self.waits
        steps = [f" → ({_said(edge)}) {edge.source.name}" for edge in waits]
        return waits[0].target.name + "".join(steps)


def _said(edge: Edge) -> str:
    return f"{edge.said}, {edge.where.source.basename}:{edge.where.line}" if edge.where else edge.said


def ordering_cycles(graph: Graph, components: Iterable[set[Node]], roots: Iterable[str] = ROOTS) -> Iterator[Cycle]:
    """Shortest cycles of every strongly connected component of the ordering that the tree has a part in."""
    reachable = lru_cache(KEPT)(graph.reachable)
    for nodes in sorted(components, key=min):
        component = _Component(graph, nodes)
        for edges in component.covering_cycles():
            members = {edge.source for edge in edges}
            root = _common_root(graph, members, roots, reachable)
            required = reachable(root, HARD) if root else set()
            yield Cycle(edges, root, root is not None and members <= required, frozenset(members - required))


class _Component:
    """Units that all wait for each other, and the edges between them."""

    def __init__(self, graph: Graph, nodes: set[Node]) -> None:
        self.nodes = sorted(nodes)
        self.out = {node: sorted(_inside(graph, node, nodes), key=_written_first) for node in self.nodes}
        self.visits = MOST_VISITS

    def covering_cycles(self) -> Iterator[tuple[Edge, ...]]:
        """A shortest cycle, then one through every further member that a line of the tree puts into a cycle. None
        where only units of several releases of the distribution contribute."""
        written = {
            end for edges in self.out.values() for edge in edges if edge.where for end in (edge.source, edge.target)
        }
        if not written:
            return
        first = self._shortest()
        yield first
        covered = {edge.source for edge in first}
        for node in self.nodes:
            if node in written and node not in covered and self.visits >= 0:
                edges = self._through(node)
                yield edges
                covered |= {edge.source for edge in edges}

    def _shortest(self) -> tuple[Edge, ...]:
        best = self._through(self.nodes[0])
        for start in self.nodes[1:]:
            if len(best) == 2 or self.visits < 0:
                break
            best = self._through(start, len(best)) or best
        return best

    def _through(self, start: Node, limit: int | None = None) -> tuple[Edge, ...]:
        """A shortest cycle through a member; nothing when it has ``limit`` edges or more."""
        arrived: dict[Node, Edge] = {}
        pending = deque([(start, 1)])
        while pending:
            node, length = pending.popleft()
            if limit is not None and length >= limit:
                return ()
            self.visits -= len(self.out[node])
            for edge in self.out[node]:
                if edge.target == start:
                    return _way_back(edge, start, arrived)
                if edge.target not in arrived:
                    arrived[edge.target] = edge
                    pending.append((edge.target, length + 1))
        return ()


def _inside(graph: Graph, node: Node, nodes: set[Node]) -> Iterator[Edge]:
    return (edge for edge in graph.out.get(node, ()) if edge.kind == "orders" and edge.target in nodes)


def _written_first(edge: Edge) -> tuple[bool, str]:
    return (edge.where is None, edge.target.name)


def _way_back(last: Edge, start: Node, arrived: dict[Node, Edge]) -> tuple[Edge, ...]:
    way = [last]
    while way[-1].source != start:
        way.append(arrived[way[-1].source])
    return tuple(reversed(way))


def _common_root(
    graph: Graph, members: set[Node], roots: Iterable[str], reachable: Callable[[Node, frozenset[str]], set[Node]]
) -> Node | None:
    """Who pulls all members into one transaction: a boot target, a member, or another unit."""
    candidates = [*(Node("unit", name) for name in roots), *sorted(members)]
    pullers = {edge.source for member in members for edge in graph.into.get(member, ()) if edge.kind in PULLING}
    for root in [*candidates, *sorted(pullers)][:MOST_ROOTS]:
        if members <= reachable(root, PULLING):
            return root
    return None
