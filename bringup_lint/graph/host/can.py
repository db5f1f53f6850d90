"""CAN interfaces: the files that configure them and the units that use them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.unit import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.units import Units

_CAN = regex(r"(?<![\w/.-])can\d+(?![\w/.-])")
_USE = regex(
    r"(?:socket)?can_?(?:interface|device|port|channel|bus|name)\w{0,64}[\"']?[ \t]*"
    r"(?::=|[:=])[ \t]*[\"']?(?P<name>can\d+)\b",
    re.I,
)
_SETS = regex(r"\bip\s+link\s+(?:set|add)\b[^\n]*\bcan\d*\b|\bbitrate\b|\bcan[-_]?(?:up|setup|config)\b", re.I)
_UP = regex(r"\bip\s+link\s+set\s+(?:dev\s+)?(?P<name>can\d+)\s+(?:up|type\s+can)\b")
_WAITS = regex(
    r"\b(?:until|while|for|sleep|slcand|slcan_attach|settle|wait-online)\b|\bip\s+link\s+add\b|\|\|"
    r"|\bmodprobe\s+(?!(?:kvaser_usb|gs_usb|peak_usb|pcan|usb_8dev|ems_usb|esd_usb|mcba_usb|can|can[-_]raw|can[-_]dev)\b)"
)
"""What waits for an interface, makes it, or loads a driver of a controller on the board."""
_NO_DEVICES = frozenset({"systemd-modules-load.service", "systemd-networkd.service"})
"""Services after which a CAN interface need not exist."""
_READERS = ("env-file", *LAUNCH, "params", "compose", "shell-script")


@dataclass(eq=False)
class CanFile:
    """A .network file with a [CAN] section."""

    file: UnitFile

    @property
    def header(self) -> Span:
        return next(section.header for section in self.file.sections if section.name == "CAN")

    def values(self, section: str, key: str) -> list[Located]:
        return [each.value for each in self.file.assignments if each.section == section and each.key == key]

    @property
    def matches(self) -> list[Located]:
        """The conditions of [Match]."""
        return [each.value for each in self.file.assignments if each.section == "Match" and each.value]

    @property
    def has_bit_rate(self) -> bool:
        return bool(self.values("CAN", "BitRate"))

    def is_of(self, name: str) -> bool:
        names = [word for value in self.values("Match", "Name") for word in value.split()]
        return not names or any(fnmatch(name, pattern) for pattern in names)


@dataclass(eq=False)
class Can:
    """Asked as ``robot.can``: who configures an interface, and who needs it."""

    sources: Files
    units: Units

    @cached_property
    def files(self) -> list[CanFile]:
        sources = [source for source in self.sources.of_kind("networkd") if source.name.endswith(".network")]
        models = self.sources.parsed(parse, [source for source in sources if not source.template])
        return [CanFile(file) for file in models if any(section.name == "CAN" for section in file.sections)]

    @cached_property
    def users(self) -> list[tuple[Unit, str, Located]]:
        """The services that name a CAN interface, with the word that does; those that set one up are none."""
        found: dict[tuple[Unit, str], tuple[Unit, str, Located]] = {}
        for unit in self.units.services:
            if _SETS.search("\n".join(_text(unit))):
                continue
            for value in [*unit.values("ExecStart", unit.section), *unit.values("Environment", unit.section)]:
                for match in _CAN.finditer(value):
                    found.setdefault((unit, match[0]), (unit, match[0], value.part(*match.span())))
        return list(found.values())

    def sets_up(self, unit: Unit, name: str, after: Iterable[str]) -> bool:
        """Whether a unit that this one waits for sets up the interface."""
        units = (other for word in after for other in self.units.candidates(str(word), unit.manager))
        return any(name in line and _SETS.search(line) for other in units for line in _text(other))

    @property
    def early_setups(self) -> Iterator[tuple[Unit, str, Located]]:
        """The services that set up an interface once at boot, whether it exists yet or not, with the command."""
        for unit in self.units.services:
            text = "\n".join(_text(unit))
            if not unit.judged or _WAITS.search(text) or not self._starts_once_at_boot(unit):
                continue
            for value in unit.values("ExecStart", unit.section):
                match = _UP.search(value)
                if match is not None:
                    yield unit, match["name"], value.part(*match.span())
                    break

    def _starts_once_at_boot(self, unit: Unit) -> bool:
        """Whether a target starts a unit that waits for no device and no other unit, and is not started again."""
        wanted = [*unit.words("WantedBy", "Install"), *unit.words("RequiredBy", "Install")]
        after = [*unit.words("After"), *unit.words("BindsTo"), *unit.words("Requires"), *unit.words("Wants")]
        waits = any(word.endswith((".device", ".service")) and word not in _NO_DEVICES for word in after)
        restarts = unit.get("Restart", unit.section) not in (None, "no")
        return not waits and not restarts and bool(wanted) and all(word.endswith(".target") for word in wanted)

    @property
    def unconfigured(self) -> Iterator[tuple[str, Located]]:
        """The interfaces that are used and not configured; only a whole root file system can tell."""
        if not self.sources.tree.complete or any(_SETS.search(text) for text in self._scripts()):
            return
        seen = set()
        for name, place in self._used():
            if name not in seen and not any(file.is_of(name) and file.has_bit_rate for file in self.files):
                seen.add(name)
                yield name, place

    def _scripts(self) -> Iterator[str]:
        yield from (source.text for source in self.sources.of_kind("shell-script"))
        yield from ("\n".join(_text(unit)) for unit in self.units.judged)

    def _used(self) -> Iterator[tuple[str, Located]]:
        for unit, name, place in self.users:
            if unit.judged:
                yield name, place
        for source in self.sources.of_kind(*_READERS):
            if not source.judged:
                continue
            for match in _USE.finditer(source.text):
                yield match["name"], source.located(*match.span("name"))


def _text(unit: Unit) -> Iterator[str]:
    """The lines of a unit that run something."""
    for key in ("ExecStartPre", "ExecStart", "ExecStartPost"):
        yield from map(str, unit.values(key, unit.section))
