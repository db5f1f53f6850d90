"""An Ansible inventory in YAML: its hosts are robots. Where their files lie, variables say: ``bringup_lint_root``,
``bringup_lint_overlays``, ``bringup_lint_role``, ``bringup_lint_site`` and ``bringup_lint_domain``, in the inventory or
in ``host_vars/`` and ``group_vars/`` beside it.

Which variable counts is as in Ansible's "Variable precedence" and "How variables are merged"; ansible-inventory --list
shows the same. Of templates, only ``{{ inventory_hostname }}`` is filled in.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cache

from bringup_lint.config import ConfigError
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.fleet.delivered import Files
from bringup_lint.fleet.delivered import delivered
from bringup_lint.fleet.members import ROLE
from bringup_lint.fleet.members import Inventory
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.members import refusal
from bringup_lint.fleet.members import text_of
from bringup_lint.fleet.plays import for_host
from bringup_lint.fleet.plays import scalars
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_PREFIX = "bringup_lint_"
_NAMES = ("root", "overlays", "role", "site", "domain")
_PRIORITY = "ansible_group_priority"
_ALL = "all"
_DEPTH = 20
_MOST = 1_000_000
"""Hosts that an inventory may name."""
_ENDINGS = ("", ".yml", ".yaml", ".json")
_RANGE = regex(r"\[(?P<first>\d+|[a-zA-Z]):(?P<last>\d+|[a-zA-Z])(?::(?P<step>\d+))?\]")
Variables = dict[str, Node]


@dataclass
class Group:
    """A group of an inventory, which may speak of it at several places."""

    variables: Variables = field(default_factory=dict)
    parents: set[str] = field(default_factory=set)
    priority: int = 1


@dataclass
class Hosts:
    """What an inventory says, before its variables are merged."""

    path: str
    groups: dict[str, Group] = field(default_factory=dict)
    variables: dict[str, Variables] = field(default_factory=dict)
    """By host."""
    members: dict[str, set[str]] = field(default_factory=dict)
    """Host -> the groups that list it."""
    _depths: dict[tuple[str, int], int] = field(default_factory=dict)
    _around: dict[frozenset[str], list[str]] = field(default_factory=dict)

    def depth(self, name: str, left: int = _DEPTH) -> int:
        """How many groups lie around a group at most; a circle ends somewhere."""
        if name == _ALL or not left:
            return 0
        if (name, left) not in self._depths:
            above = (self.depth(parent, left - 1) for parent in self.groups[name].parents)
            self._depths[name, left] = 1 + max(above, default=0)
        return self._depths[name, left]

    def groups_of_hosts(self) -> dict[str, frozenset[str]]:
        """The hosts of each group and of those in it."""
        found: dict[str, set[str]] = {_ALL: set()}
        for host in self.members:
            for name in self.around(host):
                found.setdefault(name, set()).add(host)
        return {name: frozenset(members) for name, members in found.items()}

    def around(self, host: str) -> list[str]:
        """The groups of a host, those that count most last. Hosts that the same groups list share one answer."""
        listing = frozenset(self.members[host])
        if listing not in self._around:
            self._around[listing] = self._outwards(listing)
        return self._around[listing]

    def _outwards(self, listing: frozenset[str]) -> list[str]:
        found: set[str] = {_ALL}
        waiting = list(listing)
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += self.groups[name].parents
        return sorted(found, key=lambda name: (self.depth(name), self.groups[name].priority, name))


def read_ansible(path: str) -> Inventory:
    """Raises ConfigError for what is not an inventory, and for hosts of which nothing says where their files lie."""
    top = _read(path)
    if top is None:
        raise ConfigError(f"{path}: neither a {path.rpartition('.')[2]} archive nor an Ansible inventory in YAML")
    hosts = Hosts(path, {_ALL: Group()})
    for name, group in top.merged:
        _gather(hosts, str(name.value), group, None, 0)
    if not hosts.members:
        raise ConfigError(f"{path}: an inventory without hosts")
    files = delivered(path, hosts.groups_of_hosts())
    merged = {host: _merged(path, hosts, host) for host in hosts.members}
    lost = [host for host in merged if not _layers(merged[host], host) and host not in files]
    if lost and (not files or any(_layers(given, host) for host, given in merged.items())):
        raise ConfigError(f"{path}: nothing says where the files of '{lost[0]}' lie: set {_PREFIX}root")
    return Inventory(tuple(_member(path, host, merged[host], files.get(host, ())) for host in merged))


def _gather(hosts: Hosts, name: str, value: Node, parent: str | None, depth: int) -> None:
    """Note a group, its hosts and the groups in it."""
    group = hosts.groups.setdefault(name, Group())
    if parent is not None:
        group.parents.add(parent)
    if not isinstance(value, Mapping) or depth > _DEPTH:
        return
    given = value.mapping("vars")
    group.variables.update(_variables(given))
    priority = given.get(_PRIORITY) if given else None
    if isinstance(priority, Scalar) and priority.integer is not None:
        group.priority = priority.integer
    for pattern, inline in _entries(value, "hosts"):
        for host in expanded(pattern):
            if len(hosts.members) >= _MOST:
                raise ConfigError(f"{hosts.path}: names more than {_MOST} hosts")
            hosts.members.setdefault(host, set()).add(name)
            hosts.variables.setdefault(host, {}).update(_variables(inline if isinstance(inline, Mapping) else None))
    for child, inner in _entries(value, "children"):
        _gather(hosts, child, inner, name, depth + 1)


def _merged(path: str, hosts: Hosts, host: str) -> Variables:
    """The variables of a host. Files count more than the inventory, and group_vars/all more than the groups in it."""
    groups = hosts.around(host)
    merged: Variables = {}
    for name in groups:
        merged.update(hosts.groups[name].variables)
    for name in groups:
        merged.update(_beside(path, "group_vars", name))
    return {**merged, **hosts.variables[host], **_beside(path, "host_vars", host)}


def _entries(group: Mapping, name: str) -> Iterator[tuple[str, Node]]:
    inner = group.mapping(name)
    if inner is not None:
        yield from ((str(key.value), value) for key, value in inner.merged)


def expanded(pattern: str) -> Iterator[str]:
    """The hosts of ``rover-[01:03].hall``, as Ansible counts them; a name without ranges is itself."""
    found = _RANGE.search(pattern)
    if found is None:
        yield pattern
        return
    before, after = pattern[: found.start()], pattern[found.end() :]
    for middle in _counted(found["first"], found["last"], int(found["step"] or 1)):
        yield from (f"{before}{middle}{rest}" for rest in expanded(after))


def _counted(first: str, last: str, step: int) -> Iterator[str]:
    if not step or first.isdigit() != last.isdigit():
        return
    if not first.isdigit():
        yield from map(chr, range(ord(first), ord(last) + 1, step))
        return
    width = len(first) if first.startswith("0") else 0
    yield from (str(number).zfill(width) for number in range(int(first), int(last) + 1, step))


@cache
def _beside(path: str, folder: str, name: str) -> Variables:
    """The variables in the files of ``host_vars`` or ``group_vars`` for a name: one file, or all in a folder."""
    if "/" in name:
        return {}
    place = os.path.join(os.path.dirname(path), folder, name)
    found: Variables = {}
    for file in [*filter(os.path.isfile, map(place.__add__, _ENDINGS)), *_files_below(place)]:
        found.update(_variables(_read(file)))
    return found


def _files_below(place: str) -> list[str]:
    if not os.path.isdir(place):
        return []
    names = sorted(os.listdir(place))
    return [os.path.join(place, name) for name in names if name.endswith(_ENDINGS[1:]) and not name.startswith(".")]


def _read(path: str) -> Mapping | None:
    root = parse(Source(path, text_of(path))).root
    return root if isinstance(root, Mapping) else None


def _variables(mapping: Mapping | None) -> Variables:
    if mapping is None:
        return {}
    found = ((str(key.value).removeprefix(_PREFIX), value) for key, value in mapping.merged)
    return {name: value for name, value in found if name in _NAMES and mapping.entry(_PREFIX + name) is not None}


def _layers(variables: Variables, host: str) -> list[str]:
    return [*_texts(variables.get("root"), host), *_texts(variables.get("overlays"), host)]


def _member(path: str, host: str, variables: Variables, files: Files) -> Member:
    layers = _layers(variables, host)
    folder = os.path.dirname(os.path.abspath(path))
    places = tuple(os.path.normpath(os.path.join(folder, layer)) for layer in layers)
    for place in places:
        if why := refusal(place):
            raise ConfigError(f"{path}: robot '{host}': {why}")
    domain = variables.get("domain")
    number = domain.integer if isinstance(domain, Scalar) else None
    role, site = (next(iter(_texts(variables.get(name), host)), "") for name in ("role", "site"))
    return Member(host, places, role or ROLE, site, number, delivered=files)


def _texts(node: Node | None, host: str) -> list[str]:
    return [for_host(str(each.value), host) for each in scalars(node)]
