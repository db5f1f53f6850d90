"""How severities are shown: one as a sign with its name, several as signs with their counts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from bringup_lint.plural import counted
from bringup_lint.report.html.markup import icon

ORDER = ("error", "warning", "info")


def badge(severity: str) -> str:
    return f'<b class="severity {severity}">{icon(severity)}{severity}</b>'


def badges(severities: Iterable[str], *, named: bool = False) -> str:
    """The counts, the worst first; empty where there is nothing to count."""
    counts = Counter(severities)
    return " ".join(_counts(severity, counts[severity], named) for severity in ORDER if counts[severity])


def _counts(severity: str, count: int, named: bool) -> str:
    said = f"{count} info" if severity == "info" else counted(count, severity)
    return f'<b class="severity {severity}" title="{said}">{icon(severity)}{said if named else count}</b>'
