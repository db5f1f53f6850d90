"""GitLab's code quality report: the part of Code Climate's format that merge requests show."""

from __future__ import annotations

import json
from typing import Any

from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.place import place_of
from bringup_lint.report.model import Report
from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound

SEVERITIES = {Severity.ERROR: "critical", Severity.WARNING: "major", Severity.INFO: "info"}


def render(report: Report) -> str:
    return harmless(json.dumps(sound([_issue(finding) for finding in report.shown]), indent=2)) + "\n"


def _issue(finding: Finding) -> dict[str, Any]:
    place = place_of(finding.span)
    return {
        "type": "issue",
        "check_name": finding.rule,
        "description": " ".join(finding.message.split()),
        "severity": SEVERITIES[finding.severity],
        "fingerprint": finding.fingerprint,
        "location": {"path": finding.source.name, "lines": {"begin": place.line, "end": place.end_line}},
    }
