"""Workflow commands, which GitHub's runner shows as annotations at the lines of a change.

The runner reads ``::warning file=F,line=L,title=T::MESSAGE`` and takes back what ``%`` escapes
(``ActionCommand.TryParseV2`` of actions/runner).
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.place import inside
from bringup_lint.finding.place import is_whole_file
from bringup_lint.finding.place import place_of
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Notification
from bringup_lint.report.model import Report

COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}
_LEVELS = {"error": "error", "warning": "warning", "note": "notice"}
_DATA = str.maketrans({"%": "%25", "\r": "%0D", "\n": "%0A"})
_PROPERTY = str.maketrans({"%": "%25", "\r": "%0D", "\n": "%0A", ":": "%3A", ",": "%2C"})


def render(report: Report) -> str:
    """One command a finding, errors first: GitHub shows no more than ten of a level for one step. What a configuration
    keeps from being reported is a notice at the end."""
    told = (*report.notifications, *(Notification("note", said) for said in report.by_configuration))
    return "".join((*map(_annotation, report.worst_first), *map(_told, told)))


def _annotation(finding: Finding) -> str:
    properties = {**_place(finding), "title": finding.rule}
    said = ",".join(f"{name}={_shown(value).translate(_PROPERTY)}" for name, value in properties.items())
    message = "\n".join(map(_shown, _message(finding)))
    return f"::{COMMANDS[finding.severity]} {said}::{message.translate(_DATA)}\n"


def _place(finding: Finding) -> dict[str, str]:
    """The runner drops columns that stretch over several lines, so they are left out."""
    if finding.source.virtual:
        return {}
    if is_whole_file(finding.span):
        return {"file": finding.source.name, "line": "1"}
    place = place_of(finding.span)
    lines = {"file": finding.source.name, "line": str(place.line), "endLine": str(place.end_line)}
    if place.line != place.end_line:
        return lines
    return {**lines, "col": str(place.column), "endColumn": str(place.end_column)}


def _message(finding: Finding) -> Iterator[str]:
    yield finding.message
    for related in finding.related:
        yield f"{related.span.path}:{inside(related.span).line}: {related.message}"
    if finding.advice:
        yield f"help: {finding.advice}"


def _told(told: Notification) -> str:
    return f"::{_LEVELS[told.level]} title=bringup-lint::{_shown(told.message).translate(_DATA)}\n"


def _shown(text: str) -> str:
    return printable(" ".join(text.split()))
