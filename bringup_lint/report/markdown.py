"""A short report for the summary of a job, or a comment on a change: a table, errors first, and a small picture."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.place import inside
from bringup_lint.pattern import regex
from bringup_lint.plural import counted
from bringup_lint.plural import of_severity
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Report
from bringup_lint.report.summary import suppressed
from bringup_lint.report.unicode import sound

ROWS = 60
LONGEST = 300
"""Characters of a message; GitHub takes 65,536 characters in a comment."""
NODES = 30
"""A picture with more nodes than this cannot be read in a comment."""
SIGNS = {Severity.ERROR: "❌ error", Severity.WARNING: "⚠️ warning", Severity.INFO: "ℹ️ info"}
_SAFE = regex(r"[\w./+:@=~-]*")
_MARKUP = regex(r"([\\`*_\[\]|~$])")


def render(report: Report) -> str:
    parts = (_heading(report), *_table(report), *_notes(report), *_picture(report))
    return str(sound("\n\n".join(parts) + "\n"))


def _heading(report: Report) -> str:
    counts = Counter(finding.severity for finding in report.shown)
    files = counted(report.files, "file")
    if not counts:
        return f"### bringup-lint: nothing to report in {files}"
    said = ", ".join(
        of_severity(counts[severity], str(severity)) for severity in reversed(Severity) if counts[severity]
    )
    places = len({finding.source.name for finding in report.shown})
    return f"### bringup-lint: {said} in {places} of {files}"


def _table(report: Report) -> Iterator[str]:
    findings = list(report.worst_first)
    if findings:
        head = ["| | where | what | rule |", "|---|---|---|---|"]
        yield "\n".join((*head, *(_row(finding, report) for finding in findings[:ROWS])))
    left = Counter(finding.severity for finding in findings[ROWS:])
    if left:
        said = ", ".join(of_severity(left[severity], str(severity)) for severity in sorted(left, reverse=True))
        yield f"{ROWS} of {len(findings)} findings are shown; {said} left out."


def _row(finding: Finding, report: Report) -> str:
    line, column = finding.source.position(inside(finding.span).start)
    rule = report.rules.get(finding.rule)
    name = _code(finding.rule)
    linked = f"[{name}]({rule.uri})" if rule and rule.uri else name
    cells = (SIGNS[finding.severity], _code(f"{finding.source.name}:{line}:{column}"), _what(finding), linked)
    return f"| {' | '.join(cells)} |"


def _what(finding: Finding) -> str:
    places = dict.fromkeys(related.span.path for related in finding.related)
    others = [_code(path) for path in places if path != finding.source.name][:3]
    also = f"<br>see {', '.join(others)}" if others else ""
    return escaped(_cut(finding.message, LONGEST)) + also


def _notes(report: Report) -> Iterator[str]:
    silenced = suppressed(report)
    notes = [silenced] if silenced else []
    notes += report.narrowed
    notes += [f"{len(report.known)} known to the baseline"] if report.known else []
    notes += [f"{report.elsewhere} more in which the change has no part"] if report.elsewhere else []
    if notes:
        yield " · ".join(map(escaped, notes))
    for told in report.notifications:
        yield f"**{told.level}**: {escaped(_cut(told.message, LONGEST))}"


def _picture(report: Report) -> Iterator[str]:
    """What the findings are about in the picture of the bring-up, when it is small enough to read."""
    if not report.picture:
        return
    from bringup_lint.report.picture.mermaid import render as drawn

    document = _readable(report.picture)
    if document["nodes"] and len(document["nodes"]) <= NODES:
        summary = "<details><summary>The bring-up around the findings</summary>"
        yield f"{summary}\n\n```mermaid\n{drawn(document)}```\n\n</details>"


def _readable(picture: dict[str, Any]) -> dict[str, Any]:
    """The picture, or the part of it one step around the findings when the whole is large."""
    if len(picture["nodes"]) <= NODES:
        return picture
    from bringup_lint.report.picture.selection import around

    return around(picture, {node["id"] for node in picture["nodes"] if node["findings"]})


def _code(text: str) -> str:
    text = printable(text)
    return f"`{text}`" if _SAFE.fullmatch(text) and text else f"<code>{escaped(text)}</code>"


def _cut(text: str, most: int) -> str:
    text = " ".join(text.split())
    return text if len(text) <= most else f"{text[: most - 1]}…"


def escaped(text: str) -> str:
    """Text in which nothing is markup, and that mentions nobody and refers to no issue."""
    text = printable(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([@#])(?=\w)|(:)(?=//)", r"\1\2<!-- -->", _MARKUP.sub(r"\\\1", text))
