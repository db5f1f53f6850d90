"""Joining the unit files of a tree to units: shadowing, masks, aliases, links, drop-ins (systemd.unit(5))."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.load_path import Place
from bringup_lint.graph.systemd.load_path import order
from bringup_lint.graph.systemd.load_path import place_of
from bringup_lint.graph.systemd.shipped_units import GENERATED
from bringup_lint.graph.systemd.shipped_units import is_shipped
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.unit import UnitFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.unit import parse
from bringup_lint.parsers.unit import unit_name
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.templates import final_name
from bringup_lint.templates import is_sample

_LINK_FOLDER = regex(r"([^/]+)\.(wants|requires|upholds)$", 0, ".wants .requires .upholds")
_RELATION = {"wants": "Wants", "requires": "Requires", "upholds": "Upholds"}


class Link(NamedTuple):
    """An entry of ``UNIT.wants/`` and the like: UNIT pulls in ``name``."""

    unit: str
    relation: str
    name: Located
    source: Source
    manager: str = "system"
    place: str = ""


class NameIndex:
    """Units by the names that they have, aliases included."""

    def __init__(self, units: Iterable[Unit]) -> None:
        self._by_name: dict[tuple[str, str], list[Unit]] = {}
        for unit in units:
            self.add(unit)

    def add(self, unit: Unit) -> None:
        for name in dict.fromkeys((unit.name, *unit.aliases, *_install_aliases(unit))):
            self._by_name.setdefault((unit.manager, name), []).append(unit)

    def candidates(self, name: str, manager: str = "system") -> list[Unit]:
        """The units of this name; for an instance without a file of its own, those of its template."""
        found = self._by_name.get((manager, name))
        if found is None and "@" in name:
            stem, _, suffix = name.rpartition(".")
            found = self._by_name.get((manager, f"{stem.partition('@')[0]}@.{suffix}"))
        return found or []


def _install_aliases(unit: Unit) -> Iterator[str]:
    """The names that enabling the unit gives it. Its drop-ins are not joined yet, and seldom hold any."""
    if not unit.fragment:
        return
    for assignment in unit.fragment.assignments:
        if assignment.key == "Alias" and assignment.section == "Install":
            yield from map(str, assignment.value.words())


@dataclass(eq=False)
class LoadedUnits:
    """The units of a tree."""

    all: list[Unit] = field(default_factory=list)
    links: list[Link] = field(default_factory=list)
    alias_links: dict[tuple[str, str], str] = field(default_factory=dict)
    """(manager, alias) -> the unit of the distribution that a link of the tree gives the name to."""
    shadowed: list[tuple[UnitFile, Unit]] = field(default_factory=list)
    """Files that a higher directory hides, with the unit that hides them."""
    orphans: list[UnitFile] = field(default_factory=list)
    """Drop-ins of units that neither the tree nor the distribution has."""
    loose: list[UnitFile] = field(default_factory=list)
    """Drop-ins of single instances and of groups of units that the tree does not hold."""

    @cached_property
    def index(self) -> NameIndex:
        return NameIndex(self.all)


class _Alias(NamedTuple):
    """A link from one unit name to another."""

    place: Place
    name: str
    target: str


def load_units(files: Files) -> LoadedUnits:
    """Join the unit files of the tree to units."""
    loaded = LoadedUnits()
    fragments: dict[tuple[str, str, str], list[tuple[int, Source]]] = {}
    aliases: list[_Alias] = []
    for source in files.of_kind("systemd-unit"):
        linked = _LINK_FOLDER.search(source.name.rpartition("/")[0])
        place = place_of(source)
        name = unit_name(source)[0]
        target = (source.link or "").rpartition("/")[2]
        if linked:
            loaded.links.append(_link(source, linked))
        elif source.link and target != name and source.link != "/dev/null":
            aliases.append(_Alias(place, name, target))
        else:
            fragments.setdefault((place.root, place.manager, name), []).append((order(place), source))
    for (root, manager, name), found in fragments.items():
        sources = _without_samples([source for _, source in sorted(found, key=lambda ranked: ranked[0])])
        _add_unit(loaded, Unit(name, manager, place=root), sources, files)
    _add_aliases(loaded, aliases)
    _add_dropins(loaded, files)
    return loaded


def _without_samples(sources: list[Source]) -> list[Source]:
    """The files of a unit; its sample only where there is nothing else."""
    return [source for source in sources if not is_sample(source.basename)] or sources


def _add_aliases(loaded: LoadedUnits, aliases: list[_Alias]) -> None:
    units: dict[tuple[str, str, str], list[Unit]] = {}
    for unit in loaded.all:
        units.setdefault((unit.place, unit.manager, unit.name), []).append(unit)
    for place, name, target in aliases:
        named = units.get((place.root, place.manager, target), [])
        for unit in named:
            unit.aliases.append(name)
        if not named:
            loaded.alias_links[place.manager, name] = target


def _link(source: Source, folder: re.Match[str]) -> Link:
    name = Located(source.basename, source.whole)
    place = place_of(source, (source.robot_path or source.name).rpartition("/")[0])
    return Link(folder.group(1), _RELATION[folder.group(2)], name, source, place.manager, place.root)


def _add_unit(loaded: LoadedUnits, unit: Unit, sources: list[Source], files: Files) -> None:
    winner, *hidden = sources
    if winner.link == "/dev/null" or (not winner.text and winner.link is None):
        unit.masked = winner
    elif winner.text or winner.link is None:
        unit.fragment = next(iter(files.parsed(parse, [winner])), None)
    loaded.all.append(unit)
    loaded.shadowed += [(file, unit) for file in files.parsed(parse, [source for source in hidden if source.text])]


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


def _add_dropins(loaded: LoadedUnits, files: Files) -> None:
    by_folder: dict[tuple[str, str], list[tuple[Place, UnitFile]]] = {}
    sources = [source for source in files.of_kind("systemd-dropin") if final_name(source.basename).endswith(".conf")]
    for file in files.parsed(parse, sources):
        place = place_of(file.source, folder=(file.source.robot_path or "").rpartition("/")[0])
        by_folder.setdefault((place.manager, file.name), []).append((place, file))
    _add_extended(loaded, by_folder)
    joined: set[UnitFile] = set()
    for unit in loaded.all:
        _extend(unit, by_folder, joined, alone=len(loaded.index.candidates(unit.name, unit.manager)) == 1)
    loaded.loose = [file for found in by_folder.values() for _, file in found if file not in joined]


def _add_extended(loaded: LoadedUnits, by_folder: dict[tuple[str, str], list[tuple[Place, UnitFile]]]) -> None:
    """Add the units of the distribution that the tree only extends."""
    for (manager, name), files in by_folder.items():
        if "." not in name or name.partition(".")[0].endswith(("-", "@")) or loaded.index.candidates(name, manager):
            continue
        unit = Unit(name, manager, place=files[0][0].root)
        loaded.all.append(unit)
        loaded.index.add(unit)
        if not is_shipped(name) and not GENERATED.search(name):
            loaded.orphans += [file for _, file in files]


def _extend(
    unit: Unit, by_folder: dict[tuple[str, str], list[tuple[Place, UnitFile]]], joined: set[UnitFile], *, alone: bool
) -> None:
    """Give a unit its drop-ins; of files of one name the one of the highest and most specific folder."""
    winners: dict[str, tuple[tuple[int, int], UnitFile]] = {}
    for specificity, folder in enumerate(dropin_folders(unit)):
        for place, file in by_folder.get((unit.manager, folder), ()):
            if place.root != unit.place and not (alone and folder == unit.name):
                continue
            joined.add(file)
            rank = (order(place), specificity)
            known = winners.get(file.source.basename)
            if known is None or rank < known[0]:
                winners[file.source.basename] = (rank, file)
    unit.dropins = [winners[name][1] for name in sorted(winners) if winners[name][1].source.link != "/dev/null"]
