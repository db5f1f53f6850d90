"""The findings of the fleet: each with its places, and a difference with both sides beside each other."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.entries import found_by
from bringup_lint.report.fleet.html.links import Links
from bringup_lint.report.fleet.html.links import rule_link
from bringup_lint.report.fleet.html.severities import badge
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import lines
from bringup_lint.report.html.markup import text

MOST_PLACES = 50
MOST_NAMES = 20


def findings(report: FleetReport, links: Links) -> Iterator[str]:
    number = -1
    for number, found in enumerate(report.shown):
        yield _finding(number, found, report, links)
    if number < 0:
        yield "<p class=small>Nothing that only many robots together show.</p>"


def _finding(number: int, found: FleetFinding, report: FleetReport, links: Links) -> str:
    places = "".join(
        f"<li>{links.robot(place.robot)} <code class=place>{text(f'{place.path}:{place.line}')}</code></li>"
        for place in found.places[:MOST_PLACES]
    )
    more = len(found.places) - MOST_PLACES
    return (
        f"<details class=entry id=f{number} {found_by(found.rule, found.message, *found.robots)}>"
        f"<summary>{badge(str(found.severity))} {rule_link(found.rule, report.rules.get(found.rule))} "
        f"<span>{text(found.message)}</span></summary>"
        f"{_difference(found.difference, links) if found.difference else ''}{_advice(found)}"
        f"<ul>{places}{f'<li>and {more} more</li>' if more > 0 else ''}</ul></details>"
    )


def _advice(found: FleetFinding) -> str:
    return f"<p class=advice><b>Instead</b> {text(found.advice)}</p>" if found.advice else ""


def _difference(difference: Difference, links: Links) -> str:
    return (
        f"<div class=sides><p>{text(difference.key)}</p>"
        f"<div>{_side('usual', difference.usual, difference.usual_robots, links)}</div>"
        f"<div>{_side('odd', difference.odd, difference.odd_robots, links)}</div></div>"
    )


def _side(name: str, value: str, robots: tuple[str, ...], links: Links) -> str:
    shown = [links.robot(robot) for robot in robots[:MOST_NAMES]]
    more = len(robots) - len(shown)
    said = ", ".join(shown) + (f" and {more} more" if more else "")
    return f"<pre class={name}>{lines(value)}</pre><small>{counted(len(robots), 'robot')}: {said}</small>"
