"""Integers in the joint limits of a package for MoveIt, which reads doubles."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.yaml_nodes import parse

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.source import Source

_FILE = "joint_limits.yaml"
_PLACE = f"config/{_FILE}"
"""Where MoveItConfigsBuilder looks for it, in its package."""
_SECTION = "joint_limits"
_READ_IF = {
    "min_position": "",
    "max_position": "",
    "max_velocity": "has_velocity_limits",
    "max_acceleration": "has_acceleration_limits",
    "max_jerk": "has_jerk_limits",
}
"""Limits that MoveIt declares as doubles, and what has to be true before it does.
Source: moveit_ros, robot_model_loader.cpp."""


def integer_limits(params: Params) -> Iterator[tuple[str, Scalar]]:
    """The limits that are integers, with their names, where the package has the SRDF that MoveIt needs beside them."""
    tree, workspace = params.files.tree, params.launch().workspace
    for path in tree.named(_FILE):
        source = tree.at(path)
        owner = workspace.owner(source) if source is not None else None
        if source is None or owner is None or not source.judged or source.template:
            continue
        if path != os.path.join(owner.folder, _PLACE):
            continue
        if any(".srdf" in each for each in tree.walked_below(owner.folder)):
            yield from _of_file(source)


def _of_file(source: Source) -> Iterator[tuple[str, Scalar]]:
    for document in parse(source).documents:
        joints = document.root.mapping(_SECTION) if isinstance(document.root, Mapping) else None
        if joints is not None:
            for _, joint in joints.entries:
                yield from _of_joint(joint) if isinstance(joint, Mapping) else ()


def _of_joint(joint: Mapping) -> Iterator[tuple[str, Scalar]]:
    for name, condition in _READ_IF.items():
        value, asked = joint.scalar(name), joint.scalar(condition)
        if value is not None and value.integer is not None and (not condition or (asked and asked.boolean)):
            yield name, value
