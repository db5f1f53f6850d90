"""Hover: the rule behind a finding, and what the graph knows of the place."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from itertools import islice

from lsprotocol.types import Hover
from lsprotocol.types import MarkupContent
from lsprotocol.types import MarkupKind
from lsprotocol.types import Position

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.registry import doc_of
from bringup_lint.report.docs import markdown
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Found
from bringup_lint.server.references import nodes_at

_MOST_LINES = 12
"""How many relations of a node are shown."""


def hover(analysis: Analysis, path: str, position: Position) -> Hover | None:
    """What is known of a place; None when that is nothing."""
    source = analysis.source(path)
    if source is None:
        return None
    offset = analysis.positions(source).offset(position)
    touched = list(analysis.touching(path, offset, offset))
    parts = [*_nodes(analysis, nodes_at(analysis, source, offset)), *_rules(analysis, touched)]
    return Hover(MarkupContent(MarkupKind.Markdown, "\n\n---\n\n".join(parts))) if parts else None


def _rules(analysis: Analysis, touched: Iterable[Found]) -> Iterator[str]:
    for rule_id in dict.fromkeys(found.finding.rule for found in touched):
        rule = analysis.rules.get(rule_id)
        if rule is not None:
            yield markdown(doc_of(rule)).rstrip()


def _nodes(analysis: Analysis, nodes: Iterable[Node]) -> Iterator[str]:
    graph = analysis.robot.graph
    for node in nodes:
        leading = [_leading(edge) for edge in graph.out.get(node, ())]
        led = [_led(edge) for edge in graph.into.get(node, ())]
        lines = list(dict.fromkeys((*leading, *led)))
        shown = [f"- {line}" for line in islice(lines, _MOST_LINES)]
        shown += [f"- … and {len(lines) - _MOST_LINES} more"] * (len(lines) > _MOST_LINES)
        if shown:
            yield "\n".join((f"**{node.kind.replace('-', ' ')}** {_code(node.name)}", "", *shown))


def _leading(edge: Edge) -> str:
    return f"{_kind(edge)} → {_code(edge.target.name)}: {_code(str(edge))}"


def _led(edge: Edge) -> str:
    return f"{_kind(edge)} ← {_code(edge.source.name)}: {_code(str(edge))}"


def _kind(edge: Edge) -> str:
    return edge.kind.replace("-", " ")


def _code(text: str) -> str:
    """A text of the tree, of which Markdown understands nothing."""
    text = " ".join(text.split())
    fence = "``" if "`" in text else "`"
    return f"{fence}{text.replace('``', '` `')}{fence}" if text else ""
