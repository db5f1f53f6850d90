"""Recordings that start by themselves: ``ros2 bag record`` in what the robot starts, without a person."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

_BY_HAND = (RunnerKind.SCRIPT, RunnerKind.IMAGE)


class Recording(NamedTuple):
    runner: Runner
    words: tuple[Located, ...]
    """From ``ros2`` on."""


def recordings(runners: Iterable[Runner]) -> Iterator[Recording]:
    """One for each runner, also where several run the same script."""
    for runner in runners:
        if runner.kind in _BY_HAND or (runner.unit is None and runner.purpose is not Purpose.ROBOT):
            continue
        for command in runner.commands:
            words = unwrapped(command.words)
            if words[1:3] == ("bag", "record") and program_name(words[0]) == "ros2":
                yield Recording(runner, words)
