"""Controllers that are activated together and claim the same interface of a joint."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.controllers import spawned
from bringup_lint.graph.plugins.moveit import controller_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_PASSIVE = ("--inactive", "--stopped", "--load-only")
_TYPES = ("joint_trajectory_controller/", "position_controllers/", "velocity_controllers/", "effort_controllers/")
"""Controllers that claim the command interfaces of all joints in ``joints``."""
_GENERATES = regex(r"\bgenerate_(?:demo|spawn_controllers)_launch\(", hints="generate_demo generate_spawn_controllers")
_MOST = 200
"""Controllers of a file that are compared with each other."""


class Claim(NamedTuple):
    joint: str
    where: Span
    """The joints of the second controller."""
    controller: str
    first: str
    before: Span
    """The joints of the first controller."""
    spawned: Located


class Taken(NamedTuple):
    """What a controller claims."""

    name: str
    joints: frozenset[str]
    interfaces: frozenset[str]
    where: Span
    """The list of joints."""


def claims(tree: Tree, launch: Launch, params: Params) -> Iterator[Claim]:
    """Each parameter once, where one launch file activates both controllers in any case."""
    said: set[Span] = set()
    files = {file.source.absolute: taken for file in params.judged if len(taken := _taken(file)) > 1}
    if not files:
        return
    spawning = [(list(files.values()), _active(expansion)) for expansion in launch.entries]
    spawning += [([files[path]], active) for path, active in _generated(tree, launch) if path in files]
    for known, active in spawning:
        for found in (claim for taken in known for claim in _among(taken, active)):
            if found.where not in said:
                said.add(found.where)
                yield found


def _generated(tree: Tree, launch: Launch) -> Iterator[tuple[str, dict[str, Located]]]:
    """The parameter file of controllers -> those that a launch file made by MoveIt spawns: all to which it sends.

    Source: moveit_configs_utils, launches.py.
    """
    for file in launch.launch_files:
        text = file.source.text
        owner = launch.workspace.owner(file.source) if _GENERATES.search(text) else None
        if owner is None or "trajectory_execution" in text or not file.source.judged:
            continue
        source = tree.read(os.path.join(owner.folder, "config", "moveit_controllers.yaml"))
        if source is not None:
            names = {str(name).strip("/"): name for name in controller_names(source)}
            yield os.path.join(owner.folder, "config", "ros2_controllers.yaml"), names


def _active(expansion: Expansion) -> dict[str, Located]:
    found: dict[str, Located] = {}
    for spawner, name in spawned(expansion.nodes):
        words = {str(literal_text(word)) for word in spawner.arguments}
        is_plain = spawner.by_default is True and not spawner.conditions and not spawner.context
        if is_plain and not words & set(_PASSIVE) and spawner.file.source.judged:
            found.setdefault(str(name), name)
    return found


def _taken(file: ParameterFile) -> list[Taken]:
    """What the controllers of a file claim, in the order of the file."""
    types = {each.name.removesuffix(".type"): str(each.value.data) for each in file.parameters}
    own: dict[str, dict[str, Parameter]] = {}
    for each in file.parameters:
        name = str(each.block.key).rpartition("/")[2]
        if each.name in ("joints", "command_interfaces") and types.get(name, "").startswith(_TYPES):
            own.setdefault(name, {})[each.name] = each
    whole = ((name, given) for name, given in own.items() if len(given) == 2)
    return [
        Taken(name, _texts(given["joints"]), _texts(given["command_interfaces"]), given["joints"].span)
        for name, given in whole
    ]


def _texts(parameter: Parameter) -> frozenset[str]:
    return frozenset(item.text for item in items(parameter))


def _among(taken: list[Taken], active: dict[str, Located]) -> Iterator[Claim]:
    """The claims of the active controllers of one file that another one of them has made before."""
    known = [each for each in taken if each.name in active][:_MOST]
    for at, each in enumerate(known):
        for first in known[:at]:
            joints = sorted(each.joints & first.joints)
            if joints and each.interfaces & first.interfaces:
                yield Claim(joints[0], each.where, each.name, first.name, first.where, active[each.name])
                break
