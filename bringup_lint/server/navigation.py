"""Go to definition and document links: from what a line names to the file that says what it is."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol.types import DocumentLink
from lsprotocol.types import Location
from lsprotocol.types import Position

from bringup_lint.server.analysis import Analysis
from bringup_lint.server.declarations import declarations_at
from bringup_lint.server.diagnostics import location
from bringup_lint.server.references import definitions
from bringup_lint.server.references import edges_at
from bringup_lint.source import Source
from bringup_lint.source import Span


def definition(analysis: Analysis, path: str, position: Position) -> list[Location]:
    """Where that is defined which a place names."""
    source = analysis.source(path)
    if source is None:
        return []
    offset = analysis.positions(source).offset(position)
    found = dict.fromkeys(declarations_at(analysis.robot, source, offset) or _of_graph(analysis, source, offset))
    return [location(analysis, _start(span)) for span in found if not span.source.virtual]


def _of_graph(analysis: Analysis, source: Source, offset: int) -> Iterator[Span]:
    for node in dict.fromkeys(edge.target for edge in edges_at(analysis, source, offset)):
        yield from definitions(analysis, node)


def _start(span: Span) -> Span:
    """The stretch to show: of a whole file its first line."""
    return span._replace(end=span.start) if span.start == 0 and span.end == len(span.source.text) else span


def document_links(analysis: Analysis, path: str) -> list[DocumentLink]:
    """The words of a file that name another file of the tree."""
    source = analysis.source(path)
    if source is None:
        return []
    links = {}
    for edge in analysis.edges_of(source):
        places = analysis.robot.graph.places.get(edge.target, ())
        whole = next((span for span in places if _start(span) != span), None)
        if edge.where is not None and edge.where.text and whole is not None and whole.source is not source:
            links[edge.where] = DocumentLink(analysis.range(edge.where), analysis.uri(whole.source))
    return list(links.values())
