"""Which entries of the page lead to each other: robots by the number of their entry, findings by theirs."""

from __future__ import annotations

from collections import defaultdict

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.fleet.model import FleetReport
from bringup_lint.report.html.markup import text
from bringup_lint.report.model import RuleDoc


@dataclass(frozen=True)
class Links:
    findings: dict[str, list[tuple[int, FleetFinding]]] = field(default_factory=dict)
    """Those of the fleet that name a robot, each with its number."""
    entries: dict[str, int] = field(default_factory=dict)
    """The number of the entry of each robot that the findings name."""

    def has_entry(self, robot: Summary) -> bool:
        return bool(robot.own or robot.silenced or robot.failures or robot.name in self.findings)

    def robot(self, name: str) -> str:
        """The name, with a link to the entry of the robot."""
        if name not in self.entries:
            return text(name)
        return f'<a href="#r{self.entries[name]}">{text(name)}</a>'


def links_of(report: FleetReport) -> Links:
    findings: dict[str, list[tuple[int, FleetFinding]]] = defaultdict(list)
    for number, found in enumerate(report.shown):
        for name in found.robots:
            findings[name].append((number, found))
    entries = {robot.name: number for number, robot in enumerate(report.robots) if robot.name in findings}
    return Links(dict(findings), entries)


def rule_link(name: str, doc: RuleDoc | None) -> str:
    """The name of a rule, with a link to its page where it has one."""
    if doc is None or not doc.uri.startswith("https://"):
        return f"<code>{text(name)}</code>"
    attributes = f'href="{text(doc.uri)}" rel=noreferrer target=_blank title="{text(doc.title)}"'
    return f"<a class=rule {attributes}>{text(name)}</a>"
