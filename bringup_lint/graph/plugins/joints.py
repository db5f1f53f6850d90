"""Controllers that are told to use joints or interfaces that no robot description has."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_JOINTS = (
    *("joints", "joint", "left_wheel_names", "right_wheel_names", "rear_wheels_names", "front_wheels_names"),
    *("traction_joints_names", "steering_joints_names", "rear_wheel_joint_names", "front_wheel_joint_names"),
)
"""Parameters of ros2_controllers that name joints."""
_INTERFACES = ("command_interfaces", "interface_name")
_CHECKED = ("jazzy", "kilted", "lyrical", "rolling")
"""Releases that refuse hardware for a joint which the robot does not have (component_parser.cpp)."""
_ANY = ("joint_state_broadcaster/",)
"""Controllers that start without their joints."""


class UnknownJoint(NamedTuple):
    name: str
    where: Span
    controller: str
    """Empty where a description itself names the joint in ros2_control."""
    kind: str
    """``joint`` or ``interface``."""
    like: str | None
    others: tuple[Span, ...] = ()
    used: bool = True
    """Another file names the controller: something may spawn it."""


def unknown_joints(files: Files, params: Params) -> Iterator[UnknownJoint]:
    """Only where the tree holds all descriptions, and a controller of the same file uses a joint of theirs."""
    if not files.of_kind("urdf"):
        return
    known = described(files.tree)
    if known.is_open or not known.joints:
        return
    for file in params.judged:
        if file.accepted and not file.uncertain:
            for found in _of_file(known, file):
                yield found._replace(used=params.named_elsewhere(found.controller, {file.source}))
    if files.target.ros in _CHECKED:
        yield from _uncontrolled(known)


def _of_file(known: Described, file: ParameterFile) -> Iterator[UnknownJoint]:
    types = {
        each.name.removesuffix(".type"): str(each.value.data)
        for each in file.parameters
        if each.name.endswith(".type") and str(each.block.key).rpartition("/")[2] in ("controller_manager", "**")
    }
    named: list[tuple[Parameter, str]] = []
    for each in file.parameters:
        controller = str(each.block.key).rpartition("/")[2]
        if controller in types and not types[controller].startswith(_ANY):
            named.append((each, controller))
    lists = [(each, controller) for each, controller in named if each.name in _JOINTS]
    if not any(known.offers(item.text) for each, _ in lists for item in items(each)):
        return
    for each, controller in lists:
        lacking = [item for item in items(each) if item.text and not known.offers(item.text) and "$" not in item.text]
        if lacking:
            first, *others = lacking
            near = nearest(first.text, sorted(known.joints), 4)
            like = near[0] if len(near) == 1 else None
            yield UnknownJoint(first.text, first.span, controller, "joint", like, tuple(one.span for one in others))
    if known.interfaces and not known.is_open_interface:
        for each, controller in named:
            if each.name in _INTERFACES:
                yield from _interfaces(known, each, controller)


def _interfaces(known: Described, parameter: Parameter, controller: str) -> Iterator[UnknownJoint]:
    for item in items(parameter):
        if item.text and item.text not in known.interfaces:
            like = ", ".join(sorted(known.interfaces))
            yield UnknownJoint(item.text, item.span, controller, "interface", like)


def _uncontrolled(known: Described) -> Iterator[UnknownJoint]:
    """Joints of ros2_control that the robot does not have."""
    for name in known.controlled:
        if name.span.source.judged and not known.has(name):
            near = nearest(name, sorted(known.joints), 4)
            yield UnknownJoint(str(name), name.span, "", "joint", near[0] if len(near) == 1 else None)
