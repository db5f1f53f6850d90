"""The names of the nodes that anything of the tree starts."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.lifecycle import full_name
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import Other
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.sources.code import Code

PUBLIC = regex(
    r"nav2_\w+|slam_toolbox|teleop_twist_\w+|joy|robot_localization|foxglove_bridge|rosbridge_server|ros2_socketcan"
    r"|realsense2_camera|\w{1,64}lidar_ros2?\w*|usb_cam|twist_mux|rosbag2_\w+|micro_ros_agent|tf2_ros|robot_state_publisher"
)
"""Packages of ROS whose programs and launch files start nodes named after what they are."""
_WORD = regex(r"[a-z]{4,}")
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


@dataclass(frozen=True, eq=False)
class _Finder:
    launch: Launch
    resolved: Callable[[Started], LaunchedNode]
    code: Callable[[Started], Code | None]
    names: NodeNames

    def take_expansion(self, expansion: Expansion) -> None:
        self.names.open |= any(isinstance(action, Other) for action, _ in expansion.actions)
        for include in expansion.includes:
            if include.target is None:
                target = place(include.file)
                _outside(target.package if target is not None else None, self.names)
        for started in expansion.nodes:
            if started.is_node:
                self.take_node(started)

    def take_node(self, started: Started) -> None:
        package = literal_text(started.package)
        name = self.resolved(started).fqn or full_name(started, self.launch.role(started))
        code = self.code(started)
        if name is not None:
            self.names.known.add(name)
        elif started.name is not None or package is None:
            self.names.open = True
        else:
            program = literal_text(started.executable) or literal_text(started.plugin) or ""
            self.names.unnamed |= _words(f"{package} {program}")
        if package == "controller_manager" or (code is not None and code.several):
            self.names.open = True
        elif package is not None and PUBLIC.fullmatch(package):
            self.names.public = True

    def take_command(self, ros: Ros) -> None:
        if ros.kind == "launch" and self.launch.named(ros.package, ros.target) is None:
            _outside(ros.package, self.names)
        elif ros.kind in ("run", "node"):
            self.names.unnamed |= _words(f"{ros.package or ''} {ros.target or ''}")
            self.names.public |= bool(ros.package and PUBLIC.fullmatch(ros.package))


def node_names(
    launch: Launch,
    ros: RosEnvironment,
    resolved: Callable[[Started], LaunchedNode],
    code: Callable[[Started], Code | None],
) -> NodeNames:
    """``resolved`` and ``code``: the node that a launch action starts, and what the tree holds of its sources."""
    finder = _Finder(launch, resolved, code, NodeNames())
    for expansion in launch.expansions:
        finder.take_expansion(expansion)
    for process in ros.launchers:
        for start in process.starts:
            finder.take_command(start.ros)
    return finder.names


def _outside(package: str | None, names: NodeNames) -> None:
    """A launch file, or a node with others inside it, that is not in the tree."""
    if package is not None and PUBLIC.fullmatch(package):
        names.public = True
        names.unnamed |= _words(package)
    else:
        names.open = True
