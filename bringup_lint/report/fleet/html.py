"""The page of a fleet: robots against rules as a matrix, the findings with their differences side by side, a search.
One file without anything from elsewhere; what it holds is there without scripts, which only search.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from html import escape
from importlib.resources import files

from bringup_lint.fleet.fleet import Difference
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.model import FleetReport

MOST_PLACES = 50
MOST_NAMES = 20
_SIGNS = {"error": "E", "warning": "W", "info": "I"}


def render(report: FleetReport) -> str:
    page = files(__package__).joinpath("page.html").read_text("utf-8")
    counts = report.counts
    parts = {
        "summary": f"{len(report.robots)} robots, {counts['error']} errors, {counts['warning']} warnings of the fleet",
        "matrix": "".join(_matrix(report)),
        "findings": "".join(_finding(number, found) for number, found in enumerate(report.shown)),
    }
    for name, text in parts.items():
        page = page.replace(f"<!-- {name} -->", text, 1)
    return page


def _matrix(report: FleetReport) -> Iterator[str]:
    cells: dict[str, dict[str, tuple[int, FleetFinding]]] = defaultdict(dict)
    for number, found in enumerate(report.shown):
        for name in found.robots:
            cells[name].setdefault(found.rule, (number, found))
    rules = sorted({found.rule for found in report.shown})
    heads = "".join(f"<th scope=col><span>{escape(rule.partition('/')[2])}</span></th>" for rule in rules)
    yield "<thead><tr><th scope=col>robot</th><th scope=col>role</th><th scope=col>own</th>" + heads + "</tr></thead>"
    for robot in report.robots:
        row = "".join(_cell(cells[robot.name].get(rule)) for rule in rules)
        yield f"<tr{_words(robot)}><th scope=row>{escape(robot.name)}</th><td>{_role(robot)}</td>"
        yield f"<td>{len(robot.own)}</td>{row}</tr>"


def _cell(entry: tuple[int, FleetFinding] | None) -> str:
    if entry is None:
        return "<td></td>"
    number, found = entry
    sign, title = _SIGNS[str(found.severity)], escape(found.rule, quote=True)
    return f'<td class={found.severity}><a href="#f{number}" title="{title}">{sign}</a></td>'


def _words(robot: Summary) -> str:
    words = f"{robot.name} {robot.role} {robot.site}".lower()
    return f' data-words="{escape(words, quote=True)}"'


def _role(robot: Summary) -> str:
    return escape(f"{robot.role} at {robot.site}" if robot.site else robot.role)


def _finding(number: int, found: FleetFinding) -> str:
    words = f"{found.rule} {found.message} {' '.join(found.robots)}".lower()
    places = "".join(
        f"<li>{escape(place.robot)}: <code>{escape(f'{place.path}:{place.line}')}</code></li>"
        for place in found.places[:MOST_PLACES]
    )
    more = len(found.places) - MOST_PLACES
    return (
        f'<details id=f{number} data-words="{escape(words, quote=True)}"><summary><b class={found.severity}>'
        f"{found.severity}</b> <code>{escape(found.rule)}</code> {escape(found.message)}</summary>"
        f"{_difference(found.difference) if found.difference else ''}<p>{escape(found.advice)}</p>"
        f"<ul>{places}{f'<li>and {more} more</li>' if more > 0 else ''}</ul></details>"
    )


def _difference(difference: Difference) -> str:
    return (
        f"<div class=sides><p>{escape(difference.key)}</p>"
        f"<div>{_side(difference.usual, difference.usual_robots)}</div>"
        f"<div>{_side(difference.odd, difference.odd_robots)}</div></div>"
    )


def _side(value: str, robots: tuple[str, ...]) -> str:
    names = ", ".join(robots[:MOST_NAMES]) + (
        f" and {len(robots) - MOST_NAMES} more" if len(robots) > MOST_NAMES else ""
    )
    return f"<pre>{escape(value)}</pre><small>{escape(names)}</small>"
