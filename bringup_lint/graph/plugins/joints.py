"""Controllers that are told to use joints or interfaces that no robot description has."""

from __future__ import annotations

from collections.abc import Container
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
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
_COMMANDED = "command_joints"
"""Joints of a trajectory controller under the names by which it commands them."""
_PLAIN = regex(r"[\w.-]+\Z")
"""A name without placeholders."""
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


def unknown_joints(files: Files, params: Params, packages: Container[str]) -> Iterator[UnknownJoint]:
    """Only where the tree holds all descriptions, and a controller of the same file uses a joint of theirs."""
    if not files.of_kind("urdf"):
        return
    known = described(files.tree, packages)
    if known.is_open or not known.joints:
        return
    for file in params.judged:
        if file.accepted and not file.uncertain:
            for found in _of_file(known, file, packages):
                yield found._replace(used=params.named_elsewhere(found.controller, {file.source}))
    if files.target.ros in _CHECKED:
        yield from _uncontrolled(known)


def _of_file(known: Described, file: ParameterFile, packages: Container[str]) -> Iterator[UnknownJoint]:
    named = list(_named(file, packages))
    lists = [(each, controller) for each, controller in named if each.name in _JOINTS]
    if not any(known.offers(item.text) for each, _ in lists for item in items(each)):
        return
    for each, controller in lists:
        yield from _joints(known, each, controller)
    if known.interfaces and not known.is_open_interface:
        for each, controller in named:
            if each.name in _INTERFACES:
                yield from _interfaces(known, each, controller)


def _named(file: ParameterFile, packages: Container[str]) -> Iterator[tuple[Parameter, str]]:
    """The parameters of the controllers that use the hardware itself, each with the name of its controller."""
    types = _types(file)
    own: dict[str, list[Parameter]] = {}
    for each in file.parameters:
        controller = str(each.block.key).rpartition("/")[2]
        if controller in types and _is_known(types[controller], packages):
            own.setdefault(controller, []).append(each)
    for controller, parameters in own.items():
        if not any(_is_chained(each) for each in parameters):
            yield from ((each, controller) for each in parameters)


def _types(file: ParameterFile) -> dict[str, str]:
    """The name of a controller -> its type."""
    return {
        each.name.removesuffix(".type"): str(each.value.data)
        for each in file.parameters
        if each.name.endswith(".type") and str(each.block.key).rpartition("/")[2] in ("controller_manager", "**")
    }


def _is_known(of_type: str, packages: Container[str]) -> bool:
    """Whether a controller takes its joints for those of the robot: one of the tree may mean something else by them."""
    return not of_type.startswith(_ANY) and of_type.partition("/")[0] not in packages


def _is_chained(parameter: Parameter) -> bool:
    """Whether a parameter names a reference of another controller, as ``pid_controller/wheel_joint``."""
    return parameter.name in (*_JOINTS, _COMMANDED) and any("/" in item.text for item in items(parameter))


def _joints(known: Described, parameter: Parameter, controller: str) -> Iterator[UnknownJoint]:
    lacking = [item for item in items(parameter) if _PLAIN.match(item.text) and not known.offers(item.text)]
    if lacking:
        first, *others = lacking
        near = nearest(first.text, sorted(known.joints), 4)
        like = near[0] if len(near) == 1 else None
        yield UnknownJoint(first.text, first.span, controller, "joint", like, tuple(one.span for one in others))


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
