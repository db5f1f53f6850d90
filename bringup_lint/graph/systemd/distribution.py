"""What Ubuntu's and Debian's own units say, for trees that do not hold them (tables ``systemd_units``,
``systemd_unit_edges``)."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from functools import cache
from functools import lru_cache

from bringup_lint.facts import rows
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.graph import Origin
from bringup_lint.graph.systemd import shipped_units
from bringup_lint.graph.systemd.implicit import default_edges
from bringup_lint.graph.systemd.relations import INSTALLED
from bringup_lint.graph.systemd.relations import PULLS
from bringup_lint.graph.systemd.unit import Unit

RELEASES = (249, 252, 255)
"""The systemd versions of the distributions that the tables know."""


def distribution_edges(units: Iterable[Unit], systemd: int) -> Iterator[Edge]:
    """The edges of the release nearest to the target's, without those of units that the tree brings
    itself."""
    known = list(units)
    release = min(RELEASES, key=lambda release: abs(release - systemd))
    yield from _edges(release, frozenset(_own(known)), frozenset(_installed_anew(known)))


@lru_cache(4)
def _edges(version: int, own: frozenset[str], anew: frozenset[str]) -> tuple[Edge, ...]:
    """The edges of a release without those of ``own`` units, and without the installation of those that the tree
    installs ``anew``, kept for the next run of the same process."""
    return tuple(_of_release(version, own, anew))


def _of_release(version: int, own: frozenset[str], anew: frozenset[str]) -> Iterator[Edge]:
    shipped = {
        name: (package, defaults == "yes")
        for name, package, releases, alias_of, _, defaults in rows("systemd/units")[1]
        if not alias_of and _ships(releases, version)
    }
    for name, relation, target, releases in rows("systemd/unit_edges")[1]:
        if name in anew and relation in INSTALLED:
            continue
        if name in shipped and name not in own and _ships(releases, version):
            yield from _stated(name, relation, target, optional=shipped[name][0] != "systemd")
    for name, (_, has_defaults) in shipped.items():
        if name not in own:
            yield from default_edges(_node(name), has_defaults)


def _own(units: Iterable[Unit]) -> set[str]:
    """The names of the system units that the tree brings itself."""
    return {
        name
        for unit in units
        if unit.manager == "system" and (unit.fragment or unit.masked)
        for name in (unit.name, *unit.aliases)
    }


def _installed_anew(units: Iterable[Unit]) -> Iterator[str]:
    """The units of which a drop-in resets what pulls them in."""
    for unit in units:
        lines = (line for key in INSTALLED for line in unit.assignments(key, "Install"))
        if unit.fragment is None and any(not line.value for line in lines):
            yield unit.name


def _stated(name: str, relation: str, target: str, *, optional: bool) -> Iterator[Edge]:
    """What a row of the table says. ``optional``: the unit is there only when its package is installed."""
    here, there = _node(name), _node(shipped_units.aliases().get(target, target))
    why, origin = f"{relation}= of the distribution's {name}", Origin.DISTRIBUTION
    if relation == "After":
        yield Edge("orders", there, here, None, why, False, origin)
    elif relation == "Before":
        yield Edge("orders", here, there, None, why, optional, origin)
    elif relation in PULLS:
        yield Edge(PULLS[relation], here, there, None, why, False, origin)
    elif relation in INSTALLED:
        yield Edge(INSTALLED[relation], there, here, None, why, True, origin)


@cache
def _node(name: str) -> Node:
    return Node("unit", name)


def _ships(releases: str, version: int) -> bool:
    return releases == "*" or str(version) in releases.split(",")
