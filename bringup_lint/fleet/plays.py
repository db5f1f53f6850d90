"""The plays of an Ansible project: which hosts each is for."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cached_property

from bringup_lint.config import ConfigError
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover.tree import is_below
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
_HOST_NAME = regex(r"\{\{ *inventory_hostname *\}\}")


class Play(NamedTuple):
    folder: str
    """Of its playbook."""
    node: Mapping
    hosts: frozenset[str]


@dataclass(eq=False)
class Project:
    """The folder of the project that an inventory belongs to. What lies outside of it is not read."""

    folder: str
    _read: dict[str, Node | None] = field(default_factory=dict)

    @classmethod
    def of(cls, inventory: str) -> Project:
        folder = own = os.path.dirname(os.path.abspath(inventory))
        for _ in range(_UP + 1):
            if any(os.path.exists(os.path.join(folder, mark)) for mark in _MARKS):
                return cls(folder)
            folder = os.path.dirname(folder)
        return cls(own)

    def holds(self, path: str) -> bool:
        """Whether a path, and what a link there leads to, lies in the project."""
        return is_below(os.path.realpath(path), (self._real_folder,))

    @cached_property
    def _real_folder(self) -> str:
        return os.path.realpath(self.folder)

    def read(self, *parts: str) -> Node | None:
        """A file of YAML, parsed once. None for what is not there, and for what is not text."""
        path = os.path.realpath(os.path.join(*parts))
        if path not in self._read:
            self._read[path] = _parsed(path) if self.holds(path) and os.path.isfile(path) else None
        return self._read[path]


def _parsed(path: str) -> Node | None:
    try:
        return parse(Source(path, text_of(path))).root
    except ConfigError:
        return None


def plays(project: Project, groups: dict[str, frozenset[str]]) -> Iterator[Play]:
    """The plays of all playbooks, with their hosts; not those whose hosts are not known."""
    for inner in _FOLDERS:
        folder = os.path.join(project.folder, inner).rstrip("/")
        names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        for name in [name for name in names if name.endswith(_YAML)][:_MOST]:
            for node in mappings(project.read(folder, name)):
                hosts = _hosts(node.get("hosts"), groups)
                if hosts:
                    yield Play(folder, node, hosts)


def mappings(node: Node | None) -> Iterator[Mapping]:
    """Those in a list, or a single one."""
    if isinstance(node, Mapping):
        yield node
    elif isinstance(node, Sequence):
        yield from (each for each in node if isinstance(each, Mapping))


def scalars(node: Node | None) -> Iterator[Scalar]:
    """Those in a list, or a single one."""
    if isinstance(node, Scalar):
        yield node
    elif isinstance(node, Sequence):
        yield from node.scalars


def for_host(text: str, host: str) -> str:
    """A text in which the name of the host is filled in, as the only variable that is known of each."""
    return _HOST_NAME.sub(lambda _: host, text)


def _hosts(node: Node | None, groups: dict[str, frozenset[str]]) -> frozenset[str]:
    """The hosts of a pattern; nothing where it is not known."""
    words = [word.strip() for each in scalars(node) for word in _SEPARATOR.split(str(each.value))]
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
