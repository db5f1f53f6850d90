"""Controllers that are told to use joints or interfaces that no robot description has."""

from __future__ import annotations

import os
import re
from collections.abc import Container
from collections.abc import Iterator
from collections.abc import Mapping
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import is_below
from bringup_lint.endings import CPP
from bringup_lint.graph.memo import kept
from bringup_lint.graph.params.values import Item
from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.graph.plugins.described import descriptions
from bringup_lint.graph.plugins.described import included_from
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Source

_JOINTS = (
    *("joints", "joint", "left_wheel_names", "right_wheel_names", "rear_wheels_names", "front_wheels_names"),
    *("traction_joints_names", "steering_joints_names", "rear_wheel_joint_names", "front_wheel_joint_names"),
)
"""Parameters of ros2_controllers that name joints."""
_SENSORS = ("sensor_name", "gpios", "ft_sensor.name")
"""Parameters of controllers that name sensors and GPIOs of ros2_control."""
_WITH_INTERFACE = "interface_names."
"""The beginning of parameters that name an interface with its sensor, as ``wrist/force.x``."""
_COMMANDED = "command_joints"
"""Joints of a trajectory controller under the names by which it commands them."""
_PLAIN = regex(r"[\w.-]+\Z")
"""A name without placeholders."""
_INTERFACES = ("command_interfaces", "interface_name")
_WITH_JOINT = ("max_effort_interface", "max_velocity_interface")
"""Parameters of a gripper's controller that name a command interface with its joint, as ``finger_joint/effort``."""
_USUAL = ("position", "velocity", "acceleration", "effort")
_EXPORTS = (
    r"(?:\bCommandInterface\s*[({{]|\bcommand_interfaces?\w*\.(?:emplace|push)_back\s*\()"
    r"[^;]{{0,200}}(?:\bHW_IF_{constant}\b|\"{name}\")"
)
"""A command that hardware exports in C++, whatever the description says."""
_CHECKED = ("jazzy", "kilted", "lyrical", "rolling")
"""Releases that refuse hardware for a joint which the robot does not have (component_parser.cpp)."""
_MANAGER = "controller_manager"
_STATES = ("hardware_components_initial_state.", "configure_components_on_start", "activate_components_on_start")
"""Parameters of the controller manager that name hardware (controller_manager.cpp)."""
_HEAD = 200_000
"""Characters of a description or a source that are looked at."""
_ANY = ("joint_state_broadcaster/",)
"""Controllers that start without their joints."""


class UnknownJoint(NamedTuple):
    name: str
    where: Span
    controller: str
    """Empty where a description itself names the joint in ros2_control."""
    kind: str
    """``joint``, ``hardware`` where no ros2_control has it, ``interface``, or ``component`` for a name of hardware."""
    like: str | None
    others: tuple[Span, ...] = ()
    used: bool = True
    """Another file names the controller: something may spawn it."""


def unknown_joints(files: Files, params: Params, packages: Mapping[str, Package]) -> Iterator[UnknownJoint]:
    """Only where the tree holds all descriptions, and a controller of the same file uses a joint of theirs."""
    if not files.of_kind("urdf"):
        return
    known = described(files.tree, packages)
    scopes = Scopes(files.tree, packages, known)
    for file in params.judged:
        if not file.accepted or file.uncertain:
            continue
        said: set[Span] = set()
        for found in _of_file(files, known, file, packages):
            said |= {found.where, *found.others}
            yield found._replace(used=params.named_elsewhere(found.controller, {file.source}))
        scope = scopes.of(file.source)
        yield from _of_components(scope, file)
        for found in _of_hardware(files, scope, file, packages):
            if found.where not in said:
                yield found._replace(used=params.named_elsewhere(found.controller, {file.source}))
    if files.target.ros in _CHECKED and not known.is_open and known.joints:
        yield from _uncontrolled(known)


class Scopes:
    """The descriptions that go with a parameter file: those of its package, where they have ros2_control, else all."""

    def __init__(self, tree: Tree, packages: Mapping[str, Package], every: Described) -> None:
        self._tree = tree
        self._packages = packages
        self._every = every
        self._known: dict[str, Described] = {}

    def of(self, source: Source) -> Described:
        owner = next((each for each in self._packages.values() if is_below(source.absolute, (each.folder,))), None)
        if owner is None:
            return self._every
        if owner.name not in self._known:
            own = [path for path in descriptions(self._tree) if is_below(os.path.abspath(path), (owner.folder,))]
            is_whole = any("<ros2_control" in self._tree.head(path, _HEAD) for path in own)
            paths = included_from(self._tree, own) if is_whole else []
            self._known[owner.name] = described(self._tree, self._packages, paths) if is_whole else self._every
        return self._known[owner.name]


def _of_components(known: Described, file: ParameterFile) -> Iterator[UnknownJoint]:
    """Hardware whose state at the start is set, under a name that no ``<ros2_control>`` has."""
    if known.is_open_hardware or known.is_open_component or not known.components:
        return
    for each in file.parameters:
        if each.block.node_name == _MANAGER and each.name.startswith(_STATES):
            for item in items(each):
                if item.text not in known.components:
                    near = nearest(item.text, sorted(known.components), 6) or [
                        name for name in known.components if item.text and name.endswith(item.text)
                    ]
                    like = near[0] if len(near) == 1 else None
                    yield UnknownJoint(item.text, item.span, _MANAGER, "component", like)


def _of_hardware(
    files: Files, known: Described, file: ParameterFile, packages: Container[str]
) -> Iterator[UnknownJoint]:
    """Joints and sensors for which no hardware of ros2_control has interfaces, whether the robot has them or not."""
    if known.is_open_hardware or not (known.hardware or known.hardware_patterns):
        return
    if not any(known.exports(item.text) for each in file.parameters for item in _parts(each)):
        return
    said: set[tuple[str, str]] = set()
    for each, controller in _named(file, packages):
        lacking = [item for item in _parts(each) if _PLAIN.match(item.text) and not known.exports(item.text)]
        lacking = [item for item in lacking if (controller, item.text) not in said]
        said |= {(controller, item.text) for item in lacking}
        if lacking and not any(_is_in_code(files, item.text) for item in lacking):
            first, *others = lacking
            near = nearest(first.text, sorted(known.hardware), 4)
            like = near[0] if len(near) == 1 else None
            yield UnknownJoint(first.text, first.span, controller, "hardware", like, tuple(one.span for one in others))


def _parts(parameter: Parameter) -> list[Item]:
    """The joints, sensors and GPIOs that a parameter names."""
    if parameter.name in (*_JOINTS, *_SENSORS):
        return list(items(parameter))
    if not parameter.name.startswith(_WITH_INTERFACE):
        return []
    return [item._replace(text=item.text.rpartition("/")[0]) for item in items(parameter)]


def _is_in_code(files: Files, name: str) -> bool:
    """Whether a source names a joint or a sensor: hardware may export it by itself."""
    return any(f'"{name}{end}' in text for text in _code(files) for end in ('"', "/"))


@kept
def _code(files: Files) -> list[str]:
    return [files.tree.head(path, _HEAD) for path in files.tree.paths if path.endswith(CPP)]


@kept
def _exporting(files: Files) -> list[str]:
    """The code that may export commands."""
    return [text for text in _code(files) if "ommand" in text]


def _of_file(files: Files, known: Described, file: ParameterFile, packages: Container[str]) -> Iterator[UnknownJoint]:
    if known.is_open or not known.joints:
        return
    named = list(_named(file, packages))
    lists = [(each, controller) for each, controller in named if each.name in _JOINTS]
    if not any(known.offers(item.text) for each, _ in lists for item in items(each)):
        return
    for each, controller in lists:
        yield from _joints(known, each, controller)
    if known.interfaces and not known.is_open_interface:
        for each, controller in named:
            if each.name in (*_INTERFACES, *_WITH_JOINT):
                yield from _interfaces(files, known, each, controller)


def _named(file: ParameterFile, packages: Container[str]) -> Iterator[tuple[Parameter, str]]:
    """The parameters of the controllers that use the hardware itself, each with the name of its controller."""
    types = _types(file)
    own: dict[str, list[Parameter]] = {}
    for each in file.parameters:
        controller = each.block.node_name
        if controller in types and _is_known(types[controller], packages):
            own.setdefault(controller, []).append(each)
    for controller, parameters in own.items():
        if not any(_is_chained(each) for each in parameters):
            yield from ((each, controller) for each in parameters)


def _types(file: ParameterFile) -> dict[str, str]:
    """The name of a controller -> its type, as the manager is given it, or the spawner with its other parameters."""
    own = {each.block.node_name: str(each.value.data) for each in file.parameters if each.name == "type"}
    given = {
        each.name.removesuffix(".type"): str(each.value.data)
        for each in file.parameters
        if each.name.endswith(".type") and each.block.node_name in (_MANAGER, "**")
    }
    return {name: of_type for name, of_type in own.items() if "/" in of_type} | given


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


def _interfaces(files: Files, known: Described, parameter: Parameter, controller: str) -> Iterator[UnknownJoint]:
    for item in items(parameter):
        name = item.text.rpartition("/")[2] if parameter.name in _WITH_JOINT else item.text
        if name and name not in known.interfaces and not _is_made_in_code(files, known, name):
            like = ", ".join(sorted(known.interfaces))
            yield UnknownJoint(name, item.span, controller, "interface", like)


def _is_made_in_code(files: Files, known: Described, name: str) -> bool:
    """Whether hardware may export a command that no description has: code of the tree does, or it is one of the names
    that only a driver gives, as the grippers that have ``set_gripper_max_effort``."""
    if name not in _USUAL and not nearest(name, sorted(known.interfaces), 4):
        return True
    exports = re.compile(_EXPORTS.format(name=re.escape(name), constant=re.escape(name.upper())))
    return any(exports.search(text) is not None for text in _exporting(files))


def _uncontrolled(known: Described) -> Iterator[UnknownJoint]:
    """Joints of ros2_control that the robot does not have."""
    for name in known.controlled:
        if name.span.source.judged and not known.has(name):
            near = nearest(name, sorted(known.joints), 4)
            yield UnknownJoint(str(name), name.span, "", "joint", near[0] if len(near) == 1 else None)
