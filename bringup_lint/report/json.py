"""The report as data; ``json.schema.json`` beside this module and ``docs/json.md`` describe it."""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.finding.place import inside
from bringup_lint.finding.place import place_of
from bringup_lint.report.model import Report
from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound
from bringup_lint.source import Span

VERSION = 1


def render(report: Report) -> str:
    data = {
        "version": VERSION,
        "tool": {"name": "bringup-lint", "version": report.version},
        "target": {
            "ros": {"version": report.target.ros, "why": report.target.ros_why},
            "systemd": {"version": report.target.systemd, "why": report.target.systemd_why},
        },
        "findings": [_finding(finding) for finding in report.findings],
        "notifications": [told._asdict() for told in report.notifications],
        "summary": _summary(report),
    }
    return harmless(json.dumps(sound(data), indent=2)) + "\n"


def _summary(report: Report) -> dict[str, Any]:
    counts = Counter(finding.severity for finding in report.shown)
    return {
        **{str(severity): counts[severity] for severity in reversed(Severity)},
        "suppressed": sum(finding.suppression is not None for finding in report.findings),
        "suppressed_by": dict(report.silenced),
        "narrowed": list(report.narrowed),
        "known": len(report.known),
        "below": {str(severity): report.below.get(severity, 0) for severity in reversed(Severity)},
        "files": report.files,
        "kinds": dict(sorted(report.kinds.items())),
        "exit_code": report.exit_code,
    }


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "rule": finding.rule,
        "severity": str(finding.severity),
        "confidence": str(finding.confidence),
        "message": finding.message,
        "advice": finding.advice,
        "location": _location(finding.span),
        "related": [_related(related) for related in finding.related],
        "chain": [_related(step) for step in finding.chain],
        "fix": finding.fix and _fix(finding.fix),
        "suppressed": finding.suppression and _suppressed(finding.suppression),
        "fingerprint": finding.fingerprint,
    }


def _location(span: Span) -> dict[str, Any]:
    start, end = inside(span)[1:]
    place = place_of(span)
    return {
        "path": span.path,
        "start": {"line": place.line, "column": place.column, "offset": start},
        "end": {"line": place.end_line, "column": place.end_column, "offset": end},
    }


def _related(related: Related) -> dict[str, Any]:
    return {"message": related.message, "location": _location(related.span)}


def _fix(fix: Fix) -> dict[str, Any]:
    edits = [{"location": _location(edit.span), "text": edit.text} for edit in fix.edits]
    return {"title": fix.title, "applicability": str(fix.applicability), "edits": edits}


def _suppressed(suppression: Suppression) -> dict[str, Any]:
    return {"reason": suppression.reason, "location": _location(suppression.span)}
