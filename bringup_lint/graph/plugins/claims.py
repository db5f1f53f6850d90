"""Controllers that are activated together and claim the same interface of a joint."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.controllers import spawned_by
from bringup_lint.graph.plugins.moveit import controller_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_PASSIVE = ("--inactive", "--stopped", "--load-only")
_CLAIMS: dict[str, tuple[tuple[str, ...], str]] = {
    "joint_trajectory_controller/JointTrajectoryController": (("joints",), "command_interfaces"),
    "forward_command_controller/ForwardCommandController": (("joints",), "interface_name"),
    "position_controllers/JointGroupPositionController": (("joints",), "=position"),
    "velocity_controllers/JointGroupVelocityController": (("joints",), "=velocity"),
    "effort_controllers/JointGroupEffortController": (("joints",), "=effort"),
    "position_controllers/GripperActionController": (("joint",), "=position"),
    "effort_controllers/GripperActionController": (("joint",), "=effort"),
    "diff_drive_controller/DiffDriveController": (("left_wheel_names", "right_wheel_names"), "=velocity"),
    "pid_controller/PidController": (("dof_names",), "command_interface"),
}
"""Class -> the parameters with its joints, and the one with the interfaces that it claims of them, or ``=`` and the
interface. Source: ros2_controllers, Humble to Kilted."""
_GENERATES = regex(r"\bgenerate_(?:demo|spawn_controllers)_launch\(", hints="generate_demo generate_spawn_controllers")
_MOCKED = regex(r"\b(?:mock|fake)_components/", hints="mock_components fake_components")
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
    is_mocked: bool = False
    """The controllers move the joints of a demo, which has no hardware."""


class Taken(NamedTuple):
    """What a controller claims."""

    name: str
    joints: frozenset[str]
    interfaces: frozenset[str]
    where: dict[str, Span]
    """Joint -> the list that it is in."""


def claims(tree: Tree, launch: Launch, params: Params) -> Iterator[Claim]:
    """Each parameter once, where one launch file activates both controllers in any case."""
    said: set[Span] = set()
    files = {file.source.absolute: taken for file in params.judged if len(taken := _taken(file)) > 1}
    if not files:
        return
    spawning = [(list(files.values()), _active(expansion), False) for expansion in launch.entries]
    generated = [each for each in _generated(tree, launch) if each[0] in files]
    spawning += [([files[path]], active, is_mocked) for path, active, is_mocked in generated]
    for known, active, is_mocked in spawning:
        for found in (claim for taken in known for claim in _among(taken, active)):
            if found.where not in said:
                said.add(found.where)
                yield found._replace(is_mocked=is_mocked)


def _generated(tree: Tree, launch: Launch) -> Iterator[tuple[str, dict[str, Located], bool]]:
    """The parameter file of controllers, those that a launch file made by MoveIt spawns, which are all to which it
    sends, and whether the hardware of its demo is only made up.

    Source: moveit_configs_utils, launches.py.
    """
    for file in launch.launch_files:
        text = file.source.text
        owner = launch.workspace.owner(file.source) if _GENERATES.search(text) else None
        if owner is None or "trajectory_execution" in text or not file.source.judged:
            continue
        source = tree.at(os.path.join(owner.folder, "config", "moveit_controllers.yaml"))
        if source is not None:
            names = {str(name).strip("/"): name for name in controller_names(source)}
            yield os.path.join(owner.folder, "config", "ros2_controllers.yaml"), names, _is_mocked(tree, source)


def _is_mocked(tree: Tree, controllers: Source) -> bool:
    """Whether the hardware that MoveIt writes beside the controllers is still that of the demo."""
    folder = os.path.dirname(controllers.absolute)
    paths = [path for path in tree.walked_below(folder) if path.endswith(".ros2_control.xacro")]
    sources = [source for path in paths if (source := tree.at(os.path.abspath(path))) is not None]
    return bool(sources) and all(_MOCKED.search(source.text) for source in sources)


def _active(expansion: Expansion) -> dict[str, Located]:
    found: dict[str, Located] = {}
    for spawner, name in ((node, name) for node in expansion.nodes for name in spawned_by(node)):
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
        own.setdefault(each.block.node_name, {})[each.name] = each
    found = []
    for name, given in own.items():
        kind = str(given["type"].value.data) if "type" in given else types.get(name, "")
        names, interface = _CLAIMS.get(kind, ((), ""))
        lists = [given[each] for each in names if each in given]
        claimed = (
            {interface[1:]} if interface.startswith("=") else _texts(given[interface]) if interface in given else ()
        )
        if lists and claimed:
            where = {joint: each.span for each in lists for joint in _texts(each)}
            found.append(Taken(name, frozenset(where), frozenset(claimed), where))
    return found


def _texts(parameter: Parameter) -> frozenset[str]:
    return frozenset(item.text for item in items(parameter))


def _among(taken: list[Taken], active: dict[str, Located]) -> Iterator[Claim]:
    """The claims of the active controllers of one file that another one of them has made before."""
    known = [each for each in taken if each.name in active][:_MOST]
    for at, each in enumerate(known):
        for first in known[:at]:
            joints = sorted(each.joints & first.joints)
            if joints and each.interfaces & first.interfaces:
                joint = joints[0]
                yield Claim(joint, each.where[joint], each.name, first.name, first.where[joint], active[each.name])
                break
