"""What the text of a file refers to: nodes of the graph, and where they are defined."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.server.analysis import Analysis
from bringup_lint.source import Source
from bringup_lint.source import Span


def edges_at(analysis: Analysis, source: Source, offset: int) -> list[Edge]:
    """The relations that a place of a file says; of the shortest stretch of text that says some."""
    edges = [edge for edge in analysis.edges_of(source) if edge.where and edge.where.start <= offset <= edge.where.end]
    shortest = min((edge.where.end - edge.where.start for edge in edges if edge.where), default=0)
    return [edge for edge in edges if edge.where and edge.where.end - edge.where.start == shortest]


def nodes_at(analysis: Analysis, source: Source, offset: int) -> list[Node]:
    """What a place names; else the node whose definition it is a line of."""
    named = [edge.target for edge in edges_at(analysis, source, offset)]
    if named:
        return list(dict.fromkeys(named))
    return analysis.places.at(source.name, source.position(offset).line)


def definitions(analysis: Analysis, node: Node) -> Iterator[Span]:
    """Where a node is defined; of a thing that no file defines, where the files that make it do so."""
    places = analysis.robot.graph.places.get(node, ())
    yield from places
    if not places:
        for edge in analysis.robot.graph.out.get(node, ()):
            yield from analysis.robot.graph.places.get(edge.target, ())
