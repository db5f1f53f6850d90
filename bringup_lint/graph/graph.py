"""The dependency graph of a robot: typed nodes, and edges that know the line that says so."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from enum import Enum
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    import networkx


class Node(NamedTuple):
    """Something of the robot: kind (``unit``, ``user-unit``, ``process``, ``launch-file``, ``device``, ...)
    and name."""

    kind: str
    name: str
    place: str = ""
    """The overlay or folder it belongs to, when the tree holds several things of that name."""


class Origin(str, Enum):
    """What makes an edge."""

    SETTING = "setting"
    """A line of a file, or what is known of the files that it names."""
    IMPLICIT = "implicit"
    """The type of a unit or another of its settings."""
    DEFAULT = "default"
    """``DefaultDependencies=``."""
    DISTRIBUTION = "distribution"
    """A unit that the distribution brings."""

    def __str__(self) -> str:
        return self.value


class Edge(NamedTuple):
    """A relation of two nodes and who says so: a line, or the reason of an implicit one."""

    kind: str
    """``orders`` (source starts before target), ``requires``, ``wants``, ``runs``, ``loads-env``, ..."""
    source: Node
    target: Node
    where: Span | None
    why: str
    """The setting (``After=``), or the reason of an implicit edge."""
    of_package: bool = False
    """Only there when a package of the distribution is installed and enabled, which nothing in the tree
    tells."""
    origin: Origin = Origin.SETTING
    condition: str = ""
    """On which it depends whether the edge is there: ``if use_lidar``, ``one of several``."""

    @property
    def said(self) -> str:
        """The setting with its condition, or ``implicit: <reason>``."""
        reason = f"implicit: {self.why}" if self.origin in (Origin.IMPLICIT, Origin.DEFAULT) else self.why
        return f"{reason} ({self.condition})" if self.condition else reason

    def __str__(self) -> str:
        """``After=, robot.service:4``, or the reason of an implicit edge."""
        return f"{self.said}, {self.where.path}:{self.where.line}" if self.where else self.said


@dataclass(eq=False)
class Graph:
    """Edges by their ends."""

    out: dict[Node, list[Edge]] = field(default_factory=dict)
    into: dict[Node, list[Edge]] = field(default_factory=dict)
    places: dict[Node, list[Span]] = field(default_factory=dict)
    """Where the tree defines a node, the main place first: a whole file, or the lines of it that are about the node."""
    rank: Callable[[], dict[Node, int]] = dict
    """Works out the ranks, of which only a picture asks."""
    failures: list[Exception] = field(default_factory=list)
    """What failed inside while a layer was joined; the layer is not complete then."""

    @cached_property
    def ranks(self) -> dict[Node, int]:
        """The place of a unit in the boot order, from 0: higher than that of every unit it starts after."""
        return self.rank()

    def copy(self) -> Graph:
        """The same edges in the same order, to add others."""
        return Graph(_copied(self.out), _copied(self.into))

    def add(self, edges: Iterable[Edge]) -> None:
        for edge in edges:
            self.out.setdefault(edge.source, []).append(edge)
            self.into.setdefault(edge.target, []).append(edge)

    def define(self, places: Iterable[tuple[Node, Span]]) -> None:
        for node, where in places:
            known = self.places.setdefault(node, [])
            if where not in known:
                known.append(where)

    @property
    def nodes(self) -> list[Node]:
        """Everything that is defined, and every end of an edge."""
        return sorted(self.out.keys() | self.into.keys() | self.places.keys())

    def edges(self, *kinds: str) -> Iterator[Edge]:
        for edges in self.out.values():
            yield from (edge for edge in edges if not kinds or edge.kind in kinds)

    def reachable(self, start: Node, kinds: frozenset[str]) -> set[Node]:
        """All nodes that edges of these kinds lead to, ``start`` included."""
        seen = {start}
        pending = [start]
        while pending:
            for edge in self.out.get(pending.pop(), ()):
                if edge.kind in kinds and edge.target not in seen:
                    seen.add(edge.target)
                    pending.append(edge.target)
        return seen

    def to_networkx(self, *kinds: str) -> networkx.MultiDiGraph[Node]:
        """The same graph for networkx's algorithms; every edge carries its Edge as ``edge``."""
        import networkx

        graph: networkx.MultiDiGraph[Node] = networkx.MultiDiGraph()
        for edge in self.edges(*kinds):
            graph.add_edge(edge.source, edge.target, edge=edge)
        return graph


def _copied(ends: dict[Node, list[Edge]]) -> dict[Node, list[Edge]]:
    return {node: list(edges) for node, edges in ends.items()}
