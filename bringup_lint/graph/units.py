"""All units of a robot: load paths, shadowing, masks, aliases, drop-ins and links (systemd.unit(5))."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph import boot
from bringup_lint.graph import distribution
from bringup_lint.graph.cycles import ROOTS
from bringup_lint.graph.cycles import Cycle
from bringup_lint.graph.cycles import ordering_cycles
from bringup_lint.graph.dependencies import dependency_graph
from bringup_lint.graph.environment import Environment
from bringup_lint.graph.environment import EnvironmentFile
from bringup_lint.graph.environment import environment_files
from bringup_lint.graph.environment import process_environment
from bringup_lint.graph.environment import stays_local
from bringup_lint.graph.environment import unit_environment
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.process import Process
from bringup_lint.graph.process import processes
from bringup_lint.graph.provision import makes
from bringup_lint.graph.restart import RestartPolicy
from bringup_lint.graph.restart import restart_policy
from bringup_lint.graph.supervision import Supervision
from bringup_lint.graph.supervision import supervision
from bringup_lint.graph.stack_layers import layers
from bringup_lint.graph.unit import Unit
from bringup_lint.graph.waits import Wait
from bringup_lint.graph.waits import longest_wait
from bringup_lint.graph.unit_lines import Line
from bringup_lint.graph.unit_lines import lines
from bringup_lint.facts.directives import NEWEST
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.systemd_values import is_unit_name
from bringup_lint.parsers.unit import parse
from bringup_lint.parsers.unit import unit_name
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest
from bringup_lint.templates import final_name

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

SYSTEM_PATH = (
    "/etc/systemd/system.control",
    "/run/systemd/system.control",
    "/run/systemd/transient",
    "/run/systemd/generator.early",
    "/etc/systemd/system",
    "/etc/systemd/system.attached",
    "/run/systemd/system",
    "/run/systemd/system.attached",
    "/run/systemd/generator",
    "/usr/local/lib/systemd/system",
    "/usr/lib/systemd/system",
    "/lib/systemd/system",
    "/run/systemd/generator.late",
)
USER_PATH = (
    "/.config/systemd/user.control",
    "/.config/systemd/user",
    "/etc/systemd/user",
    "/run/systemd/user",
    "/.local/share/systemd/user",
    "/usr/local/share/systemd/user",
    "/usr/local/lib/systemd/user",
    "/usr/lib/systemd/user",
    "/lib/systemd/user",
)
"""Directories in the order in which they win (systemd.unit(5), "Unit File Load Path")."""

_DDS_VARIABLE = re.compile(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|ZENOH)_(?!VERSION$|PYTHON_VERSION$)")
_USER_FOLDER = re.compile(
    r"(?:^|/)(?:(?:systemd|units?|services?)[/_-]user|user[_-](?:systemd|units?|services?))(?:/|$)"
)
_DIGITS = re.compile(r"\d+")
_STARTING = frozenset({"requires", "binds-to", "wants", "upholds", "triggers", "on-failure", "on-success"})
_LINK_FOLDER = re.compile(r"([^/]+)\.(wants|requires|upholds)$")
_RELATION = {"wants": "Wants", "requires": "Requires", "upholds": "Upholds"}
GENERATED = re.compile(
    r"\.(?:device|mount|automount|swap|slice|scope)$|^(?:getty|serial-getty|user|user-runtime-dir|modprobe|systemd-fsck"
    r"|systemd-backlight|systemd-growfs|systemd-cryptsetup|systemd-pcrphase|wpa_supplicant|dhcpcd|ifup|netplan-\w+"
    r"|container-getty|autovt|systemd-[\w-]+)@|^(?:dbus-.*|netplan-.*|snap[.-].*|cloud-.*|nvargus-.*|nvidia-.*)\.\w+$"
)
"""Names that the kernel, a generator or an installed package provides, so that nothing in a tree can prove them missing."""


def _family(name: str) -> str:
    """The first word of a unit's name: ``rover`` of ``rover-nav@a.service``."""
    return re.split(r"[-@.]", name, maxsplit=1)[0]


class Link(NamedTuple):
    """An entry of ``UNIT.wants/`` and the like: UNIT pulls in ``name``."""

    unit: str
    relation: str
    name: Located
    source: Source
    manager: str = "system"
    place: str = ""


class _Place(NamedTuple):
    """Where a file stands: its overlay root or folder, the manager, and its rank in the load path (None: outside)."""

    root: str
    manager: str
    rank: int | None


def place_of(source: Source, folder: str | None = None) -> _Place:
    """The place of a unit file, or of the ``.d`` or ``.wants`` folder that holds it."""
    path = source.robot_path
    if path is not None:
        directory = (folder or path).rpartition("/")[0]
        if directory in SYSTEM_PATH:
            return _Place(source.name.removesuffix(path.lstrip("/")), "system", SYSTEM_PATH.index(directory))
        for rank, suffix in enumerate(USER_PATH):
            if directory == suffix or (suffix.startswith("/.") and directory.endswith(suffix)):
                return _Place(source.name.removesuffix(path.lstrip("/")), "user", rank)
    directory = (source.name if folder is None else source.name.rpartition("/")[0]).rpartition("/")[0]
    manager = "user" if _USER_FOLDER.search(directory) else "system"
    return _Place(directory, manager, None)


@dataclass(eq=False)
class Units:
    """Every unit of the tree, and what is known about the distribution's."""

    robot: Robot
    all: list[Unit] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    shadowed: list[tuple[UnitFile, Unit]] = field(default_factory=list)
    """Files that a higher directory hides, with the unit that hides them."""
    orphans: list[UnitFile] = field(default_factory=list)
    """Drop-ins of units that neither the tree nor the distribution has."""
    loose: list[UnitFile] = field(default_factory=list)
    """Drop-ins of single instances and of groups of units that the tree does not hold."""
    files: list[UnitFile] = field(default_factory=list)
    """All unit files and drop-ins that systemd reads, as written, judged ones only."""
    alias_links: dict[tuple[str, str], str] = field(default_factory=dict)
    """(manager, alias) -> the unit of the distribution that a link of the tree gives the name to."""

    @cached_property
    def judged(self) -> list[Unit]:
        """The units that rules about effective settings look at."""
        return [unit for unit in self.all if unit.judged and not unit.masked and unit.files]

    @cached_property
    def lines(self) -> list[Line]:
        """Every judged line with a key that its section knows, and what systemd finds wrong with its value."""
        target = self.robot.target
        return list(lines(self.files, target.systemd if target.systemd_known else NEWEST))

    def mount_name(self, unit: Unit, where: str) -> str:
        """The name that a mount or automount unit of this path must have."""
        from bringup_lint.parsers.systemd_values import escape_path

        return f"{escape_path(where)}.{unit.type}"

    @property
    def services(self) -> list[Unit]:
        return [unit for unit in self.judged if unit.type == "service"]

    @cached_property
    def _environments(self) -> dict[int, Environment]:
        return {}

    def environment(self, unit: Unit) -> Environment:
        """What systemd gives to the processes of a unit. Do not change it."""
        if id(unit) not in self._environments:
            self._environments[id(unit)] = unit_environment(unit, self.robot)
        return self._environments[id(unit)]

    def environment_files(self, unit: Unit) -> list[EnvironmentFile]:
        """The environment files of a unit, in the order in which they are read."""
        return environment_files(unit, self.robot)

    def stays_local(self, unit: Unit) -> bool:
        """Whether everything that the unit starts talks to this machine only."""
        found = [process_environment(process, self.robot) for process in self.started(unit)]
        return bool(found) and all(map(stays_local, found))

    @cached_property
    def _policies(self) -> dict[int, RestartPolicy]:
        return {}

    def restart(self, unit: Unit) -> RestartPolicy:
        """What systemd does when the service ends."""
        if id(unit) not in self._policies:
            self._policies[id(unit)] = restart_policy(unit, self.robot)
        return self._policies[id(unit)]

    @cached_property
    def _supervisions(self) -> dict[int, Supervision]:
        return {}

    def supervision(self, unit: Unit) -> Supervision:
        """How systemd starts, watches and stops the service."""
        if id(unit) not in self._supervisions:
            self._supervisions[id(unit)] = supervision(unit, self.robot)
        return self._supervisions[id(unit)]

    def longest_wait(self, process: Process) -> Wait:
        """How long a command line may wait, by the loops and sleeps of its shells and scripts."""
        return longest_wait(process, self.robot)

    @cached_property
    def triggered(self) -> frozenset[str]:
        """The names of the units that a timer or path unit of the tree starts: jobs, not daemons."""
        found = set()
        for unit in self.all:
            if unit.type in ("timer", "path"):
                found.add(str(unit.get("Unit") or f"{unit.stem}.service"))
        return frozenset(found)

    @cached_property
    def _processes(self) -> dict[int, list[Process]]:
        return {}

    def processes(self, unit: Unit) -> list[Process]:
        """The command lines of a service with what they run."""
        if id(unit) not in self._processes:
            self._processes[id(unit)] = processes(unit, self.robot)
        return self._processes[id(unit)]

    def started(self, unit: Unit) -> list[Process]:
        """The command lines of ExecStart= alone."""
        return [process for process in self.processes(unit) if process.key == "ExecStart"]

    @cached_property
    def graph(self) -> Graph:
        """Requirement and ordering edges of all units, the distribution's included."""
        return dependency_graph(self)

    @cached_property
    def cycles(self) -> list[Cycle]:
        default = self.alias_links.get(("system", "default.target"))
        return list(ordering_cycles(self.graph, [default] if default else ROOTS))

    @cached_property
    def ros(self) -> list[Unit]:
        """The services that start something of ROS 2."""
        return [
            unit for unit in self.services if any(process.mentions_ros for process in self.processes(unit))
        ]

    @cached_property
    def dds(self) -> list[Unit]:
        """The services that take part in ROS 2's communication: they start it, or their environment configures it."""
        ros1 = [unit for unit in self.ros if all(p.is_ros1 for p in self.processes(unit) if p.mentions_ros)]
        return [
            unit
            for unit in self.services
            if unit not in ros1
            and (unit in self.ros or any(_DDS_VARIABLE.match(name) for name in self.environment(unit).chains))
        ]

    @cached_property
    def presumed_ros(self) -> list[Unit]:
        """Services of a ROS 2 tree that run a shell script which the tree does not hold: most likely ROS too."""
        if not self.robot.is_ros:
            return []
        return [
            unit
            for unit in self.services
            if unit not in self.dds
            and unit not in self.ros
            and unit.get("Type") != "oneshot"
            and any(process.lost_script for process in self.started(unit))
        ]

    @cached_property
    def stacks(self) -> list[list[Unit]]:
        """The ROS services of one place that are enabled somewhere, so that they may run together."""
        places: dict[str, list[Unit]] = {}
        for unit in self.ros:
            if unit.manager == "system" and not unit.is_template and any(True for _ in self.wanted_by(unit)):
                places.setdefault(unit.place, []).append(unit)
        return [units for units in places.values() if len(units) > 1]

    def conflict(self, one: Unit, other: Unit) -> bool:
        """Whether the two never run at the same time."""
        return other.name in one.words("Conflicts") or one.name in other.words("Conflicts")

    def layers(self, units: list[Unit]) -> dict[str, str]:
        """Unit name -> layer of the robot's stack, for those whose names tell one."""
        return layers(units)

    @cached_property
    def launch(self) -> list[tuple[Unit, Process]]:
        """The services whose main process is ``ros2 launch``, with the command line that starts it."""
        return [
            (unit, process)
            for unit in self.ros
            for process in self.started(unit)
            if process.launches and process.replaces_shell
        ]

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
        """The unit that a name in ``near`` means; None when it is not in the tree or several variants could be meant."""
        found = self.candidates(name, near.manager)
        if len(found) > 1:
            found = [unit for unit in found if unit.place == near.place]
        return found[0] if len(found) == 1 else None

    def node(self, unit: Unit, instance: str = "") -> Node:
        """The unit, or one instance of a template, in the graph."""
        name = f"{unit.stem}{instance}.{unit.type}" if unit.is_template else unit.name
        alone = len(self.candidates(unit.name, unit.manager)) == 1
        return Node("unit" if unit.manager == "system" else "user-unit", name, "" if alone else unit.place)

    def real_name(self, name: str, manager: str = "system") -> str:
        """What a name of the distribution stands for: ``default.target`` is ``graphical.target`` unless the tree links it."""
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
        provides it, no script makes it, and it is named like the robot's own units, or nearly like one of them."""
        if self.exists(name, near) is not False or self.is_distribution_unit(name):
            return False
        if self.robot.tree.complete:
            return True
        own = {unit.name for unit in self.all if unit.manager == near.manager and unit.fragment}
        family = _family(name)
        related = len(family) > 2 and "-" in name and any(_family(other) == family for other in own)
        return (related or self.meant(name, near) is not None) and not self.is_made(name)

    def meant(self, name: str, near: Unit) -> str | None:
        """The one unit of the tree whose name a misspelt one nearly is. Units that differ in a number are no misspellings."""
        stem, _, kind = name.rpartition(".")
        if len(stem) < 6:
            return None
        own = {
            unit.stem
            for unit in self.all
            if unit.type == kind and unit.manager == near.manager and unit is not near
        }
        found = [
            other for other in nearest(stem, sorted(own)) if _DIGITS.sub("", other) != _DIGITS.sub("", stem)
        ]
        return f"{found[0]}.{kind}" if len(found) == 1 else None

    @staticmethod
    def is_name(text: str) -> bool:
        """Whether systemd takes the text as the name of a unit."""
        return is_unit_name(text)

    def is_made(self, name: str) -> bool:
        """Whether a script of the tree makes a file of that name."""
        return makes(self.robot.tree, name)

    def is_started(self, unit: Unit) -> bool:
        """Whether something starts the unit, or can be told to: an [Install] section, another unit, D-Bus, a udev rule."""
        if unit.is_template or unit.aliases or unit.get("BusName") or any(unit.sections("Install")):
            return True
        if self.is_distribution_unit(unit.name) or unit.name.startswith("systemd-"):
            return True
        edges = self.graph.into.get(self.node(unit), ())
        if any(edge.kind in _STARTING for edge in edges):
            return True
        name = re.escape(unit.name)
        return any(re.search(rf"\b{name}", source.text) for source in self.robot.of_kind("udev-rules"))

    def waits_for(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain of ordering by which the unit starts after the named one; None when there is none."""
        return boot.waits_for(self, unit, name)

    def ordered(self, unit: Unit, name: str) -> bool:
        """Whether the two units have an order at all, whichever is first."""
        return boot.ordered(self, unit, name)

    def brings_in(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain by which starting the unit starts the named one too; None when there is none."""
        return boot.brings_in(self, unit, name)

    def brought_in(self, near: Unit, name: str) -> list[Edge] | None:
        """The chain by which the named unit starts at boot, whatever ``near`` says."""
        return boot.brought_in(self, near, name)

    def is_distribution_unit(self, name: str) -> bool:
        """Whether Ubuntu or Debian ships the unit (table ``systemd_units``), templates' instances included."""
        if name in distribution.names():
            return True
        stem, _, suffix = name.rpartition(".")
        return "@" in stem and f"{stem.partition('@')[0]}@.{suffix}" in distribution.names()

    @cached_property
    def has_vendor_units(self) -> bool:
        """Whether the tree holds the distribution's own units, so that no table has to stand in for them."""
        return self.robot.tree.complete and any(
            unit.name == "multi-user.target" and unit.fragment and unit.fragment.source.robot_path
            for unit in self.all
        )

    @cached_property
    def knows_enabled(self) -> bool:
        """Whether the links of a root file system tell which units are enabled, rather than their [Install] sections."""
        return self.robot.tree.complete and any(
            (link.source.robot_path or "").startswith("/etc/systemd/system/") for link in self.links
        )

    def installs(self, unit: Unit) -> bool:
        """Whether the unit's [Install] section counts: a root file system with links knows better."""
        return not self.knows_enabled or unit.manager == "user"

    def is_provided(self, name: str) -> bool | None:
        """Whether the distribution has the unit; None for names that generators, the kernel or packages bring."""
        return None if "%" in name or GENERATED.search(name) else self.is_distribution_unit(name)

    def wanted_by(self, unit: Unit) -> Iterator[tuple[str, str, Located]]:
        """Who pulls the unit in by installation: (unit name, ``Wants``/``Requires``/``Upholds``, the word that says so)."""
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


def _install_aliases(unit: Unit) -> Iterator[str]:
    """The names that enabling the unit gives it. Its drop-ins are not joined yet, and seldom hold any."""
    for assignment in unit.fragment.assignments if unit.fragment else ():
        if assignment.key == "Alias" and assignment.section == "Install":
            yield from map(str, assignment.value.words())


def load_units(robot: Robot) -> Units:
    """Join the unit files of the tree to units."""
    units = Units(robot)
    fragments: dict[tuple[str, str, str], list[tuple[int, Source]]] = {}
    aliases: list[tuple[_Place, str, str]] = []
    for source in robot.of_kind("systemd-unit"):
        folder = source.name.rpartition("/")[0]
        linked = _LINK_FOLDER.search(folder)
        if linked:
            units.links.append(_link(source, linked))
            continue
        place = place_of(source)
        name = unit_name(source)[0]
        target = (source.link or "").rpartition("/")[2]
        if source.link and target != name and source.link != "/dev/null":
            aliases.append((place, name, target))
            continue
        fragments.setdefault((place.root, place.manager, name), []).append((_order(place), source))
    for (root, manager, name), sources in fragments.items():
        _add_unit(
            units,
            Unit(name, manager, place=root),
            [source for _, source in sorted(sources, key=lambda s: s[0])],
        )
    for place, name, target in aliases:
        named = [
            u for u in units.all if u.name == target and u.manager == place.manager and u.place == place.root
        ]
        for unit in named:
            unit.aliases.append(name)
        if not named:
            units.alias_links[place.manager, name] = target
    _add_dropins(units, robot)
    units.files = list({id(file): file for file in _files(units) if file.source.judged}.values())
    return units


def _order(place: _Place) -> int:
    return len(SYSTEM_PATH) if place.rank is None else place.rank


def _link(source: Source, folder: re.Match[str]) -> Link:
    name = Located(source.basename, source.whole)
    place = place_of(source, (source.robot_path or source.name).rpartition("/")[0])
    return Link(folder.group(1), _RELATION[folder.group(2)], name, source, place.manager, place.root)


def _add_unit(units: Units, unit: Unit, sources: list[Source]) -> None:
    winner, *hidden = sources
    if winner.link == "/dev/null" or (not winner.text and winner.link is None):
        unit.masked = winner
    elif winner.text or winner.link is None:
        unit.fragment = next(iter(units.robot.parsed(parse, [winner])), None)
    units.all.append(unit)
    units.shadowed += [(file, unit) for file in units.robot.parsed(parse, filter(lambda s: s.text, hidden))]


def _files(units: Units) -> Iterator[UnitFile]:
    for unit in units.all:
        yield from unit.files
    yield from units.loose


def dropin_folders(unit: Unit) -> list[str]:
    """The folders whose files extend the unit, the most specific first (systemd.unit(5))."""
    folders = []
    for name in (unit.name, *unit.aliases):
        stem, _, suffix = name.rpartition(".")
        folders.append(name)
        if "@" in stem:
            stem = stem.partition("@")[0]
            folders.append(f"{stem}@.{suffix}")
        dashes = [at for at, char in enumerate(stem) if char == "-" and at + 1 < len(stem)]
        folders += [f"{stem[: at + 1]}.{suffix}" for at in reversed(dashes)]
    folders.append(unit.type)
    return list(dict.fromkeys(folders))


def _add_dropins(units: Units, robot: Robot) -> None:
    by_folder: dict[tuple[str, str], list[tuple[_Place, UnitFile]]] = {}
    dropins = [s for s in robot.of_kind("systemd-dropin") if final_name(s.basename).endswith(".conf")]
    for file in robot.parsed(parse, dropins):
        source = file.source
        place = place_of(source, folder=(source.robot_path or "").rpartition("/")[0])
        by_folder.setdefault((place.manager, file.name), []).append((place, file))
    for (manager, name), files in by_folder.items():
        if (
            "." in name
            and not name.partition(".")[0].endswith(("-", "@"))
            and not units.candidates(name, manager)
        ):
            _add_extended(units, name, manager, files)
    known: set[int] = set()
    for unit in units.all:
        _extend(unit, by_folder, known, alone=len(units.candidates(unit.name, unit.manager)) == 1)
    units.loose = [file for files in by_folder.values() for _, file in files if id(file) not in known]


def _add_extended(units: Units, name: str, manager: str, files: list[tuple[_Place, UnitFile]]) -> None:
    """A unit of the distribution that the tree only extends."""
    units.all.append(Unit(name, manager, place=files[0][0].root))
    units.__dict__.pop("_by_name", None)
    if not units.is_distribution_unit(name) and not GENERATED.search(name):
        units.orphans += [file for _, file in files]


def _extend(
    unit: Unit, by_folder: dict[tuple[str, str], list[tuple[_Place, UnitFile]]], seen: set[int], alone: bool
) -> None:
    winners: dict[str, tuple[tuple[int, int], UnitFile]] = {}
    for specificity, folder in enumerate(dropin_folders(unit)):
        for place, file in by_folder.get((unit.manager, folder), ()):
            if place.root != unit.place and not (alone and folder == unit.name):
                continue
            seen.add(id(file))
            rank = (_order(place), specificity)
            known = winners.get(file.source.basename)
            if known is None or rank < known[0]:
                winners[file.source.basename] = (rank, file)
    unit.dropins = [
        winners[name][1] for name in sorted(winners) if winners[name][1].source.link != "/dev/null"
    ]
