"""The joints and interfaces that the robot descriptions of a tree have together."""

from __future__ import annotations

from collections.abc import Container
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.plugins.xacro_values import HOLE
from bringup_lint.graph.plugins.xacro_values import XacroValues
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.model.xml import Element

_FILES = 400
"""Descriptions of one tree that are read."""
_SUBSTITUTION = regex(r"\$\{[^{}]*\}|\$\([^()]*\)")
_QUOTED = regex(r"'([^'{}$]*)'|\"([^\"{}$]*)\"")
_DEFAULT = regex(r":=\^?\|?(?P<quote>['\"]?)(?P<value>[^\s'\"]+)(?P=quote)")
"""The value that a parameter of a macro has when a call does not give it."""
_FOUND = regex(r"\$\(find\s(?P<package>[^()$]+)\)/(?P<rest>[^$]+)\Z")
_INCLUDED = regex(r"<xacro:include\s[^<>]{0,300}?\bfilename\s*=\s*[\"']([^\"'<>]{1,300})[\"']", hints="xacro:include")
_SENSOR = regex(
    r"(?i)realsense|camera|velodyne|ouster|lidar|laser|hokuyo|depthai|_imu|kinect|orbbec|livox|materials"
    r"|(?<![a-z])(?:zed[mx]?|sick|oak|astra)(?![a-z])"
)
"""Packages and files that describe sensors."""
_KNOWN_PART = 2
"""Characters of a value that must be literal for its pattern to say anything."""
_FORMATS = (".urdf", ".xacro", ".sdf")
_HOLDERS = ("joint", "gpio", "sensor")
"""Elements of ros2_control whose names a controller may take for those of joints."""
_NO_CALLS = frozenset({"macro", "arg", "if", "unless", "include", "property", "insert_block", "attribute", "element"})


@dataclass(eq=False, slots=True)
class Described:
    """What all descriptions of a tree have together."""

    joints: set[str] = field(default_factory=set)
    patterns: set[str] = field(default_factory=set)
    """Names with computed parts, each of these written as NUL."""
    values: set[str] = field(default_factory=set)
    """The values of properties and defaults, of which xacro may make names."""
    links: set[str] = field(default_factory=set)
    link_patterns: set[str] = field(default_factory=set)
    interfaces: set[str] = field(default_factory=set)
    """The command interfaces of ros2_control."""
    controlled: list[Located] = field(default_factory=list)
    """The literal names of joints in ros2_control."""
    offered: set[str] = field(default_factory=set)
    """The literal names of joints, GPIOs and sensors in ros2_control."""
    hardware: set[str] = field(default_factory=set)
    """The names of joints, GPIOs and sensors in ros2_control, with what xacro makes of them."""
    hardware_patterns: set[str] = field(default_factory=set)
    components: dict[str, Located] = field(default_factory=dict)
    """The names of ``<ros2_control>``."""
    is_open: bool = False
    """More joints may come from elsewhere, under any name."""
    is_open_interface: bool = False
    is_open_hardware: bool = False
    """More of ros2_control may come from elsewhere, under any name."""
    is_open_component: bool = False

    def has(self, name: str) -> bool:
        """Whether the robot has a joint of this name, or may have one."""
        return name in self.joints or name in self.values or any(_fits(pattern, name) for pattern in self.patterns)

    def has_link(self, name: str) -> bool:
        """Whether the robot has a link of this name, or may have one."""
        return name in self.links or name in self.values or any(_fits(each, name) for each in self.link_patterns)

    def offers(self, name: str) -> bool:
        """Whether a controller may find a joint: hardware offers its joints, whether the robot has them or not."""
        return name in self.offered or self.has(name)

    def exports(self, name: str) -> bool:
        """Whether hardware of ros2_control has interfaces under a name, or may have."""
        return name in self.hardware or any(_fits(each, name) for each in self.hardware_patterns)


def descriptions(tree: Tree) -> list[str]:
    """The paths of all descriptions of robots."""
    return [path for path in tree.paths if path.endswith(_FORMATS) or ".urdf." in path.rpartition("/")[2]]


def included_from(tree: Tree, paths: list[str]) -> list[str]:
    """Descriptions with all of the tree that they include, directly or not."""
    found, todo = dict.fromkeys(paths), list(paths)
    while todo and len(found) <= _FILES:
        source = tree.at(todo.pop())
        names = _INCLUDED.findall(source.text) if source is not None else []
        for path in (each for name in names for each in tree.named(name.rpartition("/")[2])):
            if path not in found:
                found[path] = None
                todo.append(path)
    return list(found)


def included_names(tree: Tree) -> set[str]:
    """The names of the files that some description includes."""
    sources = (source for path in descriptions(tree) if (source := tree.at(path)) is not None)
    return {name.rpartition("/")[2] for source in sources for name in _INCLUDED.findall(source.text)}


def includes_elsewhere(tree: Tree, packages: Container[str], paths: list[str]) -> bool:
    """Whether one of these descriptions includes a file that the tree does not have."""
    sources = (source for path in paths if (source := tree.at(path)) is not None)
    names = (name for source in sources for name in _INCLUDED.findall(source.text))
    return not all(_is_there(tree, packages, name) for name in names)


def described(tree: Tree, packages: Container[str], paths: list[str] | None = None) -> Described:
    """``packages``: those of the tree, from which descriptions include others; ``paths``: all when it is None."""
    found = Described()
    paths = descriptions(tree) if paths is None else paths
    found.is_open = found.is_open_hardware = len(paths) > _FILES
    roots: list[Element] = []
    values = XacroValues()
    for path in paths[:_FILES]:
        source = tree.at(path)
        root = parse(source).root if source is not None and not source.template else None
        if root is None:
            found.is_open = True
            found.is_open_hardware |= source is None or "ros2_control" in source.text
            continue
        roots.append(root)
        values.take(root)
    for element in (each for root in roots for each in root.walk()):
        if element.name.startswith("xacro:"):
            _add_values(found, element)
            found.is_open = found.is_open or not _is_closed(tree, packages, element)
            found.is_open_hardware |= _brings_hardware(tree, packages, element)
        else:
            _add(found, element, values)
    return found


def _add(found: Described, element: Element, values: XacroValues) -> None:
    name = element.get("name")
    if name is None:
        return
    if element.local == "link":
        _add_names(found, found.links, found.link_patterns, values.names(name, element))
        return
    _add_hardware(found, element, values)
    is_controlled = _is_controlled(element)
    if element.local == "joint" and not is_controlled:
        _add_names(found, found.joints, found.patterns, values.names(name, element))
    elif element.local in _HOLDERS and is_controlled and "$" not in name:
        found.offered.add(str(name))
        if element.local == "joint":
            found.controlled.append(name)
    elif element.local == "command_interface":
        found.interfaces.add(str(name))
        found.is_open_interface = found.is_open_interface or "$" in name


def _add_hardware(found: Described, element: Element, values: XacroValues) -> None:
    """What hardware of ros2_control exports interfaces for: it lies in it, or a macro that is called in it has it."""
    name = element.get("name")
    if name is None:
        return
    if element.local == "ros2_control":
        for each in values.names(name, element):
            found.components.setdefault(each, name)
            found.is_open_component |= "$" in each or HOLE in each
    is_part = any(each.local in ("command_interface", "state_interface") for each in element.children)
    if element.local in _HOLDERS and (is_part or _is_within(element, "ros2_control")):
        for each in values.names(name, element):
            if "$" in each or not each.strip(HOLE):
                found.is_open_hardware = True
            elif HOLE in each:
                found.hardware_patterns.add(each)
            else:
                found.hardware.add(each)


def _add_names(found: Described, plain: set[str], patterns: set[str], names: set[str]) -> None:
    for name in names:
        if "$" in name:
            found.is_open = True
        elif HOLE not in name:
            plain.add(name)
        elif name.strip(HOLE):
            patterns.add(name)


def _add_values(found: Described, element: Element) -> None:
    """The values of which xacro may make the names of joints."""
    if element.local in ("property", "arg"):
        for value in (element.get("value"), element.get("default")):
            _add_words(found, str(value or ""))
    elif element.local == "macro":
        found.values.update(match["value"] for match in _DEFAULT.finditer(str(element.get("params") or "")))
    elif element.local not in _NO_CALLS:
        for attribute in element.attributes:
            _add_name(found, attribute.value, _KNOWN_PART)
            _add_words(found, attribute.value)


def _add_words(found: Described, value: str) -> None:
    """The text itself, or the texts of an expression."""
    if "$" not in value:
        found.values.update(value.split())
    found.values.update(match[1] or match[2] or "" for match in _QUOTED.finditer(value))


def _is_closed(tree: Tree, packages: Container[str], element: Element) -> bool:
    """Whether all that an element of xacro brings is in the tree."""
    if element.local == "include":
        return _is_there(tree, packages, str(element.get("filename") or ""))
    return not any("load_yaml" in attribute.value for attribute in element.attributes)


def _brings_hardware(tree: Tree, packages: Container[str], element: Element) -> bool:
    """Whether an element includes a file from outside of the tree that may hold ros2_control: those of sensors do
    not."""
    if element.local != "include":
        return False
    filename = str(element.get("filename") or "")
    match = _FOUND.match(filename)
    is_of_sensor = _SENSOR.search(filename) and "control" not in filename.rpartition("/")[2]
    if is_of_sensor or (match is not None and match["package"].strip() in packages):
        return False
    return not _is_there(tree, packages, filename)


def _is_there(tree: Tree, packages: Container[str], filename: str) -> bool:
    match = _FOUND.match(filename)
    if match is not None and match["package"].strip() not in packages:
        return False
    base = filename.rpartition("/")[2]
    ending = f"/{match['rest']}" if match is not None else base
    return "$" not in base and bool(base) and any(f"/{path}".endswith(ending) for path in tree.named(base))


def _is_controlled(element: Element) -> bool:
    return _is_within(element, "ros2_control", "transmission", "gazebo", "state")


def _is_within(element: Element, *names: str) -> bool:
    return any(each.local in names for each in element.ancestors)


def _add_name(found: Described, name: Located, known_part: int) -> None:
    """A name of a joint, or a value of which a macro may make one, with the characters of it that must be literal."""
    if "$" not in name:
        found.joints.update(str(name).split())
        return
    pattern = _SUBSTITUTION.sub("\0", name)
    if "$" in pattern:
        found.is_open = True
    elif len(pattern.replace("\0", "")) >= known_part:
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
