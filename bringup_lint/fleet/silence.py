"""What makes findings of the fleet silent: ``[[accept]]`` of an inventory, and ``[per-file-ignores]``."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.fleet import FleetPlace
from bringup_lint.fleet.members import Accepted
from bringup_lint.selection import is_name_of
from bringup_lint.suppress import UNUSED
from bringup_lint.suppress.files import FileIgnores


@dataclass(frozen=True, eq=False)
class Silence:
    accepted: tuple[Accepted, ...]
    """Each with the id of its rule or family."""
    files: FileIgnores
    used: set[int] = field(default_factory=set)
    """The numbers of what was accepted and found."""

    def apply(self, found: FleetFinding) -> FleetFinding:
        """The finding, with the reason for which it is not shown."""
        for number, each in enumerate(self.accepted):
            if _is_about(each, found):
                self.used.add(number)
                return replace(found, declared=each.reason)
        places = [place for place in found.places if place.robot in found.robots]
        if not self.files.entries or not all([self.files.entry_for(found.rule, place.path) for place in places]):
            return found
        return replace(found, declared=f"per-file-ignores of {self.files.entries[0].where.source.basename}")

    def complaints(self, robots: Collection[str], ran: Callable[[str], bool]) -> Iterator[FleetFinding]:
        """What is accepted and never found, though all that it names was judged."""
        for number, each in enumerate(self.accepted):
            strangers = [name for name in each.robots if name not in robots]
            for name in strangers:
                yield _complaint(each, f"No robot of the fleet is called '{name}'", robots)
            if number not in self.used and not strangers and ran(each.rule):
                yield _complaint(each, f"{each.rule} finds nothing that is accepted here", robots)


def _is_about(accepted: Accepted, found: FleetFinding) -> bool:
    key = found.difference.key if found.difference else ""
    return (
        is_name_of(accepted.rule, found.rule)
        and key.startswith(accepted.key)
        and set(found.robots) <= set(accepted.robots or found.robots)
    )


def _complaint(accepted: Accepted, message: str, robots: Collection[str]) -> FleetFinding:
    place = FleetPlace(min(robots), accepted.path, accepted.line)
    return FleetFinding(message, (place,), "delete the entry, or correct it", rule=UNUSED)
