"""Reviewdog's diagnostic format, with related places, and with fixes as suggestions for the reviewer.

Its columns count bytes of UTF-8, from 1; ends are exclusive. Messages are Markdown in reviews, and plain text in logs.
"""

from __future__ import annotations

import json
import re
from typing import Any

from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.place import inside
from bringup_lint.finding.place import is_whole_file
from bringup_lint.pattern import regex
from bringup_lint.report.columns import plain_starts
from bringup_lint.report.columns import printable
from bringup_lint.report.model import Report
from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound
from bringup_lint.source import Source
from bringup_lint.source import Span

HOME = "https://github.com/bringup-lint/bringup-lint"
SEVERITIES = {Severity.ERROR: "ERROR", Severity.WARNING: "WARNING", Severity.INFO: "INFO"}
LONGEST = 20
"""Lines between the first and the last edit of a suggestion; a longer one would hide what changes."""
_MARKUP = regex(
    r"[^\s<]*(?:<[a-z/!?][^<>]*>[^\s<]*)+(?<![,.:;])"  # a tag, which GitHub drops
    r"|(?<!\S)[@_]\S+(?<![,.:;])"  # a mention, emphasis
    r"|\S*(?:\*|]\()\S*(?<![,.:;])",  # emphasis, a link
    re.I,
)


def render(report: Report) -> str:
    data = {
        "source": {"name": "bringup-lint", "url": HOME},
        "diagnostics": [_diagnostic(finding, report) for finding in report.shown],
    }
    return harmless(json.dumps(sound(data), indent=2)) + "\n"


def _diagnostic(finding: Finding, report: Report) -> dict[str, Any]:
    made: dict[str, Any] = {
        "message": "\n".join((_said(finding.message), *map(_line, finding.advice.splitlines()))),
        "location": _location(finding.span),
        "severity": SEVERITIES[finding.severity],
        "code": {"value": finding.rule},
    }
    rule = report.rules.get(finding.rule)
    if rule and rule.uri:
        made["code"]["url"] = rule.uri
    if finding.related:
        made["related_locations"] = [
            {"message": _said(related.message), "location": _location(related.span)} for related in finding.related
        ]
    suggestion = _suggestion(finding)
    if suggestion:
        made["suggestions"] = [suggestion]
    return made


def _said(text: str) -> str:
    return _line(" ".join(text.split()))


def _line(text: str) -> str:
    """A line that is no command for a CI runner, with words in backticks that Markdown would hide or change."""
    return _MARKUP.sub(r"`\g<0>`", plain_starts(printable(text)).replace("`", "'"))


def _location(span: Span) -> dict[str, Any]:
    if is_whole_file(span):
        return {"path": span.path, "range": {"start": {"line": 1}}}
    return {"path": span.path, "range": _range(span)}


def _range(span: Span) -> dict[str, Any]:
    source, start, end = inside(span)
    return {"start": _position(source, start), "end": _position(source, end)}


def _position(source: Source, offset: int) -> dict[str, int]:
    line, _ = source.position(offset)
    before = source.text[source.line_starts[line - 1] : offset]
    return {"line": line, "column": len(before.encode("utf-8", "replace")) + 1}


def _suggestion(finding: Finding) -> dict[str, Any] | None:
    """All edits as one, since each suggestion is accepted by itself; None when they are far apart or in other files."""
    edits = sorted(finding.fix.edits if finding.fix else (), key=_by_start)
    if not edits or any(edit.span.source is not finding.source for edit in edits):
        return None
    whole = inside(Span(finding.source, edits[0].span.start, max(edit.span.end for edit in edits)))
    if whole.end_position.line - whole.line > LONGEST:
        return None
    stretch, text = _on_lines(whole, _edited(whole, edits))
    return {"range": _range(stretch), "text": text}


def _on_lines(whole: Span, text: str) -> tuple[Span, str]:
    """The same edit without the line break that it ends with: reviewdog refuses a line after the last."""
    source, start, end = whole
    before, ending = source.text, "\r\n" if source.text.endswith("\r\n", 0, end) else "\n"
    if before.endswith(ending, start, end) and text.endswith(ending):
        return Span(source, start, end - len(ending)), text.removesuffix(ending)
    at_end = end == len(before) and before.endswith(ending) and before.endswith(ending, 0, start)
    if at_end and (not text or text.endswith(ending)):
        return Span(source, start - len(ending), end - len(ending)), f"{ending}{text}".removesuffix(ending)
    return whole, text


def _by_start(edit: Edit) -> tuple[int, int]:
    return edit.span.start, edit.span.end


def _edited(whole: Span, edits: list[Edit]) -> str:
    """The text of a stretch after the edits in it, ascending."""
    source, at, end = whole
    pieces = []
    for edit in edits:
        pieces += [source.text[at : edit.span.start], edit.text]
        at = max(at, edit.span.end)
    return "".join((*pieces, source.text[at:end]))
