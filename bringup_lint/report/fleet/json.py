"""The report of a fleet as data; ``json.schema.json`` beside this module describes it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.fleet.rows import rows
from bringup_lint.report.fleet.rows import written

VERSION = 1


def render(report: FleetReport) -> Iterator[str]:
    head = {
        "version": VERSION,
        "tool": {"name": "bringup-lint", "version": report.version},
    }
    tail = {
        "failures": list(report.failures),
        "summary": {
            **{name: report.counts[name] for name in ("error", "warning", "info")},
            "accepted": sum(bool(found.declared) for found in report.findings),
            "below": report.hidden,
            "suppressed_by": dict(sorted(report.silenced.items())),
            "robots": len(report.robots),
            "exit_code": report.exit_code,
        },
    }
    yield written(head).removesuffix("\n}") + ",\n"
    yield from rows('  "findings": ', map(_finding, report.findings), "  ")
    yield ",\n"
    yield from rows('  "robots": ', map(_robot, report.robots), "  ")
    yield ",\n" + written(tail).removeprefix("{\n") + "\n"


def _finding(found: FleetFinding) -> dict[str, Any]:
    return {
        "rule": found.rule,
        "severity": str(found.severity),
        "confidence": str(found.confidence),
        "message": found.message,
        "advice": found.advice,
        "robots": list(found.robots),
        "places": [place._asdict() for place in found.places],
        "difference": found.difference and _difference(found.difference),
        "accepted": found.declared,
    }


def _difference(difference: Difference) -> dict[str, Any]:
    return {
        "key": difference.key,
        "usual": {"value": difference.usual, "robots": list(difference.usual_robots)},
        "odd": {"value": difference.odd, "robots": list(difference.odd_robots)},
    }


def _robot(robot: Summary) -> dict[str, Any]:
    counts = Counter(own.severity for own in robot.own)
    return {
        "name": robot.name,
        "role": robot.role,
        "site": robot.site,
        "path": robot.path,
        "files": robot.files,
        **{name: counts[name] for name in ("error", "warning", "info")},
        "suppressed_by": dict(robot.silenced),
        "findings": [own._asdict() for own in robot.own],
        "failures": list(robot.failures),
    }
