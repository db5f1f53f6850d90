"""The page of a fleet: its roles, robots against rules as a matrix, the findings with their differences side by side,
what was found on each robot by itself, and a search. One file without anything from elsewhere; what it holds is there
without scripts, which only search and change the colours.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from importlib.resources import files

from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.findings import findings
from bringup_lint.report.fleet.html.links import Links
from bringup_lint.report.fleet.html.links import links_of
from bringup_lint.report.fleet.html.matrix import matrix
from bringup_lint.report.fleet.html.robots import robots
from bringup_lint.report.fleet.html.roles import roles
from bringup_lint.report.fleet.html.severities import badges
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html import part as shared_part
from bringup_lint.report.html.markup import hashed
from bringup_lint.report.html.markup import text


def render(report: FleetReport) -> Iterator[str]:
    page = _frame(report)
    links = links_of(report)
    parts: dict[str, Callable[[FleetReport, Links], Iterator[str]]] = {
        "summary": _summary,
        "matrix": matrix,
        "roles": roles,
        "findings": findings,
        "robots": robots,
    }
    for name, part in parts.items():
        before, page = page.split(f"<!-- {name} -->", 1)
        yield before
        yield from part(report, links)
    yield page


def _frame(report: FleetReport) -> str:
    """The page without its parts. Its content security policy names the hashes of its one style and its one script."""
    style, script = shared_part("shared.css") + _own("style.css"), _own("script.js")
    filled = {
        "policy": f"default-src 'none'; img-src data:; style-src {hashed(style)}; script-src {hashed(script)}; "
        "base-uri 'none'; form-action 'none'",
        "icons": shared_part("icons.svg"),
        "style": style,
        "script": script,
        "version": text(report.version),
    }
    page = _own("page.html")
    for name, value in filled.items():
        page = page.replace(f"${name}", value)
    return page


def _own(name: str) -> str:
    return files(__package__).joinpath(name).read_text("utf-8")


def _summary(report: FleetReport, links: Links) -> Iterator[str]:
    together = badges((str(found.severity) for found in report.shown), named=True)
    alone = badges((finding.severity for robot in report.robots for finding in robot.own), named=True)
    yield f"<b>{counted(len(report.robots), 'robot')}</b>"
    yield f"<span>{together or 'nothing'} of the fleet</span>"
    yield f"<span>{alone or 'nothing'} on single robots</span>"
