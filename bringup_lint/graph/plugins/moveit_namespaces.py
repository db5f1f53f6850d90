"""Controllers to which MoveIt sends trajectories in a namespace where a launch file runs no controller manager."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.simulation import is_simulator
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned
from bringup_lint.graph.plugins.moveit import controller_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.source import Located

_NAMED = regex(r"\b\w{0,80}controllers\w{0,40}\.yaml\b", hints="controllers")
_DEFAULT = "moveit_controllers.yaml"
"""What MoveItConfigsBuilder reads where the launch file names no other."""


class ControllersElsewhere(NamedTuple):
    manager: Started
    names: tuple[Located, ...]


def controllers_elsewhere(launch: Launch, tree: Tree) -> Iterator[ControllersElsewhere]:
    """Each launch file by itself, where all that it starts is known."""
    said: set[object] = set()
    for expansion in launch.entries:
        group = next((node for node in expansion.nodes if _is_move_group(node)), None)
        managers = [node for node in expansion.nodes if is_manager(node)]
        if group is None or not managers or managers[0].span in said or not _is_closed(expansion):
            continue
        namespaces = {node.namespace for node in managers} | set(_addressed(expansion))
        if None in namespaces or group.namespace is None or managers[0].by_default is not True:
            continue
        active = {str(name) for _, name in spawned(expansion.nodes)}
        whole = ((name, _resolved(name, group.namespace)) for name in _sent_to(tree, group))
        lost = [name for name, (above, tail) in whole if tail in active and above not in namespaces]
        if lost and managers[0].file.source.judged:
            said.add(managers[0].span)
            yield ControllersElsewhere(managers[0], tuple(lost))


def _addressed(expansion: Expansion) -> Iterator[str | None]:
    """The namespaces in which spawners look for a manager: their own, or that of the name that they are given."""
    for node in {id(each): each for each, _ in spawned(expansion.nodes)}.values():
        words = [str(literal_text(word)) for word in node.arguments]
        named = [after for word, after in pairwise(words) if word in ("-c", "--controller-manager")]
        named += [word.partition("=")[2] for word in words if word.startswith("--controller-manager=")]
        for name in named:
            yield name.rpartition("/")[0] or "/" if name.startswith("/") else None
        if not named:
            yield node.namespace


def _is_move_group(node: Started) -> bool:
    return literal_text(node.package) == "moveit_ros_move_group" and node.by_default is True


def _is_closed(expansion: Expansion) -> bool:
    """Whether nothing else may run controllers: an included file that is not in the tree, or a simulator."""
    programs = (str(literal_text(node.package)) for node in expansion.nodes)
    return all(each.target is not None for each in expansion.includes) and not any(map(is_simulator, programs))


def _sent_to(tree: Tree, group: Started) -> list[Located]:
    """The names in the one file of controllers that the launch file of MoveIt names, or that is read by default."""
    named = {each for each in _NAMED.findall(group.file.source.text) if "moveit" in each} or {_DEFAULT}
    paths = [path for each in named for path in tree.named(each)]
    source = tree.at(paths[0]) if len(paths) == 1 else None
    return controller_names(source) if source is not None else []


def _resolved(name: str, namespace: str) -> tuple[str, str]:
    """The namespace of a controller, and its own name."""
    whole = name if name.startswith("/") else f"{namespace.rstrip('/')}/{name}"
    above, _, tail = whole.rpartition("/")
    return above or "/", tail
