"""Nodes that a lifecycle manager of nav2 waits for, and that nothing starts."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.node_roles import lifecycle_names
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.lifecycle import Managed
from bringup_lint.graph.launch.lifecycle import Manager
from bringup_lint.graph.launch.lifecycle import full_name
from bringup_lint.graph.launch.lifecycle import managers
from bringup_lint.graph.launch.lifecycle import outside
from bringup_lint.graph.launch.lifecycle_names import all_names
from bringup_lint.graph.launch.lifecycle_names import may_be_called
from bringup_lint.graph.launch.lifecycle_names import names_near
from bringup_lint.graph.launch.started import Started
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params


class Unstarted(NamedTuple):
    """A node that a manager waits for in vain."""

    manager: Manager
    managed: Managed
    started: Mapping[str, Started]
    """The nodes beside the manager, by the last part of their names."""

    @property
    def name(self) -> str:
        """The last part of the name that the manager looks for."""
        return self.managed.fqn.rpartition("/")[2]

    @property
    def namesake(self) -> Started | None:
        """A node of this name in another namespace."""
        return self.started.get(self.name)

    @property
    def near(self) -> list[str]:
        """The names of nodes that the list may mean."""
        return [self.name] if self.name in self.started else nearest(self.name, self.started, 3)


def unstarted(launch: Launch, params: Params) -> Iterator[Unstarted]:
    """What managers wait for in vain. Where nodes may start that are not known, nothing is."""
    for expansion in launch.entries:
        found = managers(expansion)
        if not found or outside(expansion):
            continue
        named = [(full_name(node, launch.role(node)), node) for node in expansion.nodes if node.is_node]
        if len(dict(named)) == len(found):
            yield from _of_managers_alone(launch, params, found)
        else:
            yield from _of(launch, params, expansion, found, dict(named))


def _of(
    launch: Launch, params: Params, expansion: Expansion, found: list[Manager], started: dict[str | None, Started]
) -> Iterator[Unstarted]:
    bare = {name.rpartition("/")[2]: node for name, node in started.items() if name is not None}
    nav2 = lifecycle_names() if expansion.open else ()
    nameless = [node for node in expansion.nodes if node.is_node and full_name(node, launch.role(node)) is None]
    for manager in found:
        for managed in _listed(params, manager):
            missing = Unstarted(manager, managed, bare)
            if managed.fqn in started or missing.name in nav2:
                continue
            elsewhere = bool(nameless) and missing.name in all_names(launch)
            unsure = expansion.open or elsewhere or any(may_be_called(launch, node, missing.name) for node in nameless)
            if unsure and (missing.name in all_names(launch) or not (missing.namesake or nearest(missing.name, bare))):
                continue
            yield missing


def _of_managers_alone(launch: Launch, params: Params, found: list[Manager]) -> Iterator[Unstarted]:
    """Managers in a separate launch file: their nodes are in other files, if at least one of them is."""
    if any(outside(expansion) for expansion in launch.expansions):
        return
    for manager in found:
        names = names_near(launch, manager.node.file)
        wanted = {managed.fqn.rpartition("/")[2]: managed for managed in _listed(params, manager)}
        if names.isdisjoint(wanted):
            continue
        for last, managed in wanted.items():
            if last not in names and last not in lifecycle_names():
                yield Unstarted(manager, managed, {})


def _listed(params: Params, manager: Manager) -> list[Managed]:
    """The nodes that a manager brings up, by the launch file or by its parameter file."""
    if manager.names.value is None and not manager.names.known:
        return manager.called(params.texts(manager.node, "node_names") or []) or []
    return manager.managed or []
