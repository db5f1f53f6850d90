"""Runners without a layer of their own as nodes: what images, cron lines and programs of supervisord run."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.runs import started_node
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runners import Runners

DRAWN = (RunnerKind.IMAGE, RunnerKind.CRON, RunnerKind.PROGRAM)
"""Units and services have edges of their own; scripts that people run are no part of the robot's start."""


def runner_node(runner: Runner) -> Node:
    return Node("program", runner.name, runner.source.name)


def runner_edges(runners: Runners, launch: Callable[[], Launch]) -> Iterator[Edge]:
    for runner in _drawn(runners):
        for start in runner.starts:
            target = started_node(start.ros, launch)
            if target is not None:
                yield Edge("runs", runner_node(runner), target, start.ros.where.span, runner.kind.value)


def runner_places(runners: Runners) -> Iterator[tuple[Node, Span]]:
    for runner in _drawn(runners):
        yield runner_node(runner), runner.where


def _drawn(runners: Runners) -> Iterator[Runner]:
    return (runner for runner in runners.ros if runner.kind in DRAWN)
