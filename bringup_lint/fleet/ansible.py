"""An Ansible inventory in YAML: its hosts are robots. Where their files lie, host variables say: ``bringup_lint_root``,
``bringup_lint_overlays``, ``bringup_lint_role``, ``bringup_lint_site`` and ``bringup_lint_domain``, in the inventory or
in ``host_vars/`` and ``group_vars/`` beside it. Variables of a host count more than those of its groups, those of inner
groups more than those of outer ones; templates are not filled in.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from bringup_lint.config import ConfigError
from bringup_lint.fleet.members import ROLE
from bringup_lint.fleet.members import Inventory
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.members import text_of
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Source

_PREFIX = "bringup_lint_"
_NAMES = ("root", "overlays", "role", "site", "domain")
_DEPTH = 20
Variables = dict[str, Node]


def read_ansible(path: str) -> Inventory:
    """Raises ConfigError for what is not an inventory, and for hosts of which nothing says where their files lie."""
    top = _read(path)
    if top is None:
        raise ConfigError(f"{path}: neither a {path.rpartition('.')[2]} archive nor an Ansible inventory in YAML")
    hosts: dict[str, Variables] = {}
    for name, group in top.merged:
        if isinstance(group, Mapping):
            for host, variables in _hosts(path, str(name.value), group, {}, 0):
                hosts.setdefault(host, {}).update(variables)
    if not hosts:
        raise ConfigError(f"{path}: an inventory without hosts")
    return Inventory(tuple(_member(path, host, variables) for host, variables in hosts.items()))


def _hosts(path: str, name: str, group: Mapping, outer: Variables, depth: int) -> Iterator[tuple[str, Variables]]:
    """The hosts of a group and of the groups in it, each with its variables."""
    own = {**outer, **_variables(_beside(path, "group_vars", name)), **_variables(group.mapping("vars"))}
    for host, value in _entries(group, "hosts"):
        inline = _variables(value if isinstance(value, Mapping) else None)
        yield host, {**own, **_variables(_beside(path, "host_vars", host)), **inline}
    if depth < _DEPTH:
        for child, value in _entries(group, "children"):
            if isinstance(value, Mapping):
                yield from _hosts(path, child, value, own, depth + 1)


def _entries(group: Mapping, name: str) -> Iterator[tuple[str, Node]]:
    inner = group.mapping(name)
    if inner is not None:
        yield from ((str(key.value), value) for key, value in inner.merged)


def _beside(path: str, folder: str, name: str) -> Mapping | None:
    for ending in (".yml", ".yaml", ""):
        file = os.path.join(os.path.dirname(path), folder, name + ending)
        if "/" not in name and os.path.isfile(file):
            return _read(file)
    return None


def _read(path: str) -> Mapping | None:
    root = parse(Source(path, text_of(path))).root
    return root if isinstance(root, Mapping) else None


def _variables(mapping: Mapping | None) -> Variables:
    if mapping is None:
        return {}
    found = ((str(key.value).removeprefix(_PREFIX), value) for key, value in mapping.merged)
    return {name: value for name, value in found if name in _NAMES and mapping.entry(_PREFIX + name) is not None}


def _member(path: str, host: str, variables: Variables) -> Member:
    layers = [*_texts(variables.get("root")), *_texts(variables.get("overlays"))]
    if not layers:
        raise ConfigError(f"{path}: nothing says where the files of '{host}' lie: set {_PREFIX}root")
    folder = os.path.dirname(os.path.abspath(path))
    places = tuple(os.path.normpath(os.path.join(folder, layer)) for layer in layers)
    missing = next((place for place in places if not os.path.exists(place)), None)
    if missing is not None:
        raise ConfigError(f"{path}: robot '{host}': there is no '{missing}'")
    domain = variables.get("domain")
    number = domain.integer if isinstance(domain, Scalar) else None
    role, site = (next(iter(_texts(variables.get(name))), "") for name in ("role", "site"))
    return Member(host, places, role or ROLE, site, number)


def _texts(node: Node | None) -> list[str]:
    if isinstance(node, Scalar):
        return [str(node.value)]
    return [str(each.value) for each in node.scalars] if isinstance(node, Sequence) else []
