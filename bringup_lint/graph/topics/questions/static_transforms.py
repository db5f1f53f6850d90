"""Frames that static_transform_publisher and robot_state_publisher put in different places."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.fixed_joints import published_joints
from bringup_lint.graph.plugins.xacro_joints import FixedJoint
from bringup_lint.graph.plugins.xacro_joints import Numbers
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.model.launch_values import DictValue
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Running

_STATIC = ("tf2_ros", "static_transform_publisher")
_DESCRIBED = "robot_state_publisher"
_OF_DESCRIPTION = ("robot_description", "use_sim_time", "publish_frequency", "ignore_timestamp")
"""Parameters of robot_state_publisher that change no frame."""
_AXES = ("x", "y", "z", "roll", "pitch", "yaw")
_QUATERNION = ("qx", "qy", "qz", "qw")
_EULER = 8
"""Words with yaw, pitch and roll, in that order (geometry2, static_transform_broadcaster_program.cpp)."""
_ONE_MORE = 9
_NEAR = 0.005
"""Metres, and half-angles in radians, by which nobody cares."""


class Place(NamedTuple):
    xyz: Numbers
    quaternion: tuple[float, float, float, float]


class StaticTransform(NamedTuple):
    parent: str
    child: str
    place: Place
    where: Span


class Conflict(NamedTuple):
    """A frame that is published twice."""

    static: StaticTransform
    joint: FixedJoint
    what: str
    """``parent``, ``place`` or ``turn``: in what the two differ."""


def conflicting_transforms(launch: Launch, tree: Tree, running: Running) -> Iterator[Conflict]:
    """Each pair that surely starts together; of one parent and one place nothing goes wrong."""
    publishers = [each for each in running.nodes if _program(each)[1] == _DESCRIBED and _keeps_frames(each)]
    statics = [(each, _static(each)) for each in running.nodes if _program(each) == _STATIC] if publishers else []
    for publisher in publishers:
        joints: dict[str, FixedJoint] | None = None
        for node, static in statics:
            if static is None or not coexist(node, publisher):
                continue
            if joints is None:
                joints = published_joints(launch, tree, publisher.started)
            joint = joints.get(static.child)
            what = _difference(static, joint) if joint is not None else None
            if joint is not None and what is not None:
                yield Conflict(static, joint, what)


def _program(node: LaunchedNode) -> tuple[str, str]:
    return str(literal_text(node.started.package)), str(literal_text(node.started.executable))


def _keeps_frames(node: LaunchedNode) -> bool:
    """Whether a robot_state_publisher surely publishes the frames of its description, to everybody."""
    given = {text_of(key) for key, _ in node.started.given}
    is_known = all(isinstance(each, DictValue) for each in node.started.parameters)
    return is_known and given <= {*_OF_DESCRIPTION} and not _renames(node)


def _renames(node: LaunchedNode) -> bool:
    names = [text_of(old) for old, _ in node.started.remappings]
    return any(name is None or name.rpartition("/")[2] in ("tf", "tf_static") for name in names)


def _static(node: LaunchedNode) -> StaticTransform | None:
    words = [literal_text(value) for value in node.started.arguments]
    known = [word for word in words if word is not None]
    if len(known) < len(words) or _renames(node) or "--ros-args" in known:
        return None
    given = _by_flags(known) if any(word.startswith("--") for word in known) else _by_order(known)
    numbers = _numbers(given)
    parent, child = given.get("frame-id", "").lstrip("/"), given.get("child-frame-id", "").lstrip("/")
    if numbers is None or not parent or not child:
        return None
    whole = node.started.span
    places = [word.span for word in known if word.lstrip("/") == child]
    inside = [each for each in places if each.source is whole.source and whole.start <= each.start < whole.end]
    return StaticTransform(parent, child, _place(numbers), inside[-1] if inside else whole)


def _by_flags(words: list[Located]) -> dict[str, str]:
    return {flag[2:]: str(value) for flag, value in zip(words[::2], words[1::2]) if flag.startswith("--")}


def _by_order(words: list[Located]) -> dict[str, str]:
    names: tuple[str, ...] = ()
    if len(words) == _EULER:
        names = (*_AXES[:3], "yaw", "pitch", "roll", "frame-id", "child-frame-id")
    elif len(words) == _ONE_MORE:
        names = (*_AXES[:3], *_QUATERNION, "frame-id", "child-frame-id")
    return dict(zip(names, map(str, words)))


def _numbers(given: dict[str, str]) -> dict[str, float] | None:
    try:
        return {name: float(given[name]) for name in (*_AXES, *_QUATERNION) if name in given}
    except ValueError:
        return None


def _place(numbers: dict[str, float]) -> Place:
    x, y, z, roll, pitch, yaw = (numbers.get(name, 0.0) for name in _AXES)
    turn = _turned(roll, pitch, yaw)
    if numbers.keys() & {*_QUATERNION}:
        qx, qy, qz = (numbers.get(name, 0.0) for name in _QUATERNION[:3])
        turn = qx, qy, qz, numbers.get("qw", 1.0)
    return Place((x, y, z), turn)


def _turned(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    (sr, cr), (sp, cp), (sy, cy) = ((math.sin(each / 2), math.cos(each / 2)) for each in (roll, pitch, yaw))
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def _difference(static: StaticTransform, joint: FixedJoint) -> str | None:
    """In what the two certainly differ."""
    if static.parent != joint.parent:
        return "parent"
    if joint.xyz is not None and math.dist(static.place.xyz, joint.xyz) > _NEAR:
        return "place"
    if joint.rpy is None:
        return None
    ours, theirs = static.place.quaternion, _turned(*joint.rpy)
    size = math.hypot(*ours) or 1.0
    alike = abs(sum(one * other for one, other in zip(ours, theirs))) / size
    return "turn" if 1 - alike > _NEAR**2 else None
