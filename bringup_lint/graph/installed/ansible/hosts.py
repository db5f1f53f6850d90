"""The groups and hosts that plays are for, against the inventories of the tree."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.memo import memo
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers.ansible_tasks import plays
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest
from bringup_lint.spelling import without_digits

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_NAME = regex(r"[A-Za-z_][\w.-]*")
_GROUP = regex(r"(?m)^[ \t]*(?:\[([A-Za-z_][\w.-]*)(?::\w+)?\]|([A-Za-z_][\w.-]*):[ \t]*$)")
"""A section of an INI inventory, a key of a YAML one."""
_KEYS = frozenset(("all", "ungrouped", "children", "hosts", "vars"))
_BUILT_IN = frozenset(("all", "ungrouped", "localhost"))
_GROWS = regex(r"\badd_host\b|\bgroup_by\b|\bplugin[ \t]*:|\bkeyed_groups\b")
"""What brings groups and hosts that no file lists."""


@dataclass(eq=False)
class PlayHosts:
    files: Files

    def misspelt(self, source: Source) -> Iterator[tuple[Located, str]]:
        """The names that no inventory of the tree has, and the group that is nearly called so."""
        if not self._groups or self._grows:
            return
        for play in plays(source):
            hosts = play.get("hosts")
            scalars = [hosts] if isinstance(hosts, Scalar) else hosts.scalars if isinstance(hosts, Sequence) else []
            for scalar in scalars:
                like = self._like(scalar.value)
                if like is not None:
                    yield scalar.value, like

    @memo
    def _like(self, name: str) -> str | None:
        """The one group that is nearly called so; None for a name that an inventory has, and for one that differs from
        it in its number."""
        if name in _BUILT_IN or not _NAME.fullmatch(name) or name in self._words:
            return None
        if without_digits(name) in self._unnumbered:
            return None
        near = nearest(name, self._groups)
        return near[0] if len(near) == 1 else None

    @cached_property
    def _inventories(self) -> list[Source]:
        return self.files.of_kind("ansible-vars")

    @cached_property
    def _words(self) -> frozenset[str]:
        return frozenset(word for source in self._inventories for word in _NAME.findall(source.text))

    @cached_property
    def _unnumbered(self) -> frozenset[str]:
        return frozenset(map(without_digits, self._words))

    @cached_property
    def _groups(self) -> list[str]:
        found = (match[1] or match[2] for source in self._inventories for match in _GROUP.finditer(source.text))
        return sorted(set(found) - _KEYS)

    @cached_property
    def _grows(self) -> bool:
        """Whether plays, or plugins of the inventory, add groups."""
        return any(_GROWS.search(source.text) for source in self.files.of_kind("ansible", "ansible-vars"))
