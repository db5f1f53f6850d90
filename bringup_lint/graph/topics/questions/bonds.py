"""Lifecycle nodes of the tree that open no bond to a lifecycle manager of nav2."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.lifecycle import managers
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.lifecycle import Managed
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.graph.workspace import Package
    from bringup_lint.source import Located
    from bringup_lint.source import Source

_BASE = regex(
    r"\bclass\s+\w{1,80}\s{0,4}(?:final\s{0,4})?:\s{0,40}(?:public\s{1,4})?(?P<cpp>rclcpp_lifecycle::LifecycleNode)\b"
    r"|^class\s+\w{1,80}\((?P<python>(?:rclpy\.lifecycle\.)?(?:Lifecycle)?Node)\):",
    re.M,
    hints="class",
)
"""A class that builds on the plain lifecycle node of a client library; in Python the import tells ``Node`` apart."""
_OF_PYTHON = regex(r"^(?:from|import)[ \t]+rclpy\.lifecycle\b", re.M, hints="rclpy.lifecycle")
_BOND = regex(r"[Bb]ond|nav2_util|nav2_ros_common|\bnav2::LifecycleNode", hints="ond nav2")
_BONDED = frozenset({"bond", "bond_core", "bondcpp", "bondpy", "nav2_util", "nav2_ros_common"})
_NAMED = regex(r"(?:LifecycleNode\s{0,4}[({]|super\(\)\.__init__\()\s{0,40}[\"'](?P<name>\w{1,80})[\"']")
_KINDS = ("cpp-node", "python-node")


class Bonds:
    def __init__(self, topics: Topics) -> None:
        self._topics = topics
        self._workspace = topics.launch.workspace
        self._known: dict[str, list[Source]] = {}

    def lacking(self, expansion: Expansion) -> Iterator[tuple[Managed, Started, Located]]:
        """The managed nodes, with what starts them and what their class builds on, where nothing of the package or of
        what it needs opens a bond."""
        role = self._topics.launch.role
        own = [node for node in expansion.nodes if node.is_node and not role(node).managed and self._plain(node)]
        for managed in (each for manager in managers(expansion) if manager.watches for each in manager.managed or ()):
            found = ((node, self._base(node, managed)) for node in own if _may_be(node, managed))
            yield from islice(((managed, node, base) for node, base in found if base is not None), 1)

    def _plain(self, node: Started) -> list[Source]:
        """The sources of the package of a node; none where it may open a bond."""
        name = str(literal_text(node.package))
        if name not in self._known:
            package = self._workspace.packages.get(name)
            self._known[name] = self._without_bond(package) if package is not None else []
        return self._known[name]

    def _without_bond(self, package: Package) -> list[Source]:
        sources = self._by_package.get(id(package), [])
        texts = (each.text for each in (*sources, *(build.source for build in package.builds)))
        bonded = not _BONDED.isdisjoint(self._workspace.required(package))
        return [] if bonded or any(_BOND.search(text) for text in texts) else sources

    @cached_property
    def _by_package(self) -> dict[int, list[Source]]:
        found: dict[int, list[Source]] = {}
        for source in self._topics.files.of_kind(*_KINDS):
            found.setdefault(id(self._workspace.owner(source)), []).append(source)
        return found

    def _base(self, node: Started, managed: Managed) -> Located | None:
        """What the class of a node builds on, when that is the plain lifecycle node. Its file is that of the program,
        else the one that gives the node its name."""
        code = self._topics.code(node) if node.name is not None else None
        if code is not None and code.source is not None and not code.several:
            return _base(code.source)
        name = managed.fqn.rpartition("/")[2]
        naming = [each for each in self._plain(node) if name in _named(each)]
        return _base(naming[0]) if len(naming) == 1 else None


def _may_be(node: Started, managed: Managed) -> bool:
    """Whether a node has a name, or may have it from its source: launch gives it none."""
    return node.fqn == managed.fqn or node.name is None


def _named(source: Source) -> frozenset[str]:
    """The names that lifecycle nodes of a file give themselves."""
    return source.once(_named, lambda: frozenset(found["name"] for found in _NAMED.finditer(source.text)))


def _base(source: Source) -> Located | None:
    """What the one class of a file builds on, when that is the plain lifecycle node."""
    found = list(_BASE.finditer(source.text))
    if len(found) != 1 or (found[0]["python"] and not _OF_PYTHON.search(source.text)):
        return None
    return source.located(*found[0].span("python" if found[0]["python"] else "cpp"))
