"""What every output format for a fleet is made from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from collections.abc import Mapping
from typing import Protocol

from bringup_lint import __version__
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.summary import Summary
from bringup_lint.report.model import RuleDoc


class Robots(Protocol):
    """The robots in the order of their names, to be gone through again and again."""

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[Summary]: ...


@dataclass(frozen=True)
class FleetReport:
    robots: Robots = ()
    """Each with what was found on it by itself."""
    findings: tuple[FleetFinding, ...] = ()
    """In the order of output; those that the inventory accepts are among them."""
    rules: Mapping[str, RuleDoc] = field(default_factory=dict)
    """The rules of the fleet that ran, and those with findings on single robots."""
    failures: tuple[str, ...] = ()
    hidden: int = 0
    """Findings of the fleet below the lowest severity shown."""
    exit_code: int = 0
    root: str = ""
    """Absolute folder that paths are relative to."""
    version: str = __version__
    colour: bool = False
    width: int = 80

    @property
    def shown(self) -> Iterator[FleetFinding]:
        """The findings that the inventory does not accept."""
        return (found for found in self.findings if not found.declared)

    @property
    def counts(self) -> Counter[str]:
        """Findings of the fleet by severity."""
        return Counter(str(found.severity) for found in self.shown)

    @property
    def silenced(self) -> Counter[str]:
        """What suppresses findings on single robots, and how many."""
        counts: Counter[str] = Counter()
        for robot in self.robots:
            counts.update(dict(robot.silenced))
        return counts
