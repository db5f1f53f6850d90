"""What publishes the transform from odometry to the robot: filters of robot_localization and drive controllers."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.resolved.parameters import given_parameters
from bringup_lint.graph.topics.resolved.process_arguments import ros_arguments
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Running
    from bringup_lint.graph.topics.resolved.parameters import GivenParameters
    from bringup_lint.graph.topics.resolved.parameters import ParameterSources
    from bringup_lint.source import Span

FILTERS = ("ekf_node", "ukf_node")
MANAGER = "controller_manager"
"""The name that ros2_control_node gives itself."""
DRIVE = "diff_drive_controller/DiffDriveController"
"""Other drive controllers publish on a topic of their own, or are not sure to publish."""


class TransformSource(NamedTuple):
    """Who publishes a transform on /tf."""

    node: LaunchedNode
    """The filter, or the manager of the controller."""
    name: str
    parent: str
    child: str
    switch: str
    """The parameter that turns it off."""
    where: Span
    """Where that is set, or what starts it where the default holds."""


def rival_transforms(running: Running, sources: ParameterSources) -> Iterator[tuple[TransformSource, TransformSource]]:
    """Two that surely start together and publish one transform, the controller first; of one name only one starts."""
    found = [*_drives(running, sources), *_filters(running)]
    for one, other in combinations(found, 2):
        same = (one.parent, one.child) == (other.parent, other.child)
        if same and one.name != other.name and coexist(one.node, other.node):
            yield one, other


def _filters(running: Running) -> Iterator[TransformSource]:
    """Source of the defaults: ros_filter.cpp of robot_localization."""
    for node in running.nodes:
        if literal_text(node.started.package) != "robot_localization" or _is_remapped(node):
            continue
        if str(literal_text(node.started.executable)) not in FILTERS or node.given is None:
            continue
        yield from filter_source(node, node.given, node.label())


def filter_source(node: LaunchedNode, given: GivenParameters, name: str) -> Iterator[TransformSource]:
    """What a filter publishes from its odometry frame to the robot."""
    odometry = _value(given, "odom_frame", "odom")
    base = _value(given, "base_link_frame", "base_link")
    parent = _value(given, "world_frame", odometry)
    child = _value(given, "base_link_frame_output", base)
    if parent is not None and parent == odometry and child is not None:
        yield from _source(node, given, name, "publish_tf", (parent, child))


def _drives(running: Running, sources: ParameterSources) -> Iterator[TransformSource]:
    """Source of the defaults: diff_drive_controller_parameter.yaml, Humble to Kilted."""
    managers = [node for node in running.nodes if is_manager(node.started)]
    if len(managers) != 1 or _is_remapped(managers[0]) or managers[0].namespace != "/":
        return
    manager = managers[0]
    arguments = ros_arguments(manager.started)
    own = given_parameters(sources, manager.started, f"/{manager.name or MANAGER}", arguments)
    for _, name in spawned([node.started for node in running.nodes]):
        if _value(own, f"{name}.type", "") != DRIVE:
            continue
        given = given_parameters(sources, manager.started, f"/{name}", arguments)
        parent, child = _value(given, "odom_frame_id", "odom"), _value(given, "base_frame_id", "base_link")
        if parent and child and not given.values.keys() & {"tf_frame_prefix"}:
            yield from _source(manager, given, str(name), "enable_odom_tf", (parent, child))


def _source(
    node: LaunchedNode, given: GivenParameters, name: str, switch: str, frames: tuple[str, str]
) -> Iterator[TransformSource]:
    setting = given.values.get(switch)
    if setting is not None and setting.value is True:
        yield TransformSource(node, name, *frames, switch, setting.where)
    elif setting is None and not given.open:
        yield TransformSource(node, name, *frames, switch, node.started.span)


def _value(given: GivenParameters, name: str, default: str | None) -> str | None:
    """The text of a parameter; None when it is not known."""
    if name in given.values:
        value = given.values[name].value
        return value if isinstance(value, str) else None
    return None if given.open else default


def _is_remapped(node: LaunchedNode) -> bool:
    """Whether transforms may go to another topic than /tf."""
    names = [text_of(old) for old, _ in node.started.remappings]
    return any(name is None or name.rpartition("/")[2] == "tf" for name in names) or bool(node.started.arguments)
