"""The units of a tree by their names: which one a name means, whether it exists, who starts it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd import distribution
from bringup_lint.graph.systemd.provision import makes
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.variants import overlay_of
from bringup_lint.parsers.systemd_values import is_unit_name
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_DIGITS = re.compile(r"\d+")
GENERATED = re.compile(
    r"\.(?:device|mount|automount|swap|slice|scope)$|^(?:getty|serial-getty|user|user-runtime-dir|modprobe|systemd-fsck"
    r"|systemd-backlight|systemd-growfs|systemd-cryptsetup|systemd-pcrphase|wpa_supplicant|dhcpcd|ifup|netplan-\w+"
    r"|container-getty|autovt|systemd-[\w-]+)@|^(?:dbus-.*|netplan-.*|snap[.-].*|cloud-.*|nvargus-.*|nvidia-.*)\.\w+$"
)
"""Names that the kernel, a generator or an installed package provides, so that nothing in a tree can prove
them missing."""


class Link(NamedTuple):
    """An entry of ``UNIT.wants/`` and the like: UNIT pulls in ``name``."""

    unit: str
    relation: str
    name: Located
    source: Source
    manager: str = "system"
    place: str = ""


@dataclass(eq=False)
class NamedUnits:
    """All units of a robot, and what is known about the distribution's."""

    robot: Robot
    all: list[Unit] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    alias_links: dict[tuple[str, str], str] = field(default_factory=dict)
    """(manager, alias) -> the unit of the distribution that a link of the tree gives the name to."""

    @cached_property
    def _by_name(self) -> dict[tuple[str, str], list[Unit]]:
        by_name: dict[tuple[str, str], list[Unit]] = {}
        for unit in self.all:
            for name in dict.fromkeys((unit.name, *unit.aliases, *_install_aliases(unit))):
                by_name.setdefault((unit.manager, name), []).append(unit)
        return by_name

    def candidates(self, name: str, manager: str = "system") -> list[Unit]:
        """The units of this name; for an instance without a file of its own, those of its template."""
        found = self._by_name.get((manager, name))
        if found is None and "@" in name:
            stem, _, suffix = name.rpartition(".")
            found = self._by_name.get((manager, f"{stem.partition('@')[0]}@.{suffix}"))
        return found or []

    def find(self, name: str, near: Unit) -> Unit | None:
        """The unit that a name in ``near`` means; None when it is not in the tree or several variants could
        be meant. A unit of another overlay is another robot's."""
        found = [unit for unit in self.candidates(name, near.manager) if not _apart(unit, near)]
        if len(found) > 1:
            found = [unit for unit in found if unit.place == near.place]
        return found[0] if len(found) == 1 else None

    def node(self, unit: Unit, instance: str = "") -> Node:
        """The unit, or one instance of a template, in the graph."""
        name = f"{unit.stem}{instance}.{unit.type}" if unit.is_template else unit.name
        alone = len(self.candidates(unit.name, unit.manager)) == 1
        return Node("unit" if unit.manager == "system" else "user-unit", name, "" if alone else unit.place)

    def real_name(self, name: str, manager: str = "system") -> str:
        """What a name of the distribution stands for: ``default.target`` is ``graphical.target`` unless the
        tree links it."""
        if (manager, name) in self.alias_links:
            return self.alias_links[manager, name]
        return distribution.aliases().get(name, name) if manager == "system" else name

    def exists(self, name: str, near: Unit) -> bool | None:
        """Whether systemd would find a unit of this name; None when that cannot be told."""
        if self.candidates(name, near.manager) or (near.manager, name) in self.alias_links:
            return True
        if "%" in name or GENERATED.search(name) or near.manager == "user":
            return None
        return not self.has_vendor_units and self.is_distribution_unit(name)

    def is_missing(self, name: str, near: Unit) -> bool:
        """Whether a unit that ``near`` names is provably, or in a repository most likely, not there: nothing
        provides it, no script makes it, and it looks like one of the robot's own."""
        if self.exists(name, near) is not False or self.is_distribution_unit(name):
            return False
        return self.robot.tree.complete or (self.is_own(name, near) and not self.is_made(name))

    def is_own(self, name: str, near: Unit) -> bool:
        """Whether a name looks like the robot's own units: the same first word, or nearly the name of one."""
        family = _family(name)
        own = {unit.name for unit in self.all if unit.manager == near.manager and unit.fragment}
        related = len(family) > 2 and "-" in name and family != "systemd"
        return (related and any(_family(other) == family for other in own)) or bool(self.meant(name, near))

    def meant(self, name: str, near: Unit) -> str | None:
        """The one unit of the tree whose name a misspelt one nearly is. Units that differ in a number are
        no misspellings."""
        stem, _, kind = name.rpartition(".")
        if len(stem) < 6:
            return None
        own = {
            unit.stem for unit in self.all if unit.type == kind and unit.manager == near.manager and unit is not near
        }
        found = [other for other in nearest(stem, sorted(own)) if _DIGITS.sub("", other) != _DIGITS.sub("", stem)]
        return f"{found[0]}.{kind}" if len(found) == 1 else None

    @staticmethod
    def is_name(text: str) -> bool:
        """Whether systemd takes the text as the name of a unit."""
        return is_unit_name(text)

    def is_made(self, name: str) -> bool:
        """Whether a script of the tree makes a file of that name."""
        return makes(self.robot.tree, name)

    def is_distribution_unit(self, name: str) -> bool:
        """Whether Ubuntu or Debian ships the unit (table ``systemd_units``), templates' instances
        included."""
        if name in distribution.names():
            return True
        stem, _, suffix = name.rpartition(".")
        return "@" in stem and f"{stem.partition('@')[0]}@.{suffix}" in distribution.names()

    @cached_property
    def has_vendor_units(self) -> bool:
        """Whether the tree holds the distribution's own units, so that no table has to stand in for them."""
        return self.robot.tree.complete and any(
            unit.name == "multi-user.target" and unit.fragment and unit.fragment.source.robot_path for unit in self.all
        )

    @cached_property
    def knows_enabled(self) -> bool:
        """Whether the links of a root file system tell which units are enabled, rather than their [Install]
        sections."""
        return self.robot.tree.complete and any(
            (link.source.robot_path or "").startswith("/etc/systemd/system/") for link in self.links
        )

    def installs(self, unit: Unit) -> bool:
        """Whether the unit's [Install] section counts: a root file system with links knows better."""
        return not self.knows_enabled or unit.manager == "user"

    def is_provided(self, name: str) -> bool | None:
        """Whether the distribution has the unit; None for names that generators, the kernel or packages
        bring."""
        return None if "%" in name or GENERATED.search(name) else self.is_distribution_unit(name)

    def wanted_by(self, unit: Unit) -> Iterator[tuple[str, str, Located]]:
        """Who pulls the unit in by installation: (unit name, ``Wants``/``Requires``/``Upholds``, the word
        that says so)."""
        for key, relation in (("WantedBy", "Wants"), ("RequiredBy", "Requires"), ("UpheldBy", "Upholds")):
            for word in unit.words(key, "Install") if self.installs(unit) else ():
                yield str(word), relation, word
        for link in self.links:
            if link.manager != unit.manager:
                continue
            if (
                link.name == unit.name
                or link.name in unit.aliases
                or self.candidates(link.name, unit.manager) == [unit]
            ):
                yield link.unit, link.relation, link.name


def _apart(one: Unit, other: Unit) -> bool:
    """Whether two units lie in different overlays."""
    overlays = [overlay_of(unit.files[0].source) for unit in (one, other) if unit.files]
    return len(overlays) == 2 and None not in overlays and overlays[0] != overlays[1]


def _family(name: str) -> str:
    """The first word of a unit's name: ``rover`` of ``rover-nav@a.service``."""
    return re.split(r"[-@.]", name, maxsplit=1)[0]


def _install_aliases(unit: Unit) -> Iterator[str]:
    """The names that enabling the unit gives it. Its drop-ins are not joined yet, and seldom hold any."""
    for assignment in unit.fragment.assignments if unit.fragment else ():
        if assignment.key == "Alias" and assignment.section == "Install":
            yield from map(str, assignment.value.words())
