"""What MoveIt is configured with, compared with the groups of its SRDF and the controllers of the robot."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.values import items
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse as parse_xml
from bringup_lint.parsers.yaml_nodes import parse as parse_yaml
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Source

_KINEMATICS = "kinematics.yaml"
_PLANNING = "ompl_planning.yaml"
_CONTROLLERS = "moveit_controllers.yaml"
_MANAGER = "moveit_simple_controller_manager"
_OF_HAND = regex(r"gripper|hand|finger|tool|eef|end_?effector")
"""Groups that need no solver."""
_TRAJECTORY = "joint_trajectory_controller/"
_SERVED = {
    "joint_trajectory_controller/JointTrajectoryController": "follow_joint_trajectory",
    "position_controllers/GripperActionController": "gripper_cmd",
    "effort_controllers/GripperActionController": "gripper_cmd",
    "parallel_gripper_action_controller/GripperActionController": "gripper_cmd",
}
"""The action that a controller serves below its name. Source: ros2_controllers, Humble to Kilted."""


class MoveItProblem(NamedTuple):
    kind: str
    """``group``, ``planners``, ``controller``, ``action``, ``no-action``, ``section`` or ``joints``."""
    name: Located
    known: tuple[Located, ...]
    """The groups of the SRDF, the controller that has the same joints, the type that serves another action, or the
    joints that the controller has."""
    near: str | None
    """Of joints: how many MoveIt sends, and how many the controller has."""


def moveit_problems(tree: Tree, workspace: Workspace, params: Params) -> Iterator[MoveItProblem]:
    groups: dict[str, tuple[Located, ...] | None] = {}
    for path in tree.named(_KINEMATICS):
        source = tree.at(path)
        owner = workspace.owner(source) if source is not None else None
        if source is not None and owner is not None and source.judged:
            if owner.folder not in groups:
                groups[owner.folder] = _groups(tree, owner.folder)
            yield from _solvers(source, groups[owner.folder], params)
    for path in tree.named(_PLANNING):
        source = tree.at(path)
        owner = workspace.owner(source) if source is not None else None
        if source is not None and owner is not None and source.judged:
            if owner.folder not in groups:
                groups[owner.folder] = _groups(tree, owner.folder)
            yield from _planners(tree, source, groups[owner.folder], params)
    for path in tree.named(_CONTROLLERS):
        source = tree.at(path)
        if source is not None and source.judged:
            yield from _controllers(source, params)
            yield from _without_action(source)
            yield from _actions(source, params)
            yield from _joints(source, params)


def _groups(tree: Tree, folder: str) -> tuple[Located, ...] | None:
    """The groups of all SRDF files of a package; None where xacro or a template makes some, or there are none."""
    paths = [path for path in tree.walked_below(folder) if ".srdf" in os.path.basename(path)]
    found: list[Located] = []
    for path in paths:
        source = tree.at(path)
        root = parse_xml(source).root if source is not None and not source.template else None
        if root is None or "xacro:" in root.tag.source.text:
            return None
        found += (name for group in root.find_all("group") if (name := group.get("name")) is not None)
    return tuple(found) if found and not any("$" in name for name in found) else None


def _solvers(source: Source, groups: tuple[Located, ...] | None, params: Params) -> Iterator[MoveItProblem]:
    """Groups of a kinematics file that the SRDF does not have, where it gives none of its groups a solver, and that
    nothing else of the tree names, as it does when the SRDF is elsewhere."""
    root = _root(source)
    if root is None or groups is None:
        return
    names = {str(each) for each in groups}
    if all(map(_OF_HAND.search, names)):
        return  # the SRDF of the arm is elsewhere
    solved = [key.value for key, value in root.entries if isinstance(value, Mapping) and value.get("kinematics_solver")]
    if any(str(name) in names or params.named_elsewhere(str(name), {source}) for name in solved):
        return
    for name in solved:
        near = nearest(name, names)
        yield MoveItProblem("group", name, groups, near[0] if len(near) == 1 else None)


def _planners(
    tree: Tree, source: Source, groups: tuple[Located, ...] | None, params: Params
) -> Iterator[MoveItProblem]:
    """Groups that get planners where none of them is one of the robot: the SRDF, or where xacro makes that, the file of
    solvers beside it has others, which nothing but the file of planners names."""
    root = _root(source)
    if root is None:
        return
    planned = [
        key.value for key, value in root.entries if isinstance(value, Mapping) and value.sequence("planner_configs")
    ]
    known = groups
    if known is None:
        beside = tree.read(os.path.join(os.path.dirname(source.absolute), _KINEMATICS))
        solvers = _root(beside) if beside is not None else None
        solved = solvers.entries if solvers is not None else []
        known = tuple(
            key.value for key, value in solved if isinstance(value, Mapping) and value.get("kinematics_solver")
        )
        if any(params.named_elsewhere(str(name), {source}) for name in planned):
            return
    names = {str(each) for each in known}
    if planned and known and not any(str(name) in names or "$" in name for name in planned):
        near = nearest(planned[0], names)
        yield MoveItProblem("planners", planned[0], known, near[0] if len(near) == 1 else None)


def _root(source: Source) -> Mapping | None:
    documents = parse_yaml(source).documents
    root = documents[0].root if len(documents) == 1 else None
    return root if isinstance(root, Mapping) and not source.template else None


def _controllers(source: Source, params: Params) -> Iterator[MoveItProblem]:
    """Controllers to which MoveIt sends trajectories, and that no parameter file has, where one has the same joints
    under another name."""
    root = _root(source)
    manager = root.mapping(_MANAGER) if root is not None else None
    names = manager.sequence("controller_names") if manager is not None else None
    if manager is None or names is None:
        return
    known = _by_joints(params)
    every = {name for group in known.values() for name in group}
    listed = {_tail(item.value) for item in names.scalars}
    for item in names.scalars:
        own = manager.mapping(item.value)
        if own is None and "/" not in item.value and "." not in item.value:
            sections = [str(key.value) for key, value in manager.entries if isinstance(value, Mapping)]
            near = [each for each in sections if each not in listed and nearest(item.value, [each], 4)]
            yield MoveItProblem("section", item.value, (), near[0] if len(near) == 1 else None)
            continue
        joints = own.sequence("joints") if own is not None else None
        same = known.get(frozenset(str(each.value) for each in joints.scalars)) if joints is not None else None
        tail = _tail(item.value)
        if same is None or len(same) != 1 or tail in every or params.named_elsewhere(tail, {source}):
            continue
        name = next(iter(same))
        if name in listed:
            continue  # the listed one is of the simulation, this one of the driver of the robot
        yield MoveItProblem("controller", item.value, (same[name],), name)


def controller_names(source: Source) -> list[Located]:
    """The controllers to which MoveIt sends trajectories, as a file names them."""
    manager = _manager(source)
    names = manager.sequence("controller_names") if manager is not None else None
    return [item.value for item in names.scalars] if names is not None else []


def _manager(source: Source) -> Mapping | None:
    """The controllers as MoveIt gets them: launch files also load the section without its name."""
    root = _root(source)
    return root if root is None or root.sequence("controller_names") is not None else root.mapping(_MANAGER)


def _joints(source: Source, params: Params) -> Iterator[MoveItProblem]:
    """Trajectory controllers that have other joints than MoveIt sends to, in all files that configure them: they reject
    goals for some of their joints unless they are told to take them (joint_trajectory_controller.cpp)."""
    manager = _manager(source)
    if manager is None:
        return
    for name in controller_names(source):
        own = manager.mapping(name)
        sent = own.sequence("joints") if own is not None else None
        had = _joints_of(params, _tail(name))
        if sent is None or not had:
            continue
        ours = {str(each.value) for each in sent.scalars}
        if all(ours < theirs and not is_partial for _, theirs, is_partial in had):
            where, theirs, _ = had[0]
            section = next(key.value for key, _ in manager.entries if key.value == name)
            yield MoveItProblem("joints", section, (where,), f"{len(ours)} {len(theirs)}")


def _joints_of(params: Params, controller: str) -> list[tuple[Located, set[str], bool]]:
    """The joints of a trajectory controller in each parameter file that has it, and whether it takes goals for some."""
    found = []
    for _, each in params.named("joints"):
        if each.block.node_name != controller:
            continue
        given = {other.name: other.value.data for other in each.block.parameters}
        is_partial = given.get("allow_partial_joints_goal", False) is not False
        joints = {item.text for item in items(each)}
        found.append((Located(controller, each.key.span), joints, is_partial or any("$" in one for one in joints)))
    types = {each.value.data for _, each in params.named(f"{controller}.type")}
    return found if types == {"joint_trajectory_controller/JointTrajectoryController"} else []


def _without_action(source: Source) -> Iterator[MoveItProblem]:
    """Sections without ``action_ns``, for which MoveIt has no default (moveit_simple_controller_manager.cpp)."""
    root = _root(source)
    manager = root.mapping(_MANAGER) if root is not None else None
    if manager is None:
        return
    listed = set(map(str, controller_names(source)))
    for key, own in manager.entries:
        if str(key.value) in listed and isinstance(own, Mapping) and "action_ns" not in _keys(own):
            near = nearest("action_ns", sorted(_keys(own)))
            yield MoveItProblem("no-action", key.value, (), near[0] if len(near) == 1 else None)


def _keys(section: Mapping) -> set[str]:
    return {str(key.value) for key, _ in section.merged}


def _actions(source: Source, params: Params) -> Iterator[MoveItProblem]:
    """Actions that a controller does not serve, by its type in the same folder, or else in all other files."""
    root = _root(source)
    manager = root.mapping(_MANAGER) if root is not None else None
    if manager is None:
        return
    folder = os.path.dirname(source.absolute)
    for name in controller_names(source):
        own = manager.mapping(name)
        action = own.scalar("action_ns") if own is not None else None
        types = [Located(str(each.value.data), each.span) for _, each in params.named(f"{_tail(name)}.type")]
        beside = [each for each in types if os.path.dirname(each.span.source.absolute) == folder] or types
        served = _SERVED.get(str(beside[0])) if len(set(map(str, beside))) == 1 else None
        if action is None or served in (None, action.value.strip("/")):
            continue
        if not _is_asked_for(f"{_tail(name)}/{action.value.strip('/')}", params):
            yield MoveItProblem("action", action.value, (beside[-1],), served)


def _is_asked_for(action: str, params: Params) -> bool:
    """Whether nodes ask for an action by the name that MoveIt has: the robot serves it, and the type beside it is that
    of a demonstration."""
    return any(action in each.text for each in params.files.of_kind("python-node", "cpp-node"))


def _tail(name: str) -> str:
    return name.strip("/").rpartition("/")[2]


def _by_joints(params: Params) -> dict[frozenset[str], dict[str, Located]]:
    """Joints -> the trajectory controllers of parameter files that have these, with the place of their joints."""
    types: dict[str, str] = {}
    for _, each in params.parameters:
        if each.name.endswith(".type"):
            types[each.name.removesuffix(".type")] = str(each.value.data)
    found: dict[frozenset[str], dict[str, Located]] = {}
    for _, each in params.named("joints"):
        name = each.block.node_name
        if types.get(name, "").startswith(_TRAJECTORY):
            joints = frozenset(item.text for item in items(each))
            found.setdefault(joints, {})[name] = Located(name, each.key.span)
    return found
