"""An RViz configuration: the topics that its displays subscribe, with the quality of service that is set for them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_nodes import parse as parse_yaml
from bringup_lint.source import Located
from bringup_lint.source import Source

TYPES = {
    "rviz_default_plugins/Image": "sensor_msgs/msg/Image",
    "rviz_default_plugins/LaserScan": "sensor_msgs/msg/LaserScan",
    "rviz_default_plugins/Map": "nav_msgs/msg/OccupancyGrid",
    "rviz_default_plugins/MarkerArray": "visualization_msgs/msg/MarkerArray",
    "rviz_default_plugins/Odometry": "nav_msgs/msg/Odometry",
    "rviz_default_plugins/Path": "nav_msgs/msg/Path",
    "rviz_default_plugins/PointCloud2": "sensor_msgs/msg/PointCloud2",
    "rviz_default_plugins/RobotModel": "std_msgs/msg/String",
}
"""Message types of displays whose type the display alone decides."""
RELIABILITY = {"Reliable": "RELIABLE", "Best Effort": "BEST_EFFORT", "System Default": "SYSTEM_DEFAULT"}
DURABILITY = {"Volatile": "VOLATILE", "Transient Local": "TRANSIENT_LOCAL", "System Default": "SYSTEM_DEFAULT"}
DEEPEST = 20


class Display(NamedTuple):
    topic: Located
    type: str | None
    reliability: str | None
    durability: str | None
    depth: int | None
    policy: Located
    """The reliability, where it is written; the topic when it is not."""


def parse(source: Source) -> list[Display]:
    """The displays that are switched on, and have a topic."""
    root = parse_yaml(source).root
    manager = root.mapping("Visualization Manager") if isinstance(root, Mapping) else None
    return list(_displays(manager, 0)) if manager is not None else []


def _displays(group: Mapping, depth: int) -> Iterator[Display]:
    displays = group.sequence("Displays")
    if displays is None or depth >= DEEPEST:
        return
    for display in displays:
        if not isinstance(display, Mapping) or _off(display):
            continue
        yield from _displays(display, depth + 1)
        kind = display.scalar("Class")
        type_ = TYPES.get(str(kind.value)) if kind is not None else None
        for name in ("Topic", "Description Topic"):
            topic = display.mapping(name)
            if topic is None:
                continue
            value = topic.scalar("Value")
            if value is not None and value.value and not value.is_null:
                yield _display(topic, value, type_)


def _off(display: Mapping) -> bool:
    enabled = display.scalar("Enabled")
    return enabled is not None and enabled.boolean is False


def _display(topic: Mapping, value: Scalar, type_: str | None) -> Display:
    reliability, durability = topic.scalar("Reliability Policy"), topic.scalar("Durability Policy")
    depth = topic.scalar("Depth")
    return Display(
        value.value,
        type_,
        RELIABILITY.get(str(reliability.value)) if reliability is not None else None,
        DURABILITY.get(str(durability.value)) if durability is not None else None,
        depth.integer if depth is not None else None,
        reliability.value if reliability is not None else value.value,
    )
