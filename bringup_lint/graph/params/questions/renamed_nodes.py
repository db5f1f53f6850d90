"""Blocks of parameters for nodes that are called otherwise in the robot's distribution."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros import distros
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import ParameterFile


class Renaming(NamedTuple):
    now: str
    since: str
    """The first distribution with the new name."""


_RENAMED = {"recoveries_server": Renaming("behavior_server", "humble")}
"""Nodes of Navigation2, from its migration guides."""


class RenamedNode(NamedTuple):
    block: Block
    renaming: Renaming
    others: tuple[Block, ...]
    """In further files."""
    is_used: bool


def renamed_nodes(params: Params) -> Iterator[RenamedNode]:
    """Silent where the file has a block for the new name, too, and where a launch file or program has the old one."""
    for old, renaming in _RENAMED.items():
        known = frozenset(distros.distros_since(renaming.since))
        found = list(_blocks(params, old, renaming, known))
        if found and not _is_started(params, old):
            found.sort(key=lambda each: not params.is_used(each[0]))
            (file, block), *others = found
            yield RenamedNode(block, renaming, tuple(other for _, other in others), params.is_used(file))


def _blocks(
    params: Params, old: str, renaming: Renaming, known: frozenset[str]
) -> Iterator[tuple[ParameterFile, Block]]:
    target = params.files.target
    for file in params.judged:
        by_path = distros.named_in(file.source.name)
        named = frozenset({by_path}) if by_path is not None else target.named
        if not named or not named <= known:
            continue
        names = {block.node_name for block in file.blocks}
        if renaming.now not in names:
            yield from ((file, block) for block in file.blocks if block.node_name == old and block.parameters)


def _is_started(params: Params, name: str) -> bool:
    sources = params.files.of_kind("launch-python", "launch-xml", "launch-yaml", "python-node", "cpp-node")
    return any(name in source.text for source in sources)
