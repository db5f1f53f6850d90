"""The robot's graph and its findings as one plain document, which every format of the picture prints.

``docs/graph.schema.json`` describes it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from typing import Any

from bringup_lint import __version__
from bringup_lint.finding import Finding
from bringup_lint.finding.place import place_of
from bringup_lint.finding.redact import Mask
from bringup_lint.finding.redact import widened
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.layers import LAYERS
from bringup_lint.graph.layers import layer_of_edge
from bringup_lint.graph.layers import layer_of_node
from bringup_lint.graph.places import Places
from bringup_lint.report.picture.labels import labels

VERSION = 1
_ORDER = {layer: at for at, layer in enumerate(LAYERS)}


def picture(graph: Graph, findings: Iterable[Finding], mask: Mask | None = None) -> dict[str, Any]:
    """The document; findings that a comment suppresses are left out, and no secret stays.

    ``mask`` is what hid the secrets of the findings.
    """
    shown = tuple(finding for finding in findings if finding.suppression is None)
    sources = {where.source: None for places in graph.places.values() for where in places}
    sources.update((edge.where.source, None) for edge in graph.edges() if edge.where is not None)
    mask = widened(mask, sources)
    hide = mask.words if mask else str
    shown = tuple(map(mask.finding, shown)) if mask else shown
    on_nodes, on_edges = _on_nodes(graph, shown), _on_lines(shown)
    named = labels(graph)
    nodes = sorted(graph.nodes, key=lambda node: (_ORDER[layer_of_node(node)], graph.ranks.get(node, 0), node))
    edges = sorted(graph.edges(), key=_edge_order)
    return {
        "schema_version": VERSION,
        "tool": {"name": "bringup-lint", "version": __version__},
        "layers": [{"id": layer, "title": title} for layer, title in LAYERS.items()],
        "focus": [],
        "nodes": [
            {
                "id": hide(node_id(node)),
                "kind": node.kind,
                "layer": layer_of_node(node),
                "label": hide(named[node]),
                **_place(graph, node),
                "rank": graph.ranks.get(node),
                "findings": sorted(on_nodes.get(node, ())),
            }
            for node in nodes
        ],
        "edges": [
            {
                "source": hide(node_id(edge.source)),
                "target": hide(node_id(edge.target)),
                "kind": edge.kind,
                "layer": layer_of_edge(edge),
                "why": hide(edge.said),
                "origin": str(edge.origin),
                "condition": hide(edge.condition),
                "path": edge.where.path if edge.where else None,
                "line": edge.where.line if edge.where else None,
                "findings": sorted(on_edges.get((edge.where.path, edge.where.line), ())) if edge.where else [],
            }
            for edge in edges
        ],
        "findings": [_finding(finding) for finding in shown],
    }


def node_id(node: Node) -> str:
    """``unit:robot.service``; with ``@`` and a place where the tree has several of that name."""
    return f"{node.kind}:{node.name}@{node.place}" if node.place else f"{node.kind}:{node.name}"


def _edge_order(edge: Edge) -> tuple[object, ...]:
    where = (edge.where.path, edge.where.start) if edge.where else ("", 0)
    return (_ORDER[layer_of_edge(edge)], edge.source, edge.target, edge.kind, where, edge.said)


def _place(graph: Graph, node: Node) -> dict[str, Any]:
    places = graph.places.get(node)
    return {"path": places[0].path, "line": places[0].line} if places else {"path": None, "line": None}


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "rule": finding.rule,
        "severity": str(finding.severity),
        "message": finding.message,
        "advice": finding.advice,
        "path": finding.span.path,
        "line": place_of(finding.span).line,
    }


def _on_nodes(graph: Graph, findings: tuple[Finding, ...]) -> dict[Node, set[int]]:
    """A finding belongs to the innermost lines that hold it."""
    places = Places(graph)
    found: dict[Node, set[int]] = defaultdict(set)
    for index, finding in enumerate(findings):
        for node in places.at(finding.span.path, place_of(finding.span).line):
            found[node].add(index)
    return found


def _on_lines(findings: tuple[Finding, ...]) -> dict[tuple[str, int], set[int]]:
    """Findings by the lines that they show."""
    found: dict[tuple[str, int], set[int]] = defaultdict(set)
    for index, finding in enumerate(findings):
        for span in (finding.span, *(part.span for part in (*finding.related, *finding.chain))):
            found[span.path, place_of(span).line].add(index)
    return found
