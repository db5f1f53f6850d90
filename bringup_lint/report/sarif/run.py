"""The run: tool, invocation, taxonomy, results."""

from __future__ import annotations

import shlex
from typing import Any

from bringup_lint.dataclass import replace
from bringup_lint.finding import Finding
from bringup_lint.finding.uri import file_uri
from bringup_lint.report.model import Notification
from bringup_lint.report.model import Report
from bringup_lint.report.sarif.automation import automation_details
from bringup_lint.report.sarif.places import Places
from bringup_lint.report.sarif.places import location
from bringup_lint.report.sarif.results import result
from bringup_lint.report.sarif.rules import cwe_taxonomy
from bringup_lint.report.sarif.rules import descriptor
from bringup_lint.report.sarif.rules import documented
from bringup_lint.report.times import utc

MOST = 5000
"""Results; GitHub shows no more of one run."""
HOME = "https://github.com/bringup-lint/bringup-lint"


def run(report: Report) -> dict[str, Any]:
    report = _limited(report)
    rules = documented(report)
    taxonomy = cwe_taxonomy(rules)
    indexes = {rule.id: number for number, rule in enumerate(rules)}
    places = Places(report)
    silenced = any(finding.suppression for finding in report.findings)
    results = [result(finding, indexes[finding.rule], places, silenced) for finding in report.findings]
    driver = {
        "name": "bringup-lint",
        "fullName": f"bringup-lint {report.version}",
        "version": report.version,
        "semanticVersion": report.version,
        "organization": "bringup-lint",
        "informationUri": HOME,
        "shortDescription": {"text": "Static configuration linter for ROS 2 robot bring-up."},
        "language": "en-US",
        "isComprehensive": False,
        "rules": [descriptor(rule, taxonomy) for rule in rules],
    }
    if taxonomy:
        driver["supportedTaxonomies"] = [{"name": taxonomy["name"], "index": 0}]
    return {
        "tool": {"driver": driver},
        "language": "en-US",
        "columnKind": "unicodeCodePoints",
        "defaultEncoding": "utf-8",
        "automationDetails": automation_details(),
        "originalUriBaseIds": {"%SRCROOT%": _root(report)},
        "invocations": [_invocation(report, indexes)],
        **({"taxonomies": [taxonomy]} if taxonomy else {}),
        "artifacts": places.artifacts,
        "results": results,
        "properties": {
            "target": report.target._asdict(),
            "files": report.files,
            "kinds": dict(sorted(report.kinds.items())),
            **({"narrowed": list(report.narrowed)} if report.narrowed else {}),
        },
    }


def _limited(report: Report) -> Report:
    """The report with the worst findings that a run may hold, in their order, and with a word on the others."""
    if len(report.findings) <= MOST:
        return report
    ranks = sorted(range(len(report.findings)), key=lambda at: _rank(report.findings[at]))
    kept = tuple(report.findings[at] for at in sorted(ranks[:MOST]))
    left = len(report.findings) - MOST
    said = f"{left} results are left out, since code scanning services show no more than {MOST}; errors come first"
    return replace(report, findings=kept, notifications=(*report.notifications, Notification("warning", said)))


def _rank(finding: Finding) -> tuple[bool, int]:
    return finding.suppression is not None, -finding.severity


def _root(report: Report) -> dict[str, Any]:
    root = {"description": {"text": "The folder that was checked."}}
    return {"uri": file_uri(report.root.rstrip("/") + "/"), **root} if report.root else root


def _invocation(report: Report, indexes: dict[str, int]) -> dict[str, Any]:
    told = [_notification(notification, report, indexes) for notification in report.notifications]
    invocation: dict[str, Any] = {
        "executionSuccessful": report.exit_code in (0, 1),
        "exitCode": report.exit_code,
        "toolExecutionNotifications": told,
    }
    if report.command:
        invocation["commandLine"] = shlex.join(report.command)
        invocation["arguments"] = list(report.command[1:])
    if report.started is not None and report.ended is not None:
        invocation["startTimeUtc"] = utc(report.started)
        invocation["endTimeUtc"] = utc(report.ended)
    if report.cwd:
        invocation["workingDirectory"] = {"uri": file_uri(report.cwd.rstrip("/") + "/")}
    return invocation


def _notification(told: Notification, report: Report, indexes: dict[str, int]) -> dict[str, Any]:
    notification: dict[str, Any] = {"level": told.level, "message": {"text": told.message.rstrip(".") + "."}}
    if told.rule in indexes:
        notification["associatedRule"] = {"id": told.rule, "index": indexes[told.rule]}
    if told.path:
        where = {"physicalLocation": {"artifactLocation": location(told.path, report)}}
        notification["locations"] = [where]
    return notification
