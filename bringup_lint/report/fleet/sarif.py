"""SARIF 2.1.0 with a run for each robot. GitHub takes 20 runs in a file and 25,000 results in a run: the robots beyond
share the last run, and what is beyond in a run is left out, least severe first, and said so.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.model import RuleDoc
from bringup_lint.report.unicode import sound

MOST_RUNS = 20
MOST_RESULTS = 25_000
SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_LEVELS = {"error": "error", "warning": "warning", "info": "note"}


def render(report: FleetReport) -> str:
    robots = list(report.robots)
    groups = [[robot] for robot in robots]
    if len(robots) > MOST_RUNS:
        groups = [*groups[: MOST_RUNS - 1], robots[MOST_RUNS - 1 :]]
    runs = [_run(report, group) for group in groups]
    return json.dumps(sound({"$schema": SCHEMA, "version": "2.1.0", "runs": runs}), indent=2) + "\n"


def _run(report: FleetReport, robots: list[Summary]) -> dict[str, Any]:
    names = {robot.name for robot in robots}
    results = [_of_fleet(found, names) for found in report.shown if names & set(found.robots)]
    results += [_of_robot(own) for robot in robots for own in robot.own]
    results.sort(key=lambda result: tuple(_LEVELS.values()).index(result["level"]))
    left_out = len(results) - MOST_RESULTS
    failures = [*report.failures, *(failure for robot in robots for failure in robot.failures)]
    told = list(failures)
    told += [f"{left_out} results are left out: a run holds at most {MOST_RESULTS}"] * (left_out > 0)
    results = results[:MOST_RESULTS]
    rules = [_rule(report.rules[name]) for name in sorted({result["ruleId"] for result in results} & set(report.rules))]
    return {
        "tool": {"driver": {"name": "bringup-lint", "semanticVersion": report.version, "rules": rules}},
        "automationDetails": {"id": f"bringup-lint/fleet/{robots[0].name if len(robots) == 1 else 'others'}/"},
        "invocations": [
            {
                "executionSuccessful": not failures,
                "toolExecutionNotifications": [{"level": "error", "message": {"text": text}} for text in told],
            }
        ],
        "columnKind": "unicodeCodePoints",
        "results": results,
    }


def _rule(doc: RuleDoc) -> dict[str, Any]:
    rule = {"id": doc.id, "shortDescription": {"text": doc.title + "."}}
    return {**rule, "helpUri": doc.uri} if doc.uri else rule


def _of_fleet(found: FleetFinding, names: Iterable[str]) -> dict[str, Any]:
    """A finding of the fleet, at the first of its places that lies in these robots."""
    names = set(names)
    own = next((place for place in found.places if place.robot in names), found.places[0])
    others = [place for place in found.places if place is not own][:100]
    return {
        "ruleId": found.rule,
        "level": _LEVELS[str(found.severity)],
        "message": {"text": found.message + (f". {found.advice}" if found.advice else "")},
        "locations": [_location(own.path, own.line)],
        "relatedLocations": [
            {**_location(place.path, place.line), "message": {"text": f"on {place.robot}"}} for place in others
        ],
    }


def _of_robot(own: Own) -> dict[str, Any]:
    return {
        "ruleId": own.rule,
        "level": _LEVELS[own.severity],
        "message": {"text": own.message},
        "locations": [_location(own.path, own.line, own.column)],
        "partialFingerprints": {"bringupLint/v1": own.fingerprint},
    }


def _location(path: str, line: int, column: int = 1) -> dict[str, Any]:
    from urllib.parse import quote

    region = {"startLine": line, "startColumn": column}
    return {"physicalLocation": {"artifactLocation": {"uri": quote(path)}, "region": region}}
