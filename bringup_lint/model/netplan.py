"""Netplan: what a file says, and the interfaces that several files make together."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from functools import cached_property

from bringup_lint import addresses
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Remark
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

PHYSICAL = frozenset(("ethernets", "wifis", "modems", "nm-devices"))
BOOLEANS = {
    **dict.fromkeys(("true", "on", "yes", "y"), True),
    **dict.fromkeys(("false", "off", "no", "n"), False),
}
GLOBS = frozenset("*?[]!")


class PlanCode(str, Enum):
    """What netplan refuses although every key and value is well formed."""

    SET_NAME = "set-name"
    ROUTE = "route"
    ROUTE_FAMILIES = "route-families"
    DUPLICATE_SSID = "duplicate-ssid"
    NO_ACCESS_POINT = "no-access-point"
    INCOMPLETE = "incomplete"
    VLAN_NO_ID = "vlan-no-id"
    VLAN_ID = "vlan-id"
    VLAN_LINK = "vlan-link"
    SECRET = "secret"
    TWO_MASTERS = "two-masters"
    TYPE_CHANGED = "type-changed"
    UNDEFINED = "undefined"
    PASSPHRASE = "passphrase"
    DIFFERENT_OVERRIDES = "different-overrides"
    NETWORKD_LACKS = "networkd-lacks"
    NETWORK_MANAGER_LACKS = "networkmanager-lacks"

    def __str__(self) -> str:
        return self.value


@dataclass(eq=False, slots=True)
class Definition:
    """One entry below a device type, as one file writes it."""

    kind: str
    """The device type: ``ethernets``, ``wifis``, ``vlans``, ..."""
    name: Located
    body: Mapping
    renderer: Located | None = None
    """The ``renderer:`` that is before it directly below the device type."""


@dataclass(eq=False, slots=True)
class NetplanFile:
    source: Source
    yaml: YamlFile
    definitions: list[Definition] = field(default_factory=list)
    ports: list[Located] = field(default_factory=list)
    """Open vSwitch patch ports, which count as definitions."""
    renderer: Located | None = None
    version: Located | None = None
    problems: list[Problem] = field(default_factory=list)
    newer: list[Problem] = field(default_factory=list)
    """Keys and values that netplan 0.104 does not know; the detail is the first release that does."""
    embedded: bool = False
    """The ``network:`` of a cloud-init configuration, which need not be the only key."""


@dataclass(eq=False)
class Flag:
    value: bool
    where: Located


@dataclass(eq=False)
class Address:
    """``text`` is ``10.0.0.10/24``; ``ip`` is None when it cannot be read."""

    text: Located

    @cached_property
    def ip(self) -> addresses.Interface | None:
        return addresses.parse_interface(self.text)


@dataclass(eq=False)
class Route:
    body: Mapping

    def value(self, key: str) -> Located | None:
        scalar = _last_scalar(self.body, key)
        return scalar.value if scalar else None

    def number(self, key: str) -> int | None:
        text = self.value(key)
        return int(text) if text is not None and text.isdecimal() else None

    @property
    def where(self) -> Located | Span:
        return self.value("to") or self.body.span

    @property
    def is_default(self) -> bool:
        to = self.value("to")
        return to is not None and (to == "default" or to.endswith("/0"))

    @property
    def type(self) -> str:
        return str(self.value("type") or "unicast").lower()

    @property
    def families(self) -> Iterator[int]:
        """4 or 6 for each of ``to``, ``via`` and ``from`` that says it."""
        for key in ("to", "via", "from"):
            text = self.value(key)
            if text is not None and text != "default":
                yield 6 if ":" in text else 4

    @property
    def family(self) -> int | None:
        """The first of the families; None when nothing says it."""
        return next(self.families, None)


@dataclass(eq=False)
class AccessPoint:
    ssid: Located
    body: Mapping

    @property
    def mode(self) -> Located | None:
        scalar = _last_scalar(self.body, "mode")
        return scalar.value if scalar else None

    @property
    def password(self) -> Scalar | None:
        return _last_scalar(self.body, "password")

    @property
    def auth(self) -> Mapping | None:
        found = [value for key, value in self.body.entries if key.value == "auth"]
        return found[-1] if found and isinstance(found[-1], Mapping) else None

    @property
    def key_management(self) -> Located | None:
        scalar = _last_scalar(self.auth, "key-management") if self.auth else None
        return scalar.value if scalar else None

    @property
    def passwords(self) -> Iterator[Located]:
        """The passphrase, and the password of 802.1X."""
        for body in filter(None, (self.body, self.auth)):
            if (password := _last_scalar(body, "password")) is not None:
                yield password.value

    @property
    def is_passed_through(self) -> bool:
        """NetworkManager gets settings that netplan does not look into."""
        return any(key.value == "networkmanager" for key, _ in self.body.entries)

    @property
    def is_open(self) -> bool:
        if self.password is not None:
            return False
        return self.auth is None or self.key_management == "none"


@dataclass(eq=False)
class Match:
    name: Located | None = None
    macaddress: Located | None = None
    driver: Located | None = None


@dataclass(eq=False)
class Interface:
    """One interface, merged from every file that writes it: the last scalar wins, sequences add up."""

    kind: str
    definitions: list[Definition]
    renderer: Located | None = None
    """Where its renderer is chosen; None stands for the default, networkd."""

    @property
    def name(self) -> Located:
        """The netplan id, where it was first written."""
        return self.definitions[0].name

    @property
    def backend(self) -> str:
        return str(self.renderer) if self.renderer else "networkd"

    @property
    def is_physical(self) -> bool:
        return self.kind in PHYSICAL

    @property
    def is_wifi(self) -> bool:
        return self.kind == "wifis"

    def entries(self, *path: str) -> Iterator[tuple[Scalar, Node]]:
        """Every pair at this path, in the order in which netplan reads them."""
        for definition in self.definitions:
            yield from _entries(definition.body, path)

    def scalar(self, *path: str) -> Scalar | None:
        """The scalar that wins."""
        found = None
        for _, value in self.entries(*path):
            if isinstance(value, Scalar):
                found = value
        return found

    def key(self, *path: str) -> Located | None:
        """The key that wins."""
        found = [key for key, _ in self.entries(*path)]
        return found[-1].value if found else None

    def value(self, *path: str) -> Located | None:
        scalar = self.scalar(*path)
        return scalar.value if scalar else None

    def number(self, *path: str) -> int | None:
        text = self.value(*path)
        return int(text) if text is not None and text.isdecimal() else None

    def flag(self, *path: str) -> Flag | None:
        """The boolean that wins, None when it is not set or no boolean."""
        text = self.value(*path)
        truth = BOOLEANS.get(text.lower()) if text is not None else None
        return None if text is None or truth is None else Flag(truth, text)

    def items(self, *path: str) -> Iterator[Node]:
        """The items of every sequence at this path."""
        for _, value in self.entries(*path):
            if isinstance(value, Sequence):
                yield from value.items

    def is_on(self, *path: str) -> bool:
        flag = self.flag(*path)
        return flag is not None and flag.value

    @cached_property
    def addresses(self) -> list[Address]:
        """The static addresses; one that is written twice counts once."""
        found: dict[str, Address] = {}
        for item in self.items("addresses"):
            scalar = item.pairs[0][0] if isinstance(item, Mapping) and item.pairs else item
            if isinstance(scalar, Scalar):
                found.setdefault(str(scalar.value), Address(scalar.value))
        return list(found.values())

    @cached_property
    def nameservers(self) -> list[Located]:
        return [item.value for item in self.items("nameservers", "addresses") if isinstance(item, Scalar)]

    @cached_property
    def routes(self) -> list[Route]:
        return [Route(item) for item in self.items("routes") if isinstance(item, Mapping)]

    @cached_property
    def access_points(self) -> list[AccessPoint]:
        found: dict[str, AccessPoint] = {}
        for _, value in self.entries("access-points"):
            if isinstance(value, Mapping):
                for key, body in value.entries:
                    if isinstance(body, Mapping):
                        found[str(key.value)] = AccessPoint(key.value, body)
        return list(found.values())

    @cached_property
    def members(self) -> list[Located]:
        """What a bridge, bond or VRF takes in."""
        return [item.value for item in self.items("interfaces") if isinstance(item, Scalar)]

    @property
    def link(self) -> Located | None:
        return self.value("link")

    @property
    def dhcp4(self) -> bool:
        return self.is_on("dhcp4")

    @property
    def dhcp6(self) -> bool:
        return self.is_on("dhcp6")

    @property
    def optional(self) -> Flag | None:
        return self.flag("optional")

    @cached_property
    def match(self) -> Match | None:
        if not any(True for _ in self.entries("match")):
            return None
        return Match(self.value("match", "name"), self.value("match", "macaddress"), self.value("match", "driver"))

    @property
    def set_name(self) -> Located | None:
        return self.value("set-name")

    @property
    def device(self) -> Located | None:
        """The name that the kernel will show, where netplan fixes it; None when only a match tells."""
        if not self.is_physical:
            return self.name
        if self.set_name:
            return self.set_name
        if self.match is None:
            return self.name
        name = self.match.name
        return name if name is not None and not GLOBS & set(name) else None

    @property
    def passwords(self) -> Iterator[Located]:
        """Wi-Fi and 802.1X passwords, as written."""
        for point in self.access_points:
            yield from point.passwords
        for key in ("password", "client-key-password"):
            if (password := self.value("auth", key)) is not None:
                yield password

    @property
    def secrets(self) -> Iterator[Located]:
        """Passwords and private keys."""
        yield from self.passwords
        for path in (("key",), ("keys", "private"), ("password",), ("pin",)):
            if (secret := self.value(*path)) is not None and not secret.startswith("/"):
                yield secret

    @property
    def is_configured(self) -> bool:
        """It gets an address by itself: static or DHCP."""
        return bool(self.addresses) or self.dhcp4 or self.dhcp6


class DefaultRoute(NamedTuple):
    interface: Interface
    family: int
    table: str
    metric: int | None
    where: Located | Span


def root_of(source: Source) -> str | None:
    """The folder above the path on the robot, where a file's path shows it."""
    path = source.robot_path
    return source.name.removesuffix(path.lstrip("/")) if path and source.name.endswith(path.lstrip("/")) else None


@dataclass(eq=False)
class Plan:
    """The files that netplan reads together on one robot, in its order."""

    files: list[NetplanFile]
    interfaces: dict[str, Interface] = field(default_factory=dict)
    renderer: Located | None = None
    problems: list[Problem] = field(default_factory=list)
    whole: bool = False
    """The files lie in netplan's own folders; else the plan is one file that may have companions."""

    @cached_property
    def roots(self) -> set[str | None]:
        """The folders that hold a root file system with files of the plan; None for files outside of one."""
        return {root_of(file.source) for file in self.files}

    @cached_property
    def has_templates(self) -> bool:
        return any(file.source.template for file in self.files)

    @cached_property
    def devices(self) -> dict[str, Interface]:
        """The interfaces by the names that the kernel will show, where these are known; the first of each."""
        known = [(str(each.device), each) for each in self.interfaces.values() if each.device is not None]
        return dict(reversed(known))

    @cached_property
    def matched(self) -> list[Interface]:
        """The interfaces of which only a match tells the device."""
        return [each for each in self.interfaces.values() if each.is_physical and each.device is None]

    @cached_property
    def by_address(self) -> dict[str, Interface]:
        """Static address, without its prefix length -> the first interface that has it."""
        found: dict[str, Interface] = {}
        for interface in self.interfaces.values():
            for address in interface.addresses:
                if address.ip is not None:
                    found.setdefault(str(address.ip.ip), interface)
        return found

    @cached_property
    def by_name_or_address(self) -> dict[str, Interface]:
        """The first interface that has the device or the static address."""
        order = {id(interface): number for number, interface in enumerate(self.interfaces.values())}
        found = dict(self.by_address)
        for name, interface in self.devices.items():
            if name not in found or order[id(interface)] < order[id(found[name])]:
                found[name] = interface
        return found

    @cached_property
    def is_dynamic(self) -> bool:
        """Whether an interface gets addresses by DHCP."""
        return any(interface.dhcp4 or interface.dhcp6 for interface in self.interfaces.values())

    @cached_property
    def masters(self) -> dict[str, Interface]:
        """The bridge, bond or VRF of every member."""
        return {str(member): owner for owner in self.interfaces.values() for member in owner.members}

    @property
    def is_waited_for(self) -> bool:
        """networkd renders every interface, so that its wait-online decides when the network is there."""
        return bool(self.interfaces) and all(i.backend == "networkd" for i in self.interfaces.values())

    @property
    def default_routes(self) -> Iterator[DefaultRoute]:
        """The static default routes; those whose family cannot be told are left out."""
        for interface in self.interfaces.values():
            for version in (4, 6):
                if (gateway := interface.value(f"gateway{version}")) is not None:
                    yield DefaultRoute(interface, version, "main", None, gateway)
            for route in interface.routes:
                if route.is_default and (family := route.family) is not None:
                    written = route.value("table")
                    table = "main" if written in (None, "254") else str(written)
                    yield DefaultRoute(interface, family, table, route.number("metric"), route.where)


@dataclass(eq=False)
class Netplan:
    plans: list[Plan] = field(default_factory=list)
    shadowed: list[tuple[NetplanFile, NetplanFile]] = field(default_factory=list)
    """Files that are never read, each with the file of the same name that hides it."""
    unread: list[Source] = field(default_factory=list)
    """Files in netplan's folders whose name does not end in ``.yaml``."""

    @property
    def files(self) -> Iterator[NetplanFile]:
        for plan in self.plans:
            yield from plan.files

    @property
    def only_plan(self) -> Plan | None:
        """The plan, when the tree has exactly one: only then can other files be joined to it."""
        return self.plans[0] if len(self.plans) == 1 else None

    @property
    def interfaces(self) -> Iterator[Interface]:
        for plan in self.plans:
            yield from plan.interfaces.values()

    def problems(self, *codes: str) -> Iterator[Problem]:
        """What netplan would refuse, by code; templates, whose text is not final, say nothing."""
        for plan in self.plans:
            final = [file for file in plan.files if not file.source.template]
            found = [problem for file in final for problem in file.problems] + plan.problems
            yield from (problem for problem in found if problem.code in codes)

    def remarks(self, *codes: str) -> Iterator[Remark]:
        """Those of the problems that are about an item of the schema, such as an unknown key inside it."""
        return (problem for problem in self.problems(*codes) if isinstance(problem, Remark))

    def declarations(self, name: str) -> Iterator[Located]:
        """Every place that defines a name."""
        definitions = (d for interface in self.interfaces for d in interface.definitions)
        return (definition.name for definition in definitions if definition.name == name)

    def named(self, device: str) -> Iterator[Interface]:
        """The interfaces whose device certainly has this name."""
        return (interface for interface in self.interfaces if interface.device == device)


def _entries(body: Mapping, path: tuple[str, ...]) -> Iterator[tuple[Scalar, Node]]:
    for key, value in body.entries:
        if key.value != path[0]:
            continue
        if len(path) == 1:
            yield key, value
        elif isinstance(value, Mapping):
            yield from _entries(value, path[1:])


def _last_scalar(body: Mapping, name: str) -> Scalar | None:
    found = [value for key, value in body.entries if key.value == name and isinstance(value, Scalar)]
    return found[-1] if found else None
