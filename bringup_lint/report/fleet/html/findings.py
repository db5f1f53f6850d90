"""The findings of the fleet: each with its places, and a difference with both sides beside each other."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import listed
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import lines
from bringup_lint.report.html.markup import text

MOST_PLACES = 50
MOST_NAMES = 20


def findings(report: FleetReport) -> Iterator[str]:
    number = -1
    for number, found in enumerate(report.shown):
        yield _finding(number, found)
    if number < 0:
        yield "<p>Nothing that only many robots together show.</p>"


def _finding(number: int, found: FleetFinding) -> str:
    places = "".join(
        f"<li>{text(place.robot)}: <code>{text(f'{place.path}:{place.line}')}</code></li>"
        for place in found.places[:MOST_PLACES]
    )
    more = len(found.places) - MOST_PLACES
    return (
        f"<details id=f{number} {found_by(found.rule, found.message, *found.robots)}>"
        f"<summary><b class={found.severity}>"
        f"{found.severity}</b> <code>{text(found.rule)}</code> {text(found.message)}</summary>"
        f"{_difference(found.difference) if found.difference else ''}<p>{text(found.advice)}</p>"
        f"<ul>{places}{f'<li>and {more} more</li>' if more > 0 else ''}</ul></details>"
    )


def _difference(difference: Difference) -> str:
    return (
        f"<div class=sides><p>{text(difference.key)}</p>"
        f"<div>{_side(difference.usual, difference.usual_robots)}</div>"
        f"<div>{_side(difference.odd, difference.odd_robots)}</div></div>"
    )


def _side(value: str, robots: tuple[str, ...]) -> str:
    return f"<pre>{lines(value)}</pre><small>{text(listed(robots, MOST_NAMES))}</small>"
