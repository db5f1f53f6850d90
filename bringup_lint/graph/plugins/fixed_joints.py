"""The fixed joints of the robot descriptions that robot_state_publisher publishes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.plugins.xacro_arguments import described_by
from bringup_lint.graph.plugins.xacro_includes import description
from bringup_lint.graph.plugins.xacro_joints import FixedJoint
from bringup_lint.graph.plugins.xacro_joints import XacroJoints
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import walk
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.source import Source

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
    return tree.at(paths.pop()) if len(paths) == 1 else None


def _joints(launch: Launch, tree: Tree, source: Source, is_plain: bool) -> dict[str, FixedJoint]:
    whole = description(launch.workspace, tree, source, surely=True)
    roots = [root for _, root in whole.files]
    found: dict[str, FixedJoint] = {}
    twice: set[str] = set()
    for joint in XacroJoints(roots, whole.defaults if is_plain else {}).fixed():
        if joint.child in found:
            twice.add(joint.child)
        found[joint.child] = joint
    return {child: joint for child, joint in found.items() if child not in twice}
