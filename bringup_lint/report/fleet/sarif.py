"""SARIF 2.1.0 with a run for each robot. GitHub takes 20 runs in a file and 25,000 results in a run: the robots beyond
share the last run, and what is beyond in a run is left out, least severe first, and said so.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.fleet.rows import indented
from bringup_lint.report.fleet.rows import rows
from bringup_lint.report.fleet.rows import written
from bringup_lint.report.model import RuleDoc
from bringup_lint.report.sarif import SCHEMA

MOST_RUNS = 20
MOST_RESULTS = 25_000
_LEVELS = {"error": "error", "warning": "warning", "info": "note"}


@dataclass(frozen=True)
class Part:
    """The robots of one run of the file."""

    report: FleetReport
    first: int
    last: int | None
    """None: all that are left."""

    @property
    def robots(self) -> Iterator[Summary]:
        return islice(self.report.robots, self.first, self.last)

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(robot.name for robot in self.robots)

    @property
    def everything(self) -> Iterator[FleetFinding | Own]:
        """The findings, the most severe first."""
        for level in _LEVELS.values():
            for found in self.report.shown:
                if _LEVELS[str(found.severity)] == level and not self.names.isdisjoint(found.robots):
                    yield found
            for robot in self.robots:
                yield from (own for own in robot.own if _LEVELS[own.severity] == level)

    @property
    def kept(self) -> Iterator[FleetFinding | Own]:
        return islice(self.everything, MOST_RESULTS)


def render(report: FleetReport) -> Iterator[str]:
    head = json.dumps({"$schema": SCHEMA, "version": "2.1.0"}, indent=2)
    yield head.removesuffix("\n}") + ',\n  "runs": ['
    for number, part in enumerate(_parts(report)):
        yield ",\n" if number else "\n"
        yield from _run(part)
    yield "\n  ]\n}\n"


def _parts(report: FleetReport) -> Iterator[Part]:
    count = len(report.robots)
    if count <= MOST_RUNS:
        yield from (Part(report, number, number + 1) for number in range(count))
        return
    yield from (Part(report, number, number + 1) for number in range(MOST_RUNS - 1))
    yield Part(report, MOST_RUNS - 1, None)


def _run(part: Part) -> Iterator[str]:
    report, names = part.report, part.names
    used, left_out = _counted(part)
    failures = [*report.failures, *(failure for robot in part.robots for failure in robot.failures)]
    told = list(failures)
    told += [f"{left_out} results are left out: a run holds at most {MOST_RESULTS}"] * (left_out > 0)
    rules = [_rule(report.rules[name]) for name in sorted(used & set(report.rules))]
    head = {
        "tool": {"driver": {"name": "bringup-lint", "semanticVersion": report.version, "rules": rules}},
        "automationDetails": {"id": f"bringup-lint/fleet/{min(names) if len(names) == 1 else 'others'}/"},
        "invocations": [
            {
                "executionSuccessful": not failures,
                "toolExecutionNotifications": [{"level": "error", "message": {"text": text}} for text in told],
            }
        ],
        "columnKind": "unicodeCodePoints",
    }
    yield indented(written(head).removesuffix("\n}"), "    ") + ",\n"
    yield from rows('      "results": ', (_result(each, names) for each in part.kept), "      ")
    yield "\n    }"


def _counted(part: Part) -> tuple[set[str], int]:
    """The rules of the findings that are kept, and how many are left out; the others are counted only."""
    used: set[str] = set()
    count = 0
    for count, found in enumerate(part.everything, 1):
        if count <= MOST_RESULTS:
            used.add(found.rule)
    return used, max(0, count - MOST_RESULTS)


def _result(found: FleetFinding | Own, names: frozenset[str]) -> dict[str, Any]:
    return _of_robot(found) if isinstance(found, Own) else _of_fleet(found, names)


def _rule(doc: RuleDoc) -> dict[str, Any]:
    rule = {"id": doc.id, "shortDescription": {"text": doc.title + "."}}
    return {**rule, "helpUri": doc.uri} if doc.uri else rule


def _of_fleet(found: FleetFinding, names: frozenset[str]) -> dict[str, Any]:
    """A finding of the fleet, at the first of its places that lies in these robots."""
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
