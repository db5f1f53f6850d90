"""One line of a udev rules file as udevd sees it: what it can match and which links it makes."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.udev.conditions import Condition
from bringup_lint.graph.udev.conditions import Conditions
from bringup_lint.graph.udev.conditions import contradict
from bringup_lint.graph.udev.matched_devices import can_be_one
from bringup_lint.graph.udev.matched_devices import drives_nothing
from bringup_lint.graph.udev.matched_devices import is_open_by_design
from bringup_lint.graph.udev.matched_devices import is_tagged_by_systemd
from bringup_lint.graph.udev.matched_devices import levels
from bringup_lint.graph.udev.matched_devices import subsystem_of_name
from bringup_lint.graph.udev.matched_devices import usb_ids
from bringup_lint.model.udev import PARENT_KEYS
from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import RulesFile
from bringup_lint.model.udev import Token
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.udev_command import Command
from bringup_lint.parsers.udev_command import read_command
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

ACTIONS = ("add", "change", "bind", "unbind", "move", "online", "offline", "remove")
_SUBSTITUTION = regex(r"%%|\$\$|[%$](?:[a-z]+|[A-Z])?(?:\{[^}]{0,400}\})?")
_PLACEHOLDER = regex(r"\{\{(?:(?!\{\{|\}\}).)*\}\}|@\w+@")
STARTING = ("RUN", "PROGRAM", "IMPORT")
"""The keys that start a program."""
_HID = regex(r"(?:[0-9a-f]{4}:|\*:?)(?P<vendor>[0-9a-f]{4}):(?P<product>[0-9a-f]{4})(?:[.*]|$)")
"""The name of a HID device: its bus, vendor and product."""
_LOOKING = frozenset({"input", "video4linux", "iio", "media"})
"""Subsystems of devices that drive nothing."""
_OF_ONE = frozenset({"ATTR", "ATTRS", "KERNELS"})
"""Keys by which a rule names one of them."""
_ID = regex(r"[0-9a-f]{4}\Z")


class Link(NamedTuple):
    """One name below /dev that a rule gives."""

    name: Located
    """As written, relative to /dev unless it says /dev/ itself."""
    path: str
    """``/dev/robot/imu``; ``*`` stands for what udev puts in."""
    token: Token
    rule: UdevRule

    @property
    def is_fixed(self) -> bool:
        return "*" not in self.path


@dataclass(frozen=True, eq=False)
class UdevRule:
    """One line of a rules file that udev reads, with all that must hold for it to fire."""

    line: Rule
    file: RulesFile
    conditions: Conditions

    @property
    def source(self) -> Source:
        return self.file.source

    @property
    def judged(self) -> bool:
        return self.source.judged and not self.source.template and not self.line.dropped and self.conditions.known

    def on(self, key: str, attribute: str | None = None) -> tuple[Condition, ...]:
        """The conditions on a key, the rule's own and the inherited ones."""
        return tuple(
            condition
            for condition in self.conditions.positive
            if condition.key == key and attribute in (None, condition.attribute)
        )

    @property
    def subjects(self) -> set[tuple[str, str]]:
        """All that decides whether the rule fires: what its conditions and those of jumps over it compare."""
        jumps = (condition for jump in self.conditions.jumps for condition in jump)
        return {condition.subject for condition in (*self.conditions.positive, *jumps)}

    @cached_property
    def contradictions(self) -> tuple[tuple[Condition, Condition], ...]:
        """Pairs of conditions that no device fulfils both, the second one the rule's own."""
        found = []
        own = [condition for condition in self.conditions.positive if not condition.inherited]
        inherited = [condition for condition in self.conditions.positive if condition.inherited]
        for index, second in enumerate(own):
            for first in (*(one for one in inherited if one.key != "ENV"), *own[:index]):
                if contradict(first, second, one_rule=not first.inherited):
                    found.append((first, second))
        return tuple(found)

    def levels(self, token: Token) -> frozenset[str]:
        """The devices of the chain on which a parent key can hold; empty when unknown."""
        return levels(token) or frozenset()

    @staticmethod
    def is_any_number(pattern: str) -> bool:
        """Whether a kernel name is a known stem with any number: ``ttyUSB*``, ``video[0-9]*``."""
        return subsystem_of_name(pattern) is not None and pattern.endswith(("*", "[0-9]", "?"))

    @cached_property
    def is_unreachable(self) -> bool:
        """Whether a GOTO without conditions jumps over the rule."""
        return any(not jump for jump in self.conditions.jumps)

    @cached_property
    def kernels(self) -> tuple[str, ...]:
        """The patterns of the kernel name that may match; empty when any may."""
        found = [condition for condition in self.on("KERNEL") if condition.equal]
        return found[0].patterns if found else ()

    @cached_property
    def subsystems(self) -> frozenset[str]:
        """The subsystems of the devices for which the rule fires; empty when unknown."""
        named = [condition for condition in self.on("SUBSYSTEM") if condition.equal and condition.is_plain]
        if named:
            return frozenset.intersection(*(frozenset(condition.patterns) for condition in named))
        if any(condition.equal for name in ("idVendor", "idProduct") for condition in self.on("ATTR", name)):
            return frozenset({"usb"})
        found = [subsystem_of_name(pattern) for pattern in self.kernels]
        return frozenset(name for name in found if name) if found and all(found) else frozenset()

    def is_for(self, *subsystems: str) -> bool:
        """Whether the rule certainly fires only for devices of these subsystems."""
        return bool(self.subsystems) and self.subsystems <= set(subsystems)

    @cached_property
    def actions(self) -> tuple[str, ...]:
        wanted = self.on("ACTION")
        return tuple(action for action in ACTIONS if all(condition.accepts(action) for condition in wanted))

    @cached_property
    def usb_ids(self) -> tuple[str, ...]:
        """``vendor:product`` of the USB devices that the rule names exactly, in lower case."""
        vendors = self._usb_numbers("idVendor")
        return tuple(f"{vendor}:{product}" for vendor in vendors for product in self._usb_numbers("idProduct"))

    @property
    def usb_number(self) -> Located:
        """Where the rule names the product, or the first token when only a jump does."""
        for condition in self.conditions.positive:
            if condition.subject[1] == "idProduct" and not condition.inherited:
                return condition.token.value
        return self.line.tokens[0].value

    def _usb_numbers(self, attribute: str) -> tuple[str, ...]:
        for condition in self.conditions.positive:
            if condition.equal and condition.subject[1] == attribute:
                return tuple(found for one in condition.patterns if _ID.match(found := one.lower()))
        return ()

    @cached_property
    def links(self) -> tuple[Link, ...]:
        return tuple(
            Link(name, _path(name), token, self)
            for token in self.line.assignments("SYMLINK")
            if token.operator != "-="
            for name in self._link_names(token)
        )

    def _link_names(self, token: Token) -> Iterable[Located]:
        options = [option.value for option in self.line.assignments("OPTIONS")]
        return [token.value] if "string_escape=replace" in options else token.value.words()

    @property
    def usb_device(self) -> dict[str, str] | None:
        """What is known of the one USB device that the rule names; None when unknown or several."""
        return usb_ids().get(self.usb_ids[0]) if len(self.usb_ids) == 1 else None

    @property
    def swapped_usb_id(self) -> tuple[Token, Token] | None:
        """The tokens for vendor and product when only the other way round they name a known device."""
        tokens = {str(token.attribute): token for token in self.line.matches("ATTRS") if token.operator == "=="}
        vendor, product = tokens.get("idVendor"), tokens.get("idProduct")
        if vendor is None or product is None:
            return None
        known = usb_ids()
        here, swapped = f"{vendor.value}:{product.value}", f"{product.value}:{vendor.value}"
        return (vendor, product) if swapped in known and here not in known else None

    @cached_property
    def never_matches(self) -> bool:
        """Whether the rule certainly fires for no device, so that what it sets does not matter."""
        return self.swapped_usb_id is not None or self.impossible_parents is not None

    @property
    def generic_products(self) -> list[str]:
        """Names of those devices whose id says nothing of what is behind it, such as bridge chips."""
        known = ((one, usb_ids().get(one)) for one in self.usb_ids)
        return [row["product"] for one, row in known if row and (row["generic"] == "yes" or one.startswith("2341:"))]

    @property
    def is_serial(self) -> bool:
        """Whether the rule is about serial ports, by its subsystem, kernel name or USB id."""
        if self.subsystems:
            return self.is_for("tty")
        return bool(self.usb_device and self.usb_device["device"] in ("ttyUSB", "ttyACM"))

    @property
    def has_priority(self) -> bool:
        """Whether the rule says who wins when several devices have its link."""
        return any(option.value.startswith("link_priority=") for option in self.line.assignments("OPTIONS"))

    @property
    def parent_conditions(self) -> tuple[Condition, ...]:
        """The rule's own conditions on one device of the chain."""
        own = (one for one in self.conditions.positive if not one.inherited)
        return tuple(one for one in own if one.key in PARENT_KEYS)

    @property
    def serials(self) -> tuple[Condition, ...]:
        """The conditions on the serial number of a USB parent."""
        return tuple(one for one in self.conditions.positive if one.subject == ("ATTRS", "serial") and one.equal)

    @property
    def is_for_usb_nodes(self) -> bool:
        """Whether the rule names USB devices by their parents only, and none that is known for its serial port: what
        it means is the node below /dev/bus/usb."""
        parents = {condition.key for condition in self.parent_conditions}
        named = self.usb_ids or any(one.subject == ("ATTRS", "idVendor") for one in self.conditions.positive)
        others = self.on("KERNEL") or self.on("SUBSYSTEM") or self.on("DRIVER") or self.on("ATTR")
        serial = self.usb_device is not None and self.usb_device["device"].startswith("tty")
        return bool(parents and named) and not others and not serial

    @property
    def is_open_by_design(self) -> bool:
        """Whether all nodes that the rule names are meant to be writable for everybody."""
        static = [
            option.value[12:] for option in self.line.assignments("OPTIONS") if option.value.startswith("static_node=")
        ]
        names = [*self.kernels, *(name.rpartition("/")[2] for name in static)]
        return bool(names) and all(is_open_by_design(name) for name in names)

    @property
    def drives_nothing(self) -> bool:
        """Whether the rule names nothing but debug probes, programmers and the like, cameras and game pads, each by its
        numbers or as one device of its subsystem, and not their serial ports."""
        if self.is_serial or self.usb_ids:
            return not self.is_serial and all(map(drives_nothing, self.usb_ids))
        hid = [found for pattern in self._parents if (found := _HID.match(pattern.lower()))]
        if hid:
            return all(drives_nothing(f"{each['vendor']}:{each['product']}") for each in hid)
        named = self.subsystems | {name for each in self._parents_of("SUBSYSTEMS") for name in each.patterns}
        return bool(named) and named <= _LOOKING and any(each.key in _OF_ONE for each in self.conditions.positive)

    @property
    def _parents(self) -> Iterator[str]:
        yield from (pattern for each in self._parents_of("KERNELS") for pattern in each.patterns)

    def _parents_of(self, key: str) -> list[Condition]:
        """What the rule asks of the devices above by one key."""
        return [each for each in self.conditions.positive if each.key == key and each.equal]

    def is_tagged_by_systemd(self, systemd: int) -> bool | None:
        """Whether 99-systemd.rules makes device units of them; None when the subsystem is unknown."""
        if not self.subsystems:
            return None
        return any(is_tagged_by_systemd(one, self.kernels, systemd) for one in self.subsystems)

    @property
    def commands(self) -> list[Command]:
        """The programs that the rule starts: RUN, PROGRAM and IMPORT{program}."""
        if self.line.by_key.keys().isdisjoint(STARTING):
            return []
        tokens = (token for token in self.line.tokens if token.attribute in (None, "program"))
        return [read_command(token) for token in tokens if token.key in STARTING and token.value]

    @cached_property
    def impossible_parents(self) -> tuple[Token, Token] | None:
        """Two parent keys that no one device of a chain fulfils, so that the rule never fires."""
        known = [(token, found) for token in self.line.tokens if token.key in PARENT_KEYS and (found := levels(token))]
        for index, (token, on) in enumerate(known):
            for other, other_on in known[:index]:
                if not can_be_one(on, other_on):
                    return other, token
        return None

    def without(self, token: Token) -> list[tuple[Span, str]]:
        """The edit that deletes a token with the delimiter on one side of it."""
        tokens = self.line.tokens
        index = tokens.index(token)
        start, end = token.span.start, token.span.end
        text = self.source.text
        if index + 1 < len(tokens) and "\n" not in text[end : tokens[index + 1].span.start]:
            end = tokens[index + 1].span.start
        elif index and "\n" not in text[tokens[index - 1].span.end : start]:
            start = tokens[index - 1].span.end
        return [(Span(self.source, start, end), "")]

    def after(self, text: str) -> tuple[Span, str]:
        """The edit that puts a new token at the end of the line."""
        end = self.line.tokens[-1].span.end
        return Span(self.source, end, end), f", {text}"

    def before(self, token: Token, text: str) -> tuple[Span, str]:
        """The edit that puts a new token before one of the line."""
        return Span(self.source, token.span.start, token.span.start), f"{text}, "


def _path(name: str) -> str:
    text = _SUBSTITUTION.sub(
        lambda found: found[0][0] if found[0] in ("%%", "$$") else "*", _PLACEHOLDER.sub("*", name)
    )
    return "/dev/" + text.removeprefix("/dev/").lstrip("/")
