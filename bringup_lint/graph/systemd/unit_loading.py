"""Joining the unit files of a tree to units: shadowing, masks, aliases, links, drop-ins (systemd.unit(5))."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.systemd.load_path import Place
from bringup_lint.graph.systemd.load_path import order
from bringup_lint.graph.systemd.load_path import place_of
from bringup_lint.graph.systemd.named_units import GENERATED
from bringup_lint.graph.systemd.named_units import Link
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.unit import parse
from bringup_lint.parsers.unit import unit_name
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.templates import final_name

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_LINK_FOLDER = re.compile(r"([^/]+)\.(wants|requires|upholds)$")
_RELATION = {"wants": "Wants", "requires": "Requires", "upholds": "Upholds"}


def load_units(robot: Robot) -> Units:
    """Join the unit files of the tree to units."""
    units = Units(robot)
    fragments: dict[tuple[str, str, str], list[tuple[int, Source]]] = {}
    aliases: list[tuple[Place, str, str]] = []
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
        fragments.setdefault((place.root, place.manager, name), []).append((order(place), source))
    for (root, manager, name), sources in fragments.items():
        _add_unit(
            units,
            Unit(name, manager, place=root),
            [source for _, source in sorted(sources, key=lambda s: s[0])],
        )
    for place, name, target in aliases:
        named = [u for u in units.all if u.name == target and u.manager == place.manager and u.place == place.root]
        for unit in named:
            unit.aliases.append(name)
        if not named:
            units.alias_links[place.manager, name] = target
    _add_dropins(units, robot)
    units.files = list({id(file): file for file in _files(units) if file.source.judged}.values())
    return units


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
    by_folder: dict[tuple[str, str], list[tuple[Place, UnitFile]]] = {}
    dropins = [s for s in robot.of_kind("systemd-dropin") if final_name(s.basename).endswith(".conf")]
    for file in robot.parsed(parse, dropins):
        source = file.source
        place = place_of(source, folder=(source.robot_path or "").rpartition("/")[0])
        by_folder.setdefault((place.manager, file.name), []).append((place, file))
    for (manager, name), files in by_folder.items():
        if "." in name and not name.partition(".")[0].endswith(("-", "@")) and not units.candidates(name, manager):
            _add_extended(units, name, manager, files)
    known: set[int] = set()
    for unit in units.all:
        _extend(unit, by_folder, known, alone=len(units.candidates(unit.name, unit.manager)) == 1)
    units.loose = [file for files in by_folder.values() for _, file in files if id(file) not in known]


def _add_extended(units: Units, name: str, manager: str, files: list[tuple[Place, UnitFile]]) -> None:
    """A unit of the distribution that the tree only extends."""
    units.all.append(Unit(name, manager, place=files[0][0].root))
    units.__dict__.pop("_by_name", None)
    if not units.is_distribution_unit(name) and not GENERATED.search(name):
        units.orphans += [file for _, file in files]


def _extend(
    unit: Unit, by_folder: dict[tuple[str, str], list[tuple[Place, UnitFile]]], seen: set[int], alone: bool
) -> None:
    winners: dict[str, tuple[tuple[int, int], UnitFile]] = {}
    for specificity, folder in enumerate(dropin_folders(unit)):
        for place, file in by_folder.get((unit.manager, folder), ()):
            if place.root != unit.place and not (alone and folder == unit.name):
                continue
            seen.add(id(file))
            rank = (order(place), specificity)
            known = winners.get(file.source.basename)
            if known is None or rank < known[0]:
                winners[file.source.basename] = (rank, file)
    unit.dropins = [winners[name][1] for name in sorted(winners) if winners[name][1].source.link != "/dev/null"]
