"""Ordering cycles, and what systemd does about them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.dependencies import HARD
from bringup_lint.graph.systemd.dependencies import PULLING

ROOTS = ("graphical.target", "multi-user.target")


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
    return f"{edge.why}, {edge.where.source.basename}:{edge.where.line}" if edge.where else edge.why


def ordering_cycles(graph: Graph, roots: Iterable[str] = ROOTS) -> Iterator[Cycle]:
    """Shortest cycles of every strongly connected component of the ordering that the tree has a part in."""
    remaining = _unsortable(graph)
    if not remaining:
        return
    import networkx

    digraph = networkx.DiGraph()
    for edge in graph.edges("orders"):
        if edge.source in remaining and edge.target in remaining:
            digraph.add_edge(edge.source, edge.target)
    for component in sorted(networkx.strongly_connected_components(digraph), key=min):
        if len(component) > 1 and _is_written(graph, component):
            for edges in _covering_cycles(graph, component):
                members = {edge.source for edge in edges}
                root = _common_root(graph, members, roots)
                required = frozenset(graph.reachable(root, HARD)) if root else frozenset()
                yield Cycle(edges, root, root is not None and members <= required, frozenset(members - required))


def _is_written(graph: Graph, component: set[Node]) -> bool:
    """Whether a line of the tree contributes, rather than only units of several releases of the
    distribution."""
    edges = (edge for node in component for edge in graph.out.get(node, ()))
    return any(edge.where and edge.kind == "orders" and edge.target in component for edge in edges)


def _covering_cycles(graph: Graph, component: set[Node]) -> Iterator[tuple[Edge, ...]]:
    """A shortest cycle, then one through every further member that a line of the tree puts into a cycle."""
    covered: set[Node] = set()
    first = _shortest_cycle(graph, component)
    for node in [None, *sorted(component)]:
        if node is None:
            edges = first
        elif node in covered or not _has_written_edge(graph, node, component):
            continue
        else:
            edges = _cycle_through(graph, node, component, 0)
        if edges:
            yield edges
            covered |= {edge.source for edge in edges}


def _has_written_edge(graph: Graph, node: Node, component: set[Node]) -> bool:
    ends = [
        *((e, e.target) for e in graph.out.get(node, ())),
        *((e, e.source) for e in graph.into.get(node, ())),
    ]
    return any(edge.where and edge.kind == "orders" and other in component for edge, other in ends)


def _unsortable(graph: Graph) -> set[Node]:
    """What is left when everything that can be ordered is taken away, from both ends."""
    nodes = set(graph.out) | set(graph.into)
    for ends, others in ((graph.into, graph.out), (graph.out, graph.into)):
        counts = {node: sum(edge.kind == "orders" for edge in ends.get(node, ())) for node in nodes}
        for node in nodes:
            for edge in ends.get(node, ()):
                far = edge.source if ends is graph.into else edge.target
                if edge.kind == "orders" and far not in nodes:
                    counts[node] -= 1
        ready = deque(node for node in nodes if counts[node] == 0)
        done = set()
        while ready:
            node = ready.popleft()
            done.add(node)
            for edge in others.get(node, ()):
                far = edge.target if ends is graph.into else edge.source
                if edge.kind == "orders" and far in nodes:
                    counts[far] -= 1
                    if counts[far] == 0:
                        ready.append(far)
        nodes -= done
    return nodes


def _shortest_cycle(graph: Graph, component: set[Node]) -> tuple[Edge, ...]:
    best: tuple[Edge, ...] = ()
    for start in sorted(component):
        found = _cycle_through(graph, start, component, len(best))
        if found and (not best or len(found) < len(best)):
            best = found
        if len(best) == 2:
            break
    return best


def _cycle_through(graph: Graph, start: Node, component: set[Node], limit: int) -> tuple[Edge, ...]:
    arrived: dict[Node, Edge] = {}
    pending = deque([(start, 0)])
    while pending:
        node, length = pending.popleft()
        if limit and length >= limit:
            return ()
        for edge in sorted(graph.out.get(node, ()), key=_written_first):
            if edge.kind != "orders" or edge.target not in component:
                continue
            if edge.target == start:
                path = [edge]
                while path[0].source != start:
                    path.insert(0, arrived[path[0].source])
                return tuple(path)
            if edge.target not in arrived:
                arrived[edge.target] = edge
                pending.append((edge.target, length + 1))
    return ()


def _written_first(edge: Edge) -> tuple[bool, str]:
    return (edge.where is None, edge.target.name)


def _common_root(graph: Graph, members: set[Node], roots: Iterable[str]) -> Node | None:
    """Who pulls all members into one transaction: a boot target, a member, or another unit."""
    candidates = [*(Node("unit", name) for name in roots), *sorted(members)]
    pullers = {edge.source for member in members for edge in graph.into.get(member, ()) if edge.kind in PULLING}
    for root in [*candidates, *sorted(pullers)]:
        if members <= graph.reachable(root, PULLING):
            return root
    return None
