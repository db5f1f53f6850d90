"""The units of a tree by their names: which one a name means, whether it exists, who starts it."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.files import Files
from bringup_lint.graph.graph import Node
from bringup_lint.graph.image_builds import is_in_layer
from bringup_lint.graph.image_builds import layers
from bringup_lint.graph.memo import memo
from bringup_lint.graph.systemd import shipped_units
from bringup_lint.graph.systemd.provision import makes
from bringup_lint.graph.systemd.provision import starts
from bringup_lint.graph.systemd.relations import PULLS
from bringup_lint.graph.systemd.shipped_units import GENERATED
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.unit_loading import Link
from bringup_lint.graph.systemd.unit_loading import LoadedUnits
from bringup_lint.graph.systemd.unit_loading import load_units
from bringup_lint.graph.variants import overlay_of
from bringup_lint.parsers.systemd_values import is_unit_name
from bringup_lint.parsers.systemd_values import split_name
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.daemons import Daemon

_USUAL_TARGETS = frozenset(
    {
        "multi-user.target",
        "graphical.target",
        "sysinit.target",
        "basic.target",
        "timers.target",
        "sockets.target",
        "default.target",
    }
)
_DIGITS = regex(r"\d+")
_SURE_STEM = 6
"""Characters of a name that is no end of another one by chance."""


@dataclass(eq=False)
class NamedUnits:
    """All units of a robot, and what is known about the distribution's."""

    files: Files
    system_conf: Callable[[], list[Daemon]]
    """Gives the configuration of the service manager."""

    @cached_property
    def loaded(self) -> LoadedUnits:
        return load_units(self.files)

    @property
    def all(self) -> list[Unit]:
        return self.loaded.all

    @property
    def links(self) -> list[Link]:
        return self.loaded.links

    @property
    def alias_links(self) -> dict[tuple[str, str], str]:
        """(manager, alias) -> the unit of the distribution that a link of the tree gives the name to."""
        return self.loaded.alias_links

    @cached_property
    def named_instances(self) -> dict[tuple[str, str], set[str]]:
        """(manager, template) -> the instances that something in the tree names."""
        found: dict[tuple[str, str], set[str]] = {}
        keys = (*PULLS, "After", "Before")
        named = [(unit.manager, word) for unit in self.all for key in keys for word in unit.words(key)]
        for manager, word in [*named, *((link.manager, link.name) for link in self.links)]:
            parts = split_name(word) if "@" in word else None
            if parts is not None and parts.instance and "%" not in parts.instance:
                found.setdefault((manager, f"{parts.prefix}@.{parts.type}"), set()).add(parts.instance)
        return found

    def candidates(self, name: str, manager: str = "system") -> list[Unit]:
        """The units of this name; for an instance without a file of its own, those of its template."""
        return self.loaded.index.candidates(name, manager)

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
        """What a name of the distribution means: ``default.target`` is ``graphical.target`` unless the
        tree links it."""
        if (manager, name) in self.alias_links:
            return self.alias_links[manager, name]
        return shipped_units.aliases().get(name, name) if manager == "system" else name

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
        if not is_unit_name(name):
            return False
        if self.exists(name, near) is not False or self.is_distribution_unit(name) or self.is_joined(near):
            return False
        return self.files.tree.complete or (self.is_own(name, near) and not self.is_made_by_script(name))

    def service_of_target(self, name: str, near: Unit) -> str | None:
        """The service of the distribution that a target means which nobody has: ``docker.service`` for
        ``docker.target``."""
        service = f"{name.removesuffix('.target')}.service"
        if not name.endswith(".target") or not self.is_distribution_unit(service):
            return None
        is_there = self.exists(name, near) is not False or self.is_distribution_unit(name)
        return None if is_there or self.is_joined(near) or self.is_made_by_script(name) else service

    @memo
    def is_joined(self, unit: Unit) -> bool:
        """Whether a unit is of a layer of Yocto: recipes of others bring units, make some and rename them."""
        return unit.fragment is not None and is_in_layer(self.files.tree, unit.fragment.source)

    def is_own(self, name: str, near: Unit) -> bool:
        """Whether a name looks like the robot's own units: the same first word, or nearly the name of one."""
        family = _family(name)
        related = len(family) > 2 and "-" in name and family != "systemd"
        return (related and family in self._families(near.manager)) or bool(self.meant(name, near))

    @memo
    def _families(self, manager: str) -> frozenset[str]:
        return frozenset(_family(unit.name) for unit in self.all if unit.manager == manager and unit.fragment)

    def meant(self, name: str, near: Unit) -> str | None:
        """The one unit of the tree whose name a misspelt one nearly is. Units that differ in a number are
        no misspellings."""
        return self._nearly(name, near.manager, near.name)

    def _nearly(self, name: str, manager: str, besides: str = "") -> str | None:
        stem, _, kind = name.rpartition(".")
        if len(stem) < 6:
            return None
        near = [other for other in self._nearest((stem, manager, kind)) if f"{other}.{kind}" != besides]
        if not near and self._nearest((stem, manager, kind)):
            near = nearest(stem, [each for each in self._stems((manager, kind)) if f"{each}.{kind}" != besides])
        found = [other for other in near if _DIGITS.sub("", other) != _DIGITS.sub("", stem)]
        return f"{found[0]}.{kind}" if len(found) == 1 else None

    @memo
    def _nearest(self, asked: tuple[str, str, str]) -> list[str]:
        """The stems that are nearest to one, of all units of a manager and type."""
        stem, manager, kind = asked
        return nearest(stem, self._stems((manager, kind)))

    def lacks(self, name: str, manager: str) -> bool:
        """Whether a command names a unit that looks like one of the robot's own, and that nothing provides."""
        if not is_unit_name(name) or "%" in name or GENERATED.search(name) or self.is_distribution_unit(name):
            return False
        if self.candidates(name, manager) or (manager, name) in self.alias_links or self.is_made_by_script(name):
            return False
        if layers(self.files.tree):
            return False
        family = _family(name)
        related = len(family) > 2 and "-" in name and family in self._families(manager)
        return related or self._nearly(name, manager) is not None or bool(self._template_or_longer(name, manager))

    def _template_or_longer(self, name: str, manager: str) -> list[Unit]:
        """The units of the tree that are templates of this name, or of whose names it is the end. One that names the
        shorter name itself wraps a unit that a package brings."""
        stem, _, kind = name.rpartition(".")
        own = (unit for unit in self.all if (unit.manager, unit.type) == (manager, kind) and unit.fragment)
        if "@" in stem:
            return []
        return [
            unit
            for unit in own
            if unit.stem == f"{stem}@"
            or (len(stem) >= _SURE_STEM and "-" in stem and unit.stem.endswith(stem) and not _names(unit, name))
        ]

    def like(self, name: str, manager: str) -> list[Unit]:
        """The units of the tree that a missing name may mean: nearly the same, else of its first word."""
        nearly = self._nearly(name, manager)
        own = [unit for unit in self.all if unit.manager == manager and unit.fragment is not None]
        own_name = [unit for unit in own if unit.name == nearly] or self._template_or_longer(name, manager)
        return own_name or [
            unit for unit in own if _family(unit.name) == _family(name) and unit.type == name.rpartition(".")[2]
        ]

    @memo
    def _stems(self, kind: tuple[str, str]) -> list[str]:
        """The names of the units of a manager and type, without the type."""
        return sorted({unit.stem for unit in self.all if (unit.manager, unit.type) == kind})

    def is_install_target_missing(self, name: str, unit: Unit) -> bool:
        """Whether the unit of an [Install] setting is not there. Only few own units are targets, so that a target that
        nothing in the tree makes is missing whatever its name."""
        if name.endswith(".target") and not self.files.tree.complete:
            is_there = self.exists(name, unit) is not False or self.is_made_by_script(name)
            return not is_there and not self.is_joined(unit)
        return self.is_missing(name, unit)

    def install_targets(self, unit: Unit) -> list[str]:
        """The names that WantedBy= of the unit can mean: the targets of the tree and the usual ones."""
        own = (f"{stem}.target" for manager in ("system", "user") for stem in self._stems((manager, "target")))
        return sorted({name for name in own if name != unit.name} | _USUAL_TARGETS)

    @staticmethod
    def is_name(text: str) -> bool:
        """Whether systemd takes the text as the name of a unit."""
        return is_unit_name(text)

    def is_made_by_script(self, name: str) -> bool:
        """Whether a script of the tree makes a file of that name."""
        return makes(self.files.tree, name)

    def is_started_by_script(self, unit: Unit) -> bool:
        """Whether a script or an Ansible task of the tree starts the unit by its name."""
        return starts(self.files.tree, unit.name)

    def is_distribution_unit(self, name: str) -> bool:
        """Whether Ubuntu or Debian ships the unit (table ``systemd_units``), templates' instances
        included."""
        return shipped_units.is_shipped(name)

    def shipped_type(self, name: str) -> str:
        """The Type= of a service that Ubuntu or Debian ships with a command; else empty."""
        return shipped_units.service_type(name)

    @cached_property
    def has_vendor_units(self) -> bool:
        """Whether the tree holds the distribution's own units, so that no table has to stand in for them."""
        return self.files.tree.complete and any(
            unit.name == "multi-user.target" and unit.fragment and unit.fragment.source.robot_path for unit in self.all
        )

    @cached_property
    def knows_enabled(self) -> bool:
        """Whether the links of a root file system tell which units are enabled, rather than their [Install]
        sections."""
        return self.files.tree.complete and any(
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
        if self.installs(unit):
            for key, relation in (("WantedBy", "Wants"), ("RequiredBy", "Requires"), ("UpheldBy", "Upholds")):
                for word in unit.words(key, "Install"):
                    yield str(word), relation, word
        for link in self._links_to.get(unit, []):
            yield link.unit, link.relation, link.name

    @cached_property
    def _links_to(self) -> dict[Unit, list[Link]]:
        """The links that pull in a unit: by its name or an alias, or as the only one that the name can mean."""
        found: dict[Unit, list[Link]] = {}
        for link in self.links:
            named = self.candidates(link.name, link.manager)
            for unit in named:
                if len(named) == 1 or link.name == unit.name or link.name in unit.aliases:
                    found.setdefault(unit, []).append(link)
        return found


def _apart(one: Unit, other: Unit) -> bool:
    """Whether two units lie in different overlays."""
    overlays = [overlay_of(unit.files[0].source) for unit in (one, other) if unit.files]
    return len(overlays) == 2 and None not in overlays and overlays[0] != overlays[1]


def _names(unit: Unit, name: str) -> bool:
    """Whether a unit speaks of another one, as what wraps or extends it does."""
    return any(re.search(rf"(?<![\w.-]){re.escape(name)}\b", each.source.text) for each in unit.files)


def _family(name: str) -> str:
    """The first word of a unit's name: ``rover`` of ``rover-nav@a.service``."""
    return re.split(r"[-@.]", name, maxsplit=1)[0]
