"""The joints and interfaces of the robot descriptions, and the controllers that are told to use others."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.params.values import items
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.model.xml import Element

_FILES = 400
"""Descriptions of one tree that are read."""
_SUBSTITUTION = regex(r"\$\{[^{}]*\}|\$\([^()]*\)")
_KNOWN_PART = 3
"""Characters of a name that must be literal for its pattern to say anything."""
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
_NO_CALLS = frozenset({"macro", "arg", "if", "unless", "include", "property", "insert_block", "attribute", "element"})


@dataclass(eq=False, slots=True)
class Described:
    """What all descriptions of a tree have together."""

    joints: set[str] = field(default_factory=set)
    patterns: set[str] = field(default_factory=set)
    """Names with computed parts, each of these written as NUL."""
    interfaces: set[str] = field(default_factory=set)
    """The command interfaces of ros2_control."""
    controlled: list[Located] = field(default_factory=list)
    """The literal names of joints in ros2_control."""
    is_open: bool = False
    """More joints may come from elsewhere, under any name."""
    is_open_interface: bool = False

    def has(self, name: str) -> bool:
        """Whether the robot has a joint of this name, or may have one."""
        return name in self.joints or any(_fits(pattern, name) for pattern in self.patterns)

    def offers(self, name: str) -> bool:
        """Whether a controller may find a joint: hardware offers its joints, whether the robot has them or not."""
        return name in self.controlled or self.has(name)


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


def described(tree: Tree) -> Described:
    found = Described()
    paths = [path for path in tree.paths if path.endswith((".urdf", ".xacro"))]
    found.is_open = len(paths) > _FILES
    for path in paths[:_FILES]:
        source = tree.read(path)
        root = parse(source).root if source is not None and not source.template else None
        if root is None:
            found.is_open = True
            continue
        for element in root.walk():
            _add(found, tree, element)
    return found


def _add(found: Described, tree: Tree, element: Element) -> None:
    name = element.get("name")
    if element.name.startswith("xacro:"):
        if element.local == "include":
            found.is_open = found.is_open or not _is_there(tree, str(element.get("filename") or ""))
        elif element.local not in _NO_CALLS:
            for attribute in element.attributes:
                _add_name(found, attribute.value)
    elif element.local == "joint" and name is not None:
        if not _is_controlled(element):
            _add_name(found, name)
        elif "$" not in name:
            found.controlled.append(name)
    elif element.local == "command_interface" and name is not None:
        found.interfaces.add(str(name))
        found.is_open_interface = found.is_open_interface or "$" in name


def _is_there(tree: Tree, filename: str) -> bool:
    base = filename.rpartition("/")[2]
    return "$" not in base and bool(base) and any(True for _ in tree.named(base))


def _is_controlled(element: Element) -> bool:
    outer = element.parent
    while outer is not None:
        if outer.local in ("ros2_control", "transmission", "gazebo", "state"):
            return True
        outer = outer.parent
    return False


def _add_name(found: Described, name: Located) -> None:
    """A name of a joint, or a value of which a macro may make one."""
    if "$" not in name:
        found.joints.update(str(name).split())
        return
    pattern = _SUBSTITUTION.sub("\0", name)
    if len(pattern.replace("\0", "")) >= _KNOWN_PART:
        found.patterns.add(pattern)


def _fits(pattern: str, name: str) -> bool:
    """Whether a name may come from a pattern; linear in both."""
    first, *middle, last = pattern.split("\0")
    if not name.startswith(first) or not name.endswith(last) or len(name) < len(first) + len(last):
        return False
    at = len(first)
    for part in middle:
        at = name.find(part, at)
        if at < 0:
            return False
        at += len(part)
    return at <= len(name) - len(last)


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
