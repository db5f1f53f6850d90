"""udev rules as udevd applies them: which files count, in which order, and the links that they make."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.facts import table
from bringup_lint.graph.memo import memo
from bringup_lint.graph.udev.conditions import all_conditions
from bringup_lint.graph.udev.matched_devices import subsystem_of_name
from bringup_lint.graph.udev.matched_devices import usb_ids
from bringup_lint.graph.udev.order import TooEarly
from bringup_lint.graph.udev.order import assignments_overruled
from bringup_lint.graph.udev.order import packaged_files
from bringup_lint.graph.udev.order import properties_not_set_yet
from bringup_lint.graph.udev.overlap import are_nodes_of_one_camera
from bringup_lint.graph.udev.overlap import fires_whenever
from bringup_lint.graph.udev.overlap import may_both_fire
from bringup_lint.graph.udev.patterns import matches
from bringup_lint.graph.udev.rule import Link
from bringup_lint.graph.udev.rule import UdevRule
from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import RulesFile
from bringup_lint.model.udev import Token
from bringup_lint.parsers.udev import parse
from bringup_lint.source import Problem
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

DIRECTORIES = (
    "/etc/udev/rules.d",
    "/run/udev/rules.d",
    "/usr/local/lib/udev/rules.d",
    "/usr/lib/udev/rules.d",
    "/lib/udev/rules.d",
)
"""Highest precedence first (udev(7))."""

_MOST_RIVALS = 50
"""How many rules for one link, tag or property are compared with one another."""


@dataclass(frozen=True, eq=False)
class RuleSet:
    """The rules files that one udevd reads together, in effective order."""

    files: tuple[RulesFile, ...]
    shadowed: tuple[tuple[RulesFile, RulesFile], ...] = ()
    """Files that are not read, each with the one of the same name that replaces it."""

    @cached_property
    def rules(self) -> tuple[UdevRule, ...]:
        return tuple(
            UdevRule(line, file, conditions)
            for file in self.files
            for line, conditions in zip(file.rules, all_conditions(file.rules), strict=True)
        )

    @cached_property
    def links(self) -> tuple[Link, ...]:
        return tuple(link for rule in self.rules if not rule.line.dropped for link in rule.links)

    @cached_property
    def same_links(self) -> list[tuple[Link, Link]]:
        """Pairs of one link from two rules that can take it from one another, in effective order."""
        return [(one, other) for one, other in self._of_one_name if self._compete(one.rule, other.rule)]

    @cached_property
    def same_camera_links(self) -> list[tuple[Link, Link]]:
        """Pairs of one link from two rules for two nodes of the same camera, in effective order."""
        return [(one, other) for one, other in self._of_one_name if are_nodes_of_one_camera(one.rule, other.rule)]

    @cached_property
    def _of_one_name(self) -> list[tuple[Link, Link]]:
        by_path: dict[str, list[Link]] = defaultdict(list)
        for link in self.links:
            if link.is_fixed and not link.rule.is_unreachable:
                by_path[link.path].append(link)
        return [
            (one, other)
            for links in by_path.values()
            for index, other in enumerate(links[:_MOST_RIVALS])
            for one in links[:index]
        ]

    def _compete(self, one: UdevRule, other: UdevRule) -> bool:
        if one.line is other.line or one.has_priority or other.has_priority or "block" in one.subsystems:
            return False
        if one.file is not other.file and not self.is_installed:
            return False
        if fires_whenever(one, other) and fires_whenever(other, one):
            return False
        return may_both_fire(one, other, self.assigned_properties)

    @property
    def is_installed(self) -> bool:
        """Whether the files lie in folders that udev reads, so that they certainly work together."""
        return all(_directory(file.source) in DIRECTORIES for file in self.files)

    def sets_beside(self, rule: UdevRule, key: str, *names: str) -> bool:
        """Whether a rule that may fire for the same device assigns ENV{one of the names} or TAG="one"."""
        others = [other for name in names for other in self._assigning.get((key, name), ())]
        return len(others) > _MOST_RIVALS or any(may_both_fire(rule, other) for other in others)

    @cached_property
    def _assigning(self) -> dict[tuple[str, str], list[UdevRule]]:
        """The rules that assign a tag or property, by key and name."""
        found: dict[tuple[str, str], list[UdevRule]] = defaultdict(list)
        for rule in self.rules:
            for token in (*rule.line.assignments("TAG"), *rule.line.assignments("ENV")):
                found[token.key, token.value if token.attribute is None else token.attribute].append(rule)
        return found

    @cached_property
    def brltty_claims(self) -> tuple[tuple[Token, Rule], ...]:
        """Lines of brltty's rules that take devices by their id alone, with the match on the id."""
        lines = (rule.line for rule in self.rules if "brltty" in rule.source.basename)
        found = []
        for line in lines:
            own = [token for token in line.tokens if token.is_match]
            if all(token.key in ("SUBSYSTEM", "ACTION", "ENV") for token in own):
                ids = [token for token in own if token.name == "ENV{PRODUCT}" and token.operator == "=="]
                found += [(token, line) for token in ids[:1]]
        return tuple(found)

    @cached_property
    def assigned_properties(self) -> frozenset[str]:
        """The ENV names that some rule sets."""
        tokens = (token for rule in self.rules for token in rule.line.assignments("ENV"))
        return frozenset(str(token.attribute) for token in tokens)


@dataclass(frozen=True, eq=False)
class Udev:
    """All udev rules of a tree."""

    sets: tuple[RuleSet, ...]

    @cached_property
    def files(self) -> tuple[RulesFile, ...]:
        return tuple(file for one in self.sets for file in one.files)

    @cached_property
    def rules(self) -> tuple[UdevRule, ...]:
        return tuple(rule for one in self.sets for rule in one.rules)

    @cached_property
    def judged(self) -> tuple[UdevRule, ...]:
        return tuple(rule for rule in self.rules if rule.judged and not rule.is_unreachable)

    @property
    def matching(self) -> Iterator[UdevRule]:
        """The judged rules that may fire for a device."""
        return (rule for rule in self.judged if not rule.never_matches)

    def problems(self, *codes: str) -> Iterator[tuple[Problem, Rule]]:
        """What the parser could not accept in the files that are judged, with the line it belongs to."""
        for file in self.files:
            if file.source.judged:
                for index, problem in enumerate(file.problems):
                    if problem.code in codes:
                        yield problem, file.owners[index]

    @cached_property
    def links(self) -> tuple[Link, ...]:
        return tuple(link for one in self.sets for link in one.links)

    def survives_change(self, link: Link) -> bool:
        """Whether another rule makes the same link at a change event."""
        return any("change" in other.rule.actions for other in self._fixed_links.get(link.path, ()) if other != link)

    @staticmethod
    def is_factory_serial(serial: str) -> bool:
        """Whether many adapters have this serial number."""
        return any(row["serial"] == serial for row in table("udev/factory_serials"))

    def brltty_claim(self, rule: UdevRule, usb_id: str) -> Rule | None:
        """The line of brltty's rules that takes every device of this id."""
        vendor, product = (number.lstrip("0") for number in usb_id.split(":"))
        for token, line in self.set_of(rule).brltty_claims:
            if any(matches(one, f"{vendor}/{product}/264") for one in token.alternatives):
                return line
        return None

    @staticmethod
    def is_claimed_on_jammy(usb_id: str) -> bool:
        """Whether brltty of Ubuntu 22.04 takes every device of this id."""
        return usb_ids().get(usb_id, {}).get("brltty") == "yes"

    def set_of(self, rule: UdevRule) -> RuleSet:
        """The rules files that udevd reads together with the rule's."""
        return self._set_of_file[rule.file]

    @cached_property
    def _set_of_file(self) -> dict[RulesFile, RuleSet]:
        return {file: one for one in self.sets for file in one.files}

    @property
    def too_early(self) -> Iterator[tuple[UdevRule, TooEarly]]:
        """Tokens whose file sorts before the packaged one that they depend on, or that overrules them."""
        importing: RulesFile | None = None
        for rule in self.judged:
            if rule.line.first("IMPORT") is not None:
                importing = rule.file
            if importing is not rule.file:
                yield from ((rule, found) for found in properties_not_set_yet(rule))
            yield from ((rule, found) for found in assignments_overruled(rule))

    @property
    def open_to_all(self) -> Iterator[tuple[UdevRule, Token]]:
        """MODE tokens that let everybody write to a node that is not open by design, and that count in the end."""
        for rule in self.matching:
            if rule.is_open_by_design:
                continue
            overruled = {found.token for found in assignments_overruled(rule)}
            for token in rule.line.assignments("MODE"):
                octal = re.fullmatch(r"0*[0-7]{1,4}", token.value)
                if octal and int(token.value, 8) & 0o002 and token not in overruled:
                    yield rule, token

    @property
    def replacing(self) -> Iterator[tuple[RulesFile, Source | None, str]]:
        """Files that replace one of the distribution by their name, with that file or its package."""
        for one in self.sets:
            hidden = {winner.source.name: loser.source for loser, winner in one.shadowed}
            for file in one.files:
                loser = hidden.get(file.source.name)
                package = packaged_files().get(file.source.basename, "")
                own = _directory(file.source) in DIRECTORIES[:3]
                if file.rules and own and (loser is not None or package):
                    yield file, loser, package

    @cached_property
    def _fixed_links(self) -> dict[str, list[Link]]:
        found: dict[str, list[Link]] = defaultdict(list)
        for link in self.links:
            if link.is_fixed:
                found[link.path].append(link)
        return found

    def links_to(self, path: str) -> list[Link]:
        """The links that are, or could be, this path below /dev."""
        return self._fixed_links.get(path) or [link for link in self._open_links if matches(link.path, path)]

    @cached_property
    def _open_links(self) -> tuple[Link, ...]:
        return tuple(link for link in self.links if not link.is_fixed)

    @memo
    def stable_names(self, path: str) -> list[Link]:
        """The links that may mean the device now found as ``/dev/ttyUSB0``, each once, in effective order."""
        name = path.removeprefix("/dev/")
        subsystem = subsystem_of_name(name)
        found: dict[str, Link] = {}
        for link in self.links:
            rule = link.rule
            named = all(condition.accepts(name) for condition in rule.on("KERNEL"))
            if link.is_fixed and named and subsystem and rule.is_for(subsystem):
                found.setdefault(link.path, link)
        return list(found.values())


def effective(files: Iterable[RulesFile]) -> Udev:
    """Group the files that belong to one system, drop the shadowed ones, sort the rest by file name."""
    groups: dict[str, list[RulesFile]] = defaultdict(list)
    for file in files:
        groups[_system_of(file.source)].append(file)
    return Udev(tuple(_rule_set(members) for members in groups.values()))


def _rule_set(files: list[RulesFile]) -> RuleSet:
    chosen: dict[str, RulesFile] = {}
    shadowed: list[tuple[RulesFile, RulesFile]] = []
    for file in sorted(files, key=lambda one: _rank(one.source)):
        name = file.source.basename
        if name in chosen:
            shadowed.append((file, chosen[name]))
        else:
            chosen[name] = file
    return RuleSet(tuple(chosen[name] for name in sorted(chosen)), tuple(shadowed))


def _directory(source: Source) -> str:
    return (source.robot_path or "").rpartition("/")[0]


def _rank(source: Source) -> int:
    directory = _directory(source)
    return DIRECTORIES.index(directory) if directory in DIRECTORIES else len(DIRECTORIES)


def _system_of(source: Source) -> str:
    """A root file system has one udevd; elsewhere the files of one folder belong together."""
    if _directory(source) in DIRECTORIES and source.robot_path and source.name.endswith(source.robot_path.lstrip("/")):
        return source.name[: -len(source.robot_path.lstrip("/"))] + "/"
    return source.name.rpartition("/")[0]


def load_udev(files: Files) -> Udev:
    """The rules of all files that the tree holds."""
    return effective(files.parsed(parse, files.of_kind("udev-rules")))
