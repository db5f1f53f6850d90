"""What one run found in a folder, by file, with the places as the protocol counts them."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property
from functools import lru_cache

from lsprotocol.types import PositionEncodingKind
from lsprotocol.types import Range
from pygls.uris import from_fs_path

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.finding import Finding
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.places import Places
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.registry import Rule
from bringup_lint.robot import Robot
from bringup_lint.server.positions import Positions
from bringup_lint.source import Source
from bringup_lint.source import Span


class Document(NamedTuple):
    """What an editor shows of a file."""

    uri: str
    """As the editor writes it: there is more than one way to quote a path."""
    text: str
    version: int | None = None


class Found(NamedTuple):
    """A finding twice: its places and fix are those of the files, its words are without secrets."""

    finding: Finding
    shown: Finding


@dataclass(frozen=True, eq=False)
class Analysis:
    """A run over a folder. Everything that is asked of it is asked in the thread of the worker."""

    folder: str
    robot: Robot
    found: tuple[Found, ...]
    """Those that nothing suppresses, in the order of output."""
    rules: Mapping[str, Rule]
    documents: Mapping[str, Document] = field(default_factory=dict)
    """What was open, by its absolute path."""
    encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16
    _positions: dict[Source, Positions] = field(default_factory=dict)

    def path(self, source: Source) -> str:
        return os.path.normpath(os.path.join(self.folder, source.name))

    def uri(self, source: Source) -> str:
        path = self.path(source)
        return self.documents[path].uri if path in self.documents else uri_of(path)

    def version(self, source: Source) -> int | None:
        """The version of a document that was open."""
        document = self.documents.get(self.path(source))
        return document.version if document else None

    def positions(self, source: Source) -> Positions:
        if source not in self._positions:
            self._positions[source] = Positions(source.text, self.encoding)
        return self._positions[source]

    def range(self, span: Span) -> Range:
        return self.positions(span.source).range(span.start, span.end)

    @cached_property
    def by_path(self) -> dict[str, list[Found]]:
        """Absolute path -> what was found there."""
        found: dict[str, list[Found]] = {}
        for each in self.found:
            if not each.finding.source.virtual:
                found.setdefault(self.path(each.finding.source), []).append(each)
        return found

    @cached_property
    def _sources(self) -> dict[str, Source]:
        return {self.path(source): source for source in self.robot.sources if source.origin is None}

    def source(self, path: str) -> Source | None:
        """The source of an absolute path; None for a file that no kind claims."""
        return self._sources.get(path)

    @cached_property
    def places(self) -> Places:
        return Places(self.robot.graph)

    @cached_property
    def _edges(self) -> dict[str, list[Edge]]:
        edges: dict[str, list[Edge]] = {}
        for edge in self.robot.graph.edges():
            if edge.where is not None:
                edges.setdefault(edge.where.path, []).append(edge)
        return edges

    def edges_of(self, source: Source) -> list[Edge]:
        """The edges of the graph that the lines of a file say."""
        return self._edges.get(source.name, [])

    def touching(self, path: str, start: int, end: int) -> Iterator[Found]:
        """What was found in a stretch of a file; a finding of the file as a whole touches its first line."""
        for each in self.by_path.get(path, ()):
            span = each.finding.span
            last = span.end or span.source.text.find("\n")
            if span.start <= end and start <= last:
                yield each


@lru_cache(maxsize=4_096)
def uri_of(path: str) -> str:
    """The file URI of an absolute path."""
    uri: str = from_fs_path(path)
    return uri


def of_findings(findings: Iterable[Finding], shown: Iterable[Finding], known: frozenset[str]) -> tuple[Found, ...]:
    """Pairs of findings and what is shown of them, without those that are suppressed or in the baseline."""
    pairs = (Found(*pair) for pair in zip(findings, shown))
    return tuple(each for each in pairs if not each.finding.suppression and each.shown.fingerprint not in known)
