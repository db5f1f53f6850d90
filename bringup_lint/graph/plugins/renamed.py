"""Controllers that get the name of their manager, because a launch file names it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned_by
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params

_RENAMING = ("foxy", "galactic", "humble", "iron")
"""Releases whose controllers take the arguments of the whole process (controller_interface_base.cpp)."""
_BROADCASTER = "broadcaster"
"""Controllers that run without parameters."""


class RenamedControllers(NamedTuple):
    name: Located
    """The name that the launch file gives to the manager."""
    controllers: tuple[Located, ...]
    """Those of them that need parameters, where they are spawned."""
    manager: Started
    distribution: str


def renamed_controllers(launch: Launch, params: Params) -> Iterator[RenamedControllers]:
    """Each manager once; not where a parameter file gives joints to every node."""
    if any(str(each.block.key) in ("**", "/**") for _, each in params.named("joints")):
        return
    seen: set[Span] = set()
    for expansion in launch.entries:
        managers = [node for node in expansion.nodes if is_manager(node) and literal_text(node.name) is not None]
        controllers = tuple(name for node in expansion.nodes for name in spawned_by(node) if _BROADCASTER not in name)
        for manager in managers if len(managers) == 1 and controllers else ():
            name, distribution = literal_text(manager.name), launch.distribution(manager.file)
            is_judged = manager.file.source.judged and not launch.looks_at_distribution(manager.file)
            if name is None or name.span in seen or not is_judged or distribution not in _RENAMING:
                continue
            seen.add(name.span)
            yield RenamedControllers(name, controllers, manager, str(distribution))
