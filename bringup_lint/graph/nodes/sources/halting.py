"""What stops a robot by itself when no command comes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source

FIRMWARE = 100
"""Files of firmware that are looked at."""
_FIRMWARE = (".ino", "/src/main.cpp", "/main.c")
_GATES = regex(
    r"\b(?:cmd_vel_timeout|reference_timeout|diff_drive_controller|mecanum_drive_controller|ackermann_steering_controller"
    r"|tricycle_controller|twist_mux|velocity_smoother|collision_monitor|create3)\b",
    hints="cmd_vel_timeout reference_timeout _controller twist_mux velocity_smoother collision_monitor create3",
)
"""Parameters, controllers and filters that end a motion when no command comes."""
_MILLIS = regex(r"\bmillis\s{0,2}\(\)\s{0,4}-|\btime_?out|\bwatch_?dog|HAL_GetTick\s{0,2}\(\)\s{0,4}-", re.I)
_SERVO = regex(r"(?m)^[ \t]*incoming_command_timeout[ \t]*:[ \t]*(?!0+(?:\.0*)?[ \t]*(?:#|$))[\d.]")
_SERVO_TOPIC = regex(
    r"(?m)^[ \t]*(?:cartesian|joint)_command_in_topic[ \t]*:[ \t]*[\"']?(?:[^\s\"'#]*/)?(?P<name>[^\s\"'#/]+)"
)
"""MoveIt Servo halts when the newest command on these topics is older than the time-out."""


@kept
def gate(nodes: Nodes) -> str | None:
    """Something of the tree that stops the robot by itself when commands fail to come, in a word."""
    roles = (nodes.launch.role(started).role for started in nodes.launch.nodes)
    if any(role in ("velocity filter", "safety") for role in roles):
        return "a velocity filter"
    found = (_GATES.search(source.text) for source in nodes.files.of_kind("params", *LAUNCH))
    return next((match[0] for match in found if match is not None), None)


@kept
def timed_topics(nodes: Nodes) -> set[str]:
    """The last parts of the topics whose receiver MoveIt Servo halts when no command comes."""
    texts = [source.text for source in (*nodes.files.of_kind("params"), *_servo_settings(nodes))]
    timed = (text for text in texts if _SERVO.search(text))
    return {match["name"] for text in timed for match in _SERVO_TOPIC.finditer(text)}


def _servo_settings(nodes: Nodes) -> Iterator[Source]:
    """MoveIt's own setting files hold no ``ros__parameters``: its launch files hand them over as dictionaries."""
    for path in nodes.files.tree.paths:
        if "servo" in path.rpartition("/")[2] and path.endswith((".yaml", ".yml")):
            source = nodes.files.tree.read(path, "params", judged=False)
            if source is not None:
                yield source


@kept
def firmware_looks_at_time(nodes: Nodes) -> bool:
    """Whether firmware of the tree compares times, and so may stop motors for which no command comes."""
    paths = islice(_firmware(nodes), FIRMWARE)
    sources = (nodes.files.tree.read(path, "cpp-node", judged=False) for path in paths)
    return any(source is not None and source.matches(_MILLIS) for source in sources)


def has_firmware(nodes: Nodes) -> bool:
    """Whether the tree holds firmware, so that what is not in it is known."""
    return next(_firmware(nodes), None) is not None


def _firmware(nodes: Nodes) -> Iterator[str]:
    return (path for path in nodes.files.tree.paths if path.endswith(_FIRMWARE))
