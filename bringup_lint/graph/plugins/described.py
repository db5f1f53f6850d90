"""The joints and interfaces that the robot descriptions of a tree have together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.model.xml import Element

_FILES = 400
"""Descriptions of one tree that are read."""
_SUBSTITUTION = regex(r"\$\{[^{}]*\}|\$\([^()]*\)")
_KNOWN_PART = 3
"""Characters of a name that must be literal for its pattern to say anything."""
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
