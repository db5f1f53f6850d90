"""What RViz subscribes, by the configuration that a launch file gives it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import path_of

if TYPE_CHECKING:
    from bringup_lint.parsers.rviz import Display
    from bringup_lint.robot import Robot

OPTIONS = ("-d", "--display-config")


def displays(robot: Robot, started: Started) -> list[Display]:
    """The displays that are switched on; none when the configuration is not in the tree."""
    if literal_text(started.package) != "rviz2" or literal_text(started.executable) != "rviz2":
        return []
    values = list(started.arguments)
    for at, value in enumerate(values[:-1]):
        if text_of(value) in OPTIONS:
            path = path_of(robot.launch, values[at + 1])
            return _read(robot, path) if path is not None else []
    return []


def _read(robot: Robot, path: str) -> list[Display]:
    from bringup_lint.parsers.rviz import parse

    if path not in set(robot.tree.named(os.path.basename(path))):
        return []
    source = robot.tree.read(path)
    read = robot.parsed(parse, [source] if source is not None and not source.template else [])
    return read[0] if read else []
