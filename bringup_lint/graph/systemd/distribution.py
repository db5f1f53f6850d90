"""What Ubuntu's and Debian's own units say, for trees that do not hold them (tables ``systemd_units``,
``systemd_unit_edges``)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.implicit import default_edges

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units

RELEASES = (249, 252, 255)
"""The systemd versions of the distributions that the tables know."""


@lru_cache
def names() -> frozenset[str]:
    from bringup_lint.facts import table

    return frozenset(row["unit"] for row in table("systemd/units"))


@lru_cache
def aliases() -> dict[str, str]:
    """Other names of units, such as ``default.target``."""
    from bringup_lint.facts import table

    return {row["unit"]: row["alias_of"] for row in table("systemd/units") if row["alias_of"] not in ("", "masked")}


def distribution_edges(units: Units) -> Iterator[Edge]:
    """The edges of the release nearest to the target's, without those of units that the tree brings
    itself."""
    from bringup_lint.facts import table
    from bringup_lint.graph.systemd.dependencies import INSTALLED
    from bringup_lint.graph.systemd.dependencies import PULLS

    version = min(RELEASES, key=lambda known: abs(known - units.robot.target.systemd))
    own = {
        name
        for unit in units.all
        if unit.manager == "system" and (unit.fragment or unit.masked)
        for name in (unit.name, *unit.aliases)
    }
    defaults, optional = {}, set()
    for row in table("systemd/units"):
        if _ships(row, version) and not row["alias_of"]:
            defaults[row["unit"]] = row["default_dependencies"] == "yes"
            if row["package"] != "systemd":
                optional.add(row["unit"])
    for row in table("systemd/unit_edges"):
        name, relation = row["unit"], row["relation"]
        if name not in defaults or name in own or not _ships(row, version):
            continue
        here, there = Node("unit", name), Node("unit", aliases().get(row["target"], row["target"]))
        why = f"{relation}= of the distribution's {name}"
        if relation == "After":
            yield Edge("orders", there, here, None, why)
        elif relation == "Before":
            yield Edge("orders", here, there, None, why, of_package=name in optional)
        elif relation in PULLS:
            yield Edge(PULLS[relation], here, there, None, why)
        elif relation in INSTALLED:
            yield Edge(INSTALLED[relation], there, here, None, why, of_package=True)
    for name, enabled in defaults.items():
        if name not in own:
            yield from default_edges(Node("unit", name), enabled)


def _ships(row: dict[str, str], version: int) -> bool:
    return row["releases"] == "*" or str(version) in row["releases"].split(",")
