"""The page of a fleet: its roles, robots against rules as a matrix, the findings with their differences side by side,
what was found on each robot by itself, and a search. One file without anything from elsewhere; what it holds is there
without scripts, which only search.
"""

from __future__ import annotations

from collections import Counter
from importlib.resources import files

from bringup_lint.plural import counted
from bringup_lint.report.fleet.html.findings import findings
from bringup_lint.report.fleet.html.matrix import matrix
from bringup_lint.report.fleet.html.robots import robots
from bringup_lint.report.fleet.html.roles import roles
from bringup_lint.report.fleet.model import FleetReport


def render(report: FleetReport) -> str:
    page = files(__package__).joinpath("page.html").read_text("utf-8")
    parts = {
        "summary": _summary(report),
        "roles": "".join(roles(report)),
        "matrix": "".join(matrix(report)),
        "findings": "".join(findings(report)) or "<p>Nothing that only many robots together show.</p>",
        "robots": "".join(robots(report)),
    }
    for name, text in parts.items():
        page = page.replace(f"<!-- {name} -->", text, 1)
    return page


def _summary(report: FleetReport) -> str:
    counts = report.counts + Counter(robot=len(report.robots))
    said = (counted(counts[name], name) for name in ("robot", "error", "warning"))
    return f"{', '.join(said)} of the fleet"
