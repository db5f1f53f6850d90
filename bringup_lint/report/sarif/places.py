"""Files and regions in SARIF's terms."""

from __future__ import annotations

from typing import Any

from bringup_lint.finding.place import inside
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.place import place_of
from bringup_lint.finding.uri import below_root
from bringup_lint.finding.uri import file_uri
from bringup_lint.finding.uri import quoted
from bringup_lint.report.model import Report
from bringup_lint.source import Source
from bringup_lint.source import Span

AROUND = 2
"""Lines of context above and below a region."""
LONGEST = 2000
"""Characters of a snippet; more is left out, for it would be most of the file."""


def location(name: str, report: Report) -> dict[str, str]:
    """A SARIF ``artifactLocation``: relative to ``%SRCROOT%`` where that is possible."""
    path = below_root(name, report.root, report.cwd)
    if path.startswith("/"):
        return {"uri": file_uri(path)}
    return {"uri": quoted(path), "uriBaseId": "%SRCROOT%"}


class Places:
    """The files that the results speak of, in the order in which they are met."""

    def __init__(self, report: Report) -> None:
        self.report = report
        self.artifacts: list[dict[str, Any]] = []
        self._locations: dict[str, dict[str, Any]] = {}

    def artifact(self, source: Source) -> dict[str, Any]:
        """The ``artifactLocation`` of a file."""
        if source.name not in self._locations:
            where = {**location(source.name, self.report), "index": len(self.artifacts)}
            self._locations[source.name] = where
            made: dict[str, Any] = {"location": where, "encoding": "utf-8"}
            if source.judged:
                made["roles"] = ["analysisTarget"]
            if source.virtual:
                made["contents"] = {"text": source.text}
            if source.kind:
                made["properties"] = {"kind": source.kind}
            self.artifacts.append(made)
        return self._locations[source.name]

    def physical(self, span: Span, *, context: bool = True) -> dict[str, Any]:
        """A ``physicalLocation`` with snippet and context."""
        made: dict[str, Any] = {"artifactLocation": self.artifact(span.source), "region": region(span)}
        around = _context(span) if context else None
        if around:
            made["contextRegion"] = around
        return made


def region(span: Span) -> dict[str, Any]:
    """Where a finding is. A whole file is its first line, since services want a line."""
    if is_whole_file(span):
        return {"startLine": 1}
    place = place_of(span)
    made: dict[str, Any] = {
        "startLine": place.line,
        "startColumn": place.column,
        "endLine": place.end_line,
        "endColumn": place.end_column,
    }
    return _with_snippet(made, inside(span).text.rstrip("\r\n"))


def exact_region(span: Span) -> dict[str, Any]:
    """What an edit replaces, line ends included."""
    source, start, end = inside(span)
    first, last = source.position(start), source.position(end)
    return {
        "startLine": first.line,
        "startColumn": first.column,
        "endLine": last.line,
        "endColumn": last.column,
    }


def _context(span: Span) -> dict[str, Any] | None:
    """The lines around a region, unless they add nothing or too much."""
    if is_whole_file(span):
        return None
    place = place_of(span)
    starts = span.source.line_starts
    first = max(place.line - AROUND, 1)
    last = min(place.end_line + AROUND, len(starts))
    end = starts[last] if last < len(starts) else len(span.source.text)
    if (first, last) == (place.line, place.end_line) or end - starts[first - 1] > LONGEST:
        return None
    return _with_snippet({"startLine": first, "endLine": last}, span.source.text[starts[first - 1] : end])


def _with_snippet(made: dict[str, Any], text: str) -> dict[str, Any]:
    if text and len(text) <= LONGEST:
        made["snippet"] = {"text": text}
    return made
