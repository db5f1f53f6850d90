"""The names of the nodes that anything of the tree starts."""

from __future__ import annotations

import re
from dataclasses import dataclass
from dataclasses import field
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.lifecycle import full_name
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import Other

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.topics.topics import Topics

PUBLIC = re.compile(
    r"nav2_\w+|slam_toolbox|teleop_twist_\w+|joy|robot_localization|foxglove_bridge|rosbridge_server|ros2_socketcan"
    r"|realsense2_camera|\w+lidar_ros2?\w*|usb_cam|twist_mux|rosbag2_\w+|micro_ros_agent|tf2_ros|robot_state_publisher"
)
"""Packages of ROS whose programs and launch files start nodes named after what they are."""
_WORD = re.compile(r"[a-z]{4,}")
_COMMON = frozenset(("node", "driver", "ros2", "main", "controller", "manager", "server", "publisher", "robot"))


@dataclass(eq=False)
class NodeNames:
    known: set[str] = field(default_factory=set)
    """Full names."""
    unnamed: set[str] = field(default_factory=set)
    """Words of packages and executables of nodes whose names are not known."""
    public: bool = False
    """Launch files or nodes of ``PUBLIC`` packages, with other nodes than are known, are started too."""
    open: bool = False
    """Anything else may be started."""

    def may_be(self, name: str) -> bool:
        """Whether a node whose name is not known may be called so."""
        return bool(_words(name) & self.unnamed)


def _words(text: str) -> set[str]:
    return set(_WORD.findall(text.lower())) - _COMMON


def node_names(topics: Topics) -> NodeNames:
    names = NodeNames()
    for expansion in topics.robot.launch.expansions:
        _expansion(topics, expansion, names)
    for process in topics.robot.ros.launchers:
        for launching in process.starts:
            _command(topics, launching.ros, names)
    return names


def _expansion(topics: Topics, expansion: Expansion, names: NodeNames) -> None:
    names.open |= any(isinstance(action, Other) for action, _ in expansion.actions)
    for include in expansion.includes:
        if include.target is None:
            target = place(include.file)
            _outside(target.package if target is not None else None, names)
    for started in expansion.nodes:
        if started.is_node:
            _node(topics, started, names)


def _outside(package: str | None, names: NodeNames) -> None:
    """A launch file, or a node with others inside it, that is not in the tree."""
    if package is not None and PUBLIC.fullmatch(package):
        names.public = True
        names.unnamed |= _words(package)
    else:
        names.open = True


def _node(topics: Topics, started: Started, names: NodeNames) -> None:
    package = literal_text(started.package)
    name = topics.node(started).fqn or full_name(started, topics.robot.launch.role(started))
    code = topics.code(started)
    if name is not None:
        names.known.add(name)
    elif started.name is not None or package is None:
        names.open = True
    else:
        program = literal_text(started.executable) or literal_text(started.plugin) or ""
        names.unnamed |= _words(f"{package} {program}")
    if package == "controller_manager" or (code is not None and code.several):
        names.open = True
    elif package is not None and PUBLIC.fullmatch(package):
        names.public = True


def _command(topics: Topics, ros: Ros, names: NodeNames) -> None:
    if ros.kind == "launch" and topics.robot.launch.named(ros.package, ros.target) is None:
        _outside(ros.package, names)
    elif ros.kind in ("run", "node"):
        names.unnamed |= _words(f"{ros.package or ''} {ros.target or ''}")
        names.public |= bool(ros.package and PUBLIC.fullmatch(ros.package))
