"""The plays of an Ansible project: which hosts each is for."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from fnmatch import fnmatchcase

from bringup_lint.config import ConfigError
from bringup_lint.fleet.members import text_of
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_UP = 2
"""Folders above that of the inventory in which playbooks may lie, as in ``inventories/hall/hosts.yml``."""
_MARKS = ("ansible.cfg", "roles")
_FOLDERS = ("", "playbooks")
_MOST = 200
_YAML = (".yml", ".yaml")
_SEPARATOR = regex(r"[:,]")


class Play(NamedTuple):
    folder: str
    """Of its playbook."""
    node: Mapping
    hosts: frozenset[str]


def project_of(inventory: str) -> str:
    """The folder of the project that an inventory belongs to."""
    folder = own = os.path.dirname(os.path.abspath(inventory))
    for _ in range(_UP + 1):
        if any(os.path.exists(os.path.join(folder, mark)) for mark in _MARKS):
            return folder
        folder = os.path.dirname(folder)
    return own


def plays(project: str, groups: dict[str, frozenset[str]]) -> Iterator[Play]:
    """The plays of all playbooks, with their hosts; not those whose hosts are not known."""
    for inner in _FOLDERS:
        folder = os.path.join(project, inner).rstrip("/")
        names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        for name in [name for name in names if name.endswith(_YAML)][:_MOST]:
            for node in mappings(read(os.path.join(folder, name))):
                hosts = _hosts(node.get("hosts"), groups)
                if hosts:
                    yield Play(folder, node, hosts)


def read(path: str) -> Node | None:
    """None for what is not there, and for what is not text."""
    if not os.path.isfile(path):
        return None
    try:
        return parse(Source(path, text_of(path))).root
    except ConfigError:
        return None


def mappings(node: Node | None) -> Iterator[Mapping]:
    """Those in a list, or a single one."""
    if isinstance(node, Mapping):
        yield node
    elif isinstance(node, Sequence):
        yield from (each for each in node if isinstance(each, Mapping))


def _hosts(node: Node | None, groups: dict[str, frozenset[str]]) -> frozenset[str]:
    """The hosts of a pattern; nothing where it is not known."""
    scalars: Iterable[Scalar] = ()
    if isinstance(node, Scalar):
        scalars = [node]
    elif isinstance(node, Sequence):
        scalars = node.scalars
    words = [word.strip() for each in scalars for word in _SEPARATOR.split(str(each.value))]
    if any("{{" in word or word.startswith("~") or "[" in word for word in words):
        return frozenset()
    found = frozenset[str]().union(*(_matching(word, groups) for word in words if word[:1] not in ("&", "!")))
    for word in words:
        if word.startswith("&"):
            found &= _matching(word[1:], groups)
    for word in words:
        if word.startswith("!"):
            found -= _matching(word[1:], groups)
    return found


def _matching(word: str, groups: dict[str, frozenset[str]]) -> frozenset[str]:
    """The hosts of the groups, and the hosts, that have such a name."""
    if word == "*":
        word = "all"
    hosts = frozenset(host for host in groups["all"] if fnmatchcase(host, word))
    return hosts.union(*(members for name, members in groups.items() if fnmatchcase(name, word)))
