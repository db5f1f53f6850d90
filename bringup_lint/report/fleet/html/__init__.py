"""The page of a fleet: its roles, robots against rules as a matrix, the findings with their differences side by side,
what was found on each robot by itself, and a search. One file without anything from elsewhere; what it holds is there
without scripts, which only search.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from importlib.resources import files

from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.findings import findings
from bringup_lint.report.fleet.html.matrix import matrix
from bringup_lint.report.fleet.html.robots import robots
from bringup_lint.report.fleet.html.roles import roles
from bringup_lint.report.fleet.model import FleetReport


def render(report: FleetReport) -> Iterator[str]:
    page = files(__package__).joinpath("page.html").read_text("utf-8")
    parts: dict[str, Callable[[FleetReport], Iterator[str]]] = {
        "summary": _summary,
        "roles": roles,
        "matrix": matrix,
        "findings": findings,
        "robots": robots,
    }
    for name, part in parts.items():
        before, page = page.split(f"<!-- {name} -->", 1)
        yield before
        yield from part(report)
    yield page


def _summary(report: FleetReport) -> Iterator[str]:
    counts = report.counts + Counter(robot=len(report.robots))
    said = (counted(counts[name], name) for name in ("robot", "error", "warning"))
    yield f"{', '.join(said)} of the fleet"
