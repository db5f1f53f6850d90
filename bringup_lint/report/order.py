"""The order of a long report for people: findings with one cause together, errors on what starts at boot first."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from bringup_lint.finding import Finding
from bringup_lint.graph.systemd.relations import ROOTS
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.graph import Graph

LONG = 20
"""Findings from which on a report is grouped."""
_NOT_STARTING = frozenset({"orders", "conflicts", "part-of"})


def at_boot(graph: Graph) -> frozenset[str]:
    """The names of the files that decide what starts at boot: units that a boot target pulls in, and all that these
    read and start."""
    pending = [node for node in graph.nodes if node.name in ROOTS]
    seen = set(pending)
    files: set[str] = set()
    while pending:
        node = pending.pop()
        files.update(span.source.name for span in graph.places.get(node, ()))
        for edge in graph.out.get(node, ()):
            if edge.of_package or edge.kind in _NOT_STARTING:
                continue
            if edge.where:
                files.add(edge.where.source.name)
            if edge.target not in seen:
                seen.add(edge.target)
                pending.append(edge.target)
    return frozenset(files)


def by_cause(findings: Iterable[Finding], boot: frozenset[str]) -> list[list[Finding]]:
    """The findings of each rule together. A group begins with its worst, and the worst group comes first: errors on
    what starts at boot, other errors, warnings on what starts at boot, the rest."""
    groups: dict[str, list[Finding]] = defaultdict(list)
    for finding in sorted(findings, key=lambda each: _rank(each, boot)):
        groups[finding.rule].append(finding)
    return sorted(groups.values(), key=lambda group: (_rank(group[0], boot), -len(group), group[0].rule))


def _rank(finding: Finding, boot: frozenset[str]) -> tuple[int, bool]:
    return -finding.severity, finding.source.name not in boot
