"""Who waits for the network at boot."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units

WAITER = "systemd-networkd-wait-online.service"


def waiting_for_network(units: Units) -> list[tuple[str, Located]]:
    """The units that are ordered after network-online.target, each with the word that says so.

    None when a drop-in configures the waiting itself: what is waited for is then known to it alone.
    """
    if any(unit.dropins for unit in units.candidates(WAITER)):
        return []
    return [
        (unit.name, word) for unit in units.judged for word in unit.words("After") if word == "network-online.target"
    ]
