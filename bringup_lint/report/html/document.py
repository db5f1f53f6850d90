"""The picture as the page's script reads it: sound, complete and joined with the findings of the report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.finding.place import place_of
from bringup_lint.report.columns import printable

if TYPE_CHECKING:
    from bringup_lint.finding import Finding
    from bringup_lint.report.model import Report


def document(picture: Mapping[str, Any], report: Report | None) -> dict[str, Any]:
    """Layers, nodes, edges and findings; edges name their ends by index, and both name findings by index.

    Edges between unknown nodes are left out. With a report, the indices are those of its shown findings.
    """
    drawn = picture.get("findings", ())
    findings = [_told(finding) for finding in report.shown] if report else [_plain(finding) for finding in drawn]
    places = _places(drawn, findings)
    nodes = list(picture.get("nodes", ()))
    number = {node["id"]: index for index, node in enumerate(nodes)}
    return {
        "layers": list(_layers(picture.get("layers", ()), nodes)),
        "nodes": [_node(node, places) for node in nodes],
        "edges": [
            _edge(edge, number, places)
            for edge in picture.get("edges", ())
            if edge["source"] in number and edge["target"] in number
        ],
        "findings": findings,
    }


def _layers(layers: Iterable[Mapping[str, Any]], nodes: Iterable[Mapping[str, Any]]) -> Iterator[dict[str, str]]:
    """The layers that hold a node, in their order."""
    titles = {layer["id"]: layer["title"] for layer in layers}
    held = dict.fromkeys(node["layer"] for node in nodes)
    for layer in (*titles, *(layer for layer in held if layer not in titles)):
        if layer in held:
            yield {"id": printable(layer), "title": printable(titles.get(layer, layer))}


def _node(node: Mapping[str, Any], places: Mapping[int, int]) -> dict[str, Any]:
    return {
        **{key: printable(str(node[key])) for key in ("id", "kind", "layer", "label")},
        "rank": node.get("rank"),
        **_where(node),
        "findings": _held(node, places),
    }


def _edge(edge: Mapping[str, Any], number: Mapping[str, int], places: Mapping[int, int]) -> dict[str, Any]:
    return {
        "source": number[edge["source"]],
        "target": number[edge["target"]],
        "kind": printable(edge["kind"]),
        "why": printable(edge.get("why") or ""),
        **_where(edge),
        "findings": _held(edge, places),
    }


def _where(item: Mapping[str, Any]) -> dict[str, Any]:
    path = item.get("path")
    return {"path": path and printable(path), "line": item.get("line")}


def _held(item: Mapping[str, Any], places: Mapping[int, int]) -> list[int]:
    return sorted({places[index] for index in item.get("findings", ()) if index in places})


def _plain(finding: Mapping[str, Any]) -> dict[str, Any]:
    words = {key: printable(finding.get(key) or "") for key in ("rule", "severity", "message", "advice")}
    return {**words, **_where(finding)}


def _told(finding: Finding) -> dict[str, Any]:
    return {
        "rule": printable(finding.rule),
        "severity": str(finding.severity),
        "message": printable(finding.message),
        "advice": printable(finding.advice),
        "path": printable(finding.span.path),
        "line": place_of(finding.span).line,
    }


def _places(drawn: Iterable[Mapping[str, Any]], findings: Iterable[Mapping[str, Any]]) -> dict[int, int]:
    """Where each finding of the picture is among the findings of the page."""
    known = {key: index for index, key in enumerate(_keys(findings))}
    found = ((index, known.get(key)) for index, key in enumerate(_keys(map(_plain, drawn))))
    return {index: place for index, place in found if place is not None}


def _keys(findings: Iterable[Mapping[str, Any]]) -> Iterator[tuple[Any, ...]]:
    """What tells findings apart: their rule and line, and a count of those that share both."""
    seen: Counter[tuple[Any, ...]] = Counter()
    for finding in findings:
        key = (finding["rule"], finding["path"], finding["line"])
        seen[key] += 1
        yield (*key, seen[key])
