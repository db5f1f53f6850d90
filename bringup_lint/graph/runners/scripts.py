"""Shell scripts that people run: those that no other runner starts."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.environment import UNKNOWN
from bringup_lint.graph.commands.following import follow_text
from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_ROS2 = regex(r"\bros2[ \t]+(?:launch|run)\b", hints="ros2")


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    for source in files.of_kind("shell-script"):
        if source.judged and not source.template and source.matches(_ROS2):
            yield _of(files, source)


def _of(files: Files, source: Source) -> Runner:
    text = source.located(0, len(source.text))
    line = CommandLine(text, ())
    follow_text(line, text, lambda path: None)
    starts_ros = bool(line.ros)
    where = line.ros[0][1].program.span if starts_ros else source.whole
    lines = [line]
    return Runner(
        RunnerKind.SCRIPT,
        source.basename,
        where,
        UNKNOWN,
        lines,
        lines,
        runs_ros=starts_ros,
        system=source.name,
        purpose=files.purpose(source),
    )
