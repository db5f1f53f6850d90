"""The fixed joints of the robot descriptions that robot_state_publisher publishes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.plugins.xacro_arguments import described_by
from bringup_lint.graph.plugins.xacro_arguments import filled
from bringup_lint.graph.plugins.xacro_includes import included
from bringup_lint.graph.plugins.xacro_joints import FixedJoint
from bringup_lint.graph.plugins.xacro_joints import XacroJoints
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import walk
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Source

_FILES = 60
"""Descriptions that one includes."""
_NAMED = regex(r"(?<![\w.-])[\w.-]+\.(?:urdf\.xacro|xacro\.urdf|urdf|xacro)(?![\w.])")
_PLAIN = 3
"""Parts of a command that gives xacro a file and nothing else."""


def published_joints(launch: Launch, tree: Tree, node: Started) -> dict[str, FixedJoint]:
    """Link -> the fixed joint by which a robot_state_publisher publishes it, where no condition has a part in it."""
    commands = [each for given in node.parameters for each in walk(given) if isinstance(each, Command)]
    if not commands:
        source, is_plain = _named(tree, node), True
    else:
        command = commands[0].command
        source = described_by(launch, tree, command) if isinstance(command, Concat) else None
        is_plain = isinstance(command, Concat) and len(command.parts) <= _PLAIN
    return _joints(launch, tree, source, is_plain) if source is not None else {}


def _named(tree: Tree, node: Started) -> Source | None:
    """The one description that the launch file names: its own code reads it."""
    paths = {path for name in set(_NAMED.findall(node.file.source.text)) for path in tree.named(name)}
    return tree.read(paths.pop()) if len(paths) == 1 else None


def _joints(launch: Launch, tree: Tree, source: Source, is_plain: bool) -> dict[str, FixedJoint]:
    arguments: dict[str, str] = {}
    roots = _roots(launch, tree, source, arguments)
    found: dict[str, FixedJoint] = {}
    twice: set[str] = set()
    for joint in XacroJoints(roots, arguments if is_plain else {}).fixed():
        if joint.child in found:
            twice.add(joint.child)
        found[joint.child] = joint
    return {child: joint for child, joint in found.items() if child not in twice}


def _roots(launch: Launch, tree: Tree, source: Source, arguments: dict[str, str]) -> list[Element]:
    """A description and what it surely includes; fills in the defaults of the arguments."""
    todo, seen = [source], {source.name}
    roots: list[Element] = []
    while todo and len(seen) < _FILES:
        each = todo.pop()
        root = parse(each).root if not each.template else None
        if root is None:
            continue
        roots.append(root)
        for element in root.children:
            if element.name == "xacro:arg":
                arguments.setdefault(str(element.get("name")), str(element.get("default") or ""))
            elif element.name == "xacro:include":
                found = included(launch.workspace, each, filled(str(element.get("filename") or ""), arguments))
                file = tree.read(found.file) if found is not None and found.file is not None else None
                if file is not None and file.name not in seen:
                    seen.add(file.name)
                    todo.append(file)
    return roots
