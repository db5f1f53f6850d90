"""Frames that a robot is told to use, and that nothing of the tree makes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import chain
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.endings import CPP
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.described import described
from bringup_lint.graph.topics.resolved.node_names import PUBLIC
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.plugins.described import Described
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.params import Parameter

_SENSOR = frozenset(("frame_id", "laser_frame", "laser_frame_id"))
_LIDARS = regex(
    r"rplidar_ros|sllidar_ros2|ydlidar_ros2_driver|ldlidar\w*|urg_node2?|sick_scan\w*|hls_lfcd_lds_driver|lslidar\w*"
)
_LIDAR_NODES = regex(r"(?:rp|sl|yd|ld)_?lidar\w*|urg_node2?\w*|hlds_laser_publisher|sick_\w+")
_BASE = frozenset(("base_frame", "base_frame_id", "robot_base_frame"))
_READERS = frozenset(
    (
        *("amcl", "slam_toolbox", "bt_navigator", "behavior_server", "local_costmap", "global_costmap"),
        *("collision_monitor", "velocity_smoother", "docking_server", "map_saver"),
    )
)
"""Nodes that look a base frame up, and do not publish it."""
_PREFIX = regex(r"frame_prefix|tf_prefix")
_NAMING = (
    *(".py", *CPP, ".c", ".ino", ".rs", ".sh", ".lua"),
    *(".xml", ".yaml", ".yml", ".launch", ".xacro", ".urdf", ".sdf", ".json", ".toml"),
)
"""Files that may make a frame, or give its name to what makes it."""
_MOST = 4000
"""Files that are looked through."""
_COMPARED = 20
"""Frames for which a link is sought that may be meant."""
_WORD = regex(r"(?<![\w/])[A-Za-z]\w*")
_NAME = regex(r"/?[A-Za-z]\w*\Z")
_COMMON = frozenset(("map", "odom", "world", "earth"))
_FIRMWARE = "micro_ros_agent"
"""What brings the nodes of a microcontroller into the graph, transforms of the odometry among them."""
_BESIDE = regex(r"controller_manager|ros_gz\w*|gazebo_ros|rviz2?|xacro|moveit_\w+|joint_state_publisher\w*|rqt\w*")
"""Further packages that publish no transform of the base."""


class UnknownFrame(NamedTuple):
    name: Located
    near: str | None
    is_base: bool
    others: tuple[Span, ...] = ()


def unknown_frames(topics: Topics) -> Iterator[UnknownFrame]:
    """Each frame once; only where all descriptions are in the tree, one is published, and no other file names it."""
    files, launch = topics.files, topics.launch
    if not files.of_kind("urdf") or not any(map(_is_publisher, launch.nodes)) or _is_prefixed(topics):
        return
    known = described(files.tree, launch.workspace.packages)
    if known.is_open or not known.links or not _is_closed(topics):
        return
    found: dict[str, list[tuple[Located, bool]]] = {}
    for name, is_base in chain(_of_files(topics), _of_launch(topics)):
        found.setdefault(str(name).lstrip("/"), []).append((name, is_base))
    for frame in (_COMMON & found.keys()) | {each for each in found if known.has_link(each) or each in known.joints}:
        del found[frame]
    named = _named(topics, found) if found else set()
    unknown = ((frame, uses) for frame, uses in found.items() if frame not in named)
    for at, (frame, uses) in enumerate(unknown):
        near = (nearest(frame, known.links, 4) or _same_words(frame, known)) if at < _COMPARED else []
        (first, is_base), *others = uses
        yield UnknownFrame(first, near[0] if len(near) == 1 else None, is_base, tuple(one.span for one, _ in others))


def _is_publisher(node: Started) -> bool:
    return str(literal_text(node.package)) == "robot_state_publisher"


def _is_prefixed(topics: Topics) -> bool:
    return any(source.matches(_PREFIX) for source in topics.files.of_kind(*LAUNCH))


def _is_closed(topics: Topics) -> bool:
    """Whether nothing of another origin may publish transforms of the robot."""
    packages = {str(literal_text(node.package)) for node in topics.launch.nodes if node.is_node}
    for expansion in topics.launch.expansions:
        for include in expansion.includes:
            if include.target is None:
                target = place(include.file)
                packages.add(str(target.package) if target is not None else "")
    own = topics.launch.workspace.packages
    if _FIRMWARE in packages:
        return False
    return all(
        each in own or PUBLIC.fullmatch(each) or _LIDARS.fullmatch(each) or _BESIDE.fullmatch(each) for each in packages
    )


def _of_files(topics: Topics) -> Iterator[tuple[Located, bool]]:
    params = topics.params()
    for file, each in params.parameters:
        text = each.value.data
        if each.name not in _BASE | _SENSOR or not isinstance(text, str) or not _NAME.match(text):
            continue
        if not params.is_used(file):
            continue
        node = str(each.block.key).rpartition("/")[2]
        if each.name == "robot_base_frame" or (each.name in _BASE and node in _READERS):
            yield Located(text, each.span), True
        elif each.name in _SENSOR and (_LIDAR_NODES.fullmatch(node) or _is_of_lidar(topics, each)):
            yield Located(text, each.span), False


def _is_of_lidar(topics: Topics, parameter: Parameter) -> bool:
    params = topics.params()
    file = params.at_path(parameter.span.source.absolute)
    loads = params.effective(file, parameter) if file is not None else []
    return bool(loads) and all(_LIDARS.fullmatch(str(literal_text(load.node.package))) for load in loads)


def _of_launch(topics: Topics) -> Iterator[tuple[Located, bool]]:
    for node in topics.launch.nodes:
        package = str(literal_text(node.package))
        if not node.file.source.judged or not _LIDARS.fullmatch(package):
            continue
        for key, value in node.given:
            text = _text(value)
            if text_of(key) in _SENSOR and text is not None and _NAME.match(text):
                yield text, False


def _text(value: Value) -> Located | None:
    inner = value.value if isinstance(value, TypedValue) else value
    text = literal_text(inner)
    return text if isinstance(text, Located) else None


def _named(topics: Topics, found: dict[str, list[tuple[Located, bool]]]) -> set[str]:
    """The frames that anything else names, so that it may make them: another file, or the same one in another place."""
    own = {frame: Counter(use.span.source.absolute for use, _ in uses) for frame, uses in found.items()}
    named: set[str] = set()
    tree = topics.files.tree
    for path in [path for path in tree.paths if path.endswith(_NAMING)][:_MOST]:
        source = tree.read(path, judged=False)
        words = Counter(word for word in _WORD.findall(source.text) if word in own) if source is not None else Counter()
        for frame, count in words.items():
            if source is not None and count > own[frame][source.absolute]:
                named.add(frame)
    return named


def _same_words(frame: str, known: Described) -> list[str]:
    """The links whose names have a word of a frame that is not about frames as such."""
    words = set(frame.split("_")) - {"link", "frame", "base", "sensor"}
    return [link for link in sorted(known.links) if words & set(link.split("_"))]
