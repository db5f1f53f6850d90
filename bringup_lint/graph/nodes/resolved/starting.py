"""Who starts a node as a program, and how it is stopped."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.memo import kept
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.started_programs import program_path
from bringup_lint.graph.runners.launching import expansion_of
from bringup_lint.graph.runners.runner import SUPERVISING
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.finding import Related
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.launch import Action
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.source import Source

_TOOL = regex(
    r"(?:^|_)(?:calibrat\w*?|capture|gathering|gui|dummy|evaluat(?:e|or|ion)|visuali[sz](?:e|er|ation)|plot(?:ter)?"
    r"|debug(?:ger)?|bt_(?:monitor|viewer))(?=[_.]|$)|^check_",
    re.I,
)
"""Names of programs for people: they look at the robot, set it up or stand in for a part of it."""


def runners_of(nodes: Nodes, file: NodeSource) -> list[Runner]:
    """Those whose launch files run a file as a program; people, who run scripts, are left out."""
    actions = {started.action for started in nodes.launched(file)}
    if not actions:
        return []
    launches = (each for each in nodes.runners().launches if each.runner.kind is not RunnerKind.SCRIPT)
    return list(dict.fromkeys(each.runner for each in launches if actions & _actions(nodes, each.start.ros)))


@memo
def _actions(nodes: Nodes, ros: Ros) -> set[Action]:
    """The actions of all nodes that ``ros2 launch`` starts, but those whose conditions its arguments leave off."""
    expansion = expansion_of(ros, nodes.launch)
    return {node.action for node in expansion.nodes if node.by_default is not False} if expansion is not None else set()


def is_supervised(nodes: Nodes, file: NodeSource) -> bool:
    """Whether a runner that is not a person runs a file as a program, by itself or through a launch file."""
    if file.source in _run_directly(nodes) or runners_of(nodes, file):
        return True
    return file.source.basename in _runner_texts(nodes)


@kept
def _runner_texts(nodes: Nodes) -> str:
    """What starts processes, in one text, which is searched sooner than many."""
    return "\0".join(each.text for each in nodes.files.of_kind(*SUPERVISING))


def watcher(nodes: Nodes, source: Source) -> Runner | None:
    """The unit, container or supervised program that runs a source and no other, and looks at the status with which
    that ends: ``ros2 launch`` tells nobody of it."""
    return _watched(nodes).get(source.absolute)


@kept
def _watched(nodes: Nodes) -> dict[str, Runner]:
    """Path of a source -> the runner that looks at its status."""
    found: dict[str, Runner] = {}
    for runner in nodes.runners().all:
        steps = list(_lasting(runner)) if runner.asks_status else []
        ahead = [each for each in steps if not each.command.background] or steps
        if len(ahead) == 1:
            found.update((path, runner) for path in _sources(nodes, runner, ahead[0]))
    return found


def _lasting(runner: Runner) -> Iterator[Step]:
    """The steps of a runner that start a program of ROS, or one of the tree in Python."""
    for line in runner.main:
        started = {id(step) for step, _ in line.ros}
        yield from (each for each in line.steps if id(each) in started or _script(runner, each) is not None)


def _script(runner: Runner, step: Step) -> Source | None:
    """What a step starts of the tree by its path."""
    path = program_path(step.command)
    if path is None or not path.endswith(".py") or "$" in path:
        return None
    return runner.reads(path)


def _sources(nodes: Nodes, runner: Runner, step: Step) -> list[str]:
    """The paths of the sources of the program that a step starts; none for a launch file."""
    ros = ros_command(step.command)
    if ros is not None and ros.kind == "run":
        return _sources_of(nodes, str(ros.package), str(ros.target))
    if ros is not None:
        return _sources_of(nodes, *str(ros.target).split("/")[-2:]) if ros.kind == "node" else []
    script = _script(runner, step)
    return [script.absolute] if script is not None else []


def _sources_of(nodes: Nodes, package: str, name: str) -> list[str]:
    """The paths of the sources of a program, in Python or in C++."""
    program = nodes.program(package, name)
    if program is not None:
        return [program.file.source.absolute]
    owner = nodes.launch.workspace.packages.get(package)
    if owner is None:
        return []
    return [
        os.path.normpath(os.path.join(os.path.dirname(build.source.absolute), path))
        for build in owner.builds
        for path in build.targets.get(name, ())
    ]


@kept
def _run_directly(nodes: Nodes) -> frozenset[Source]:
    """The files that ``ros2 run`` starts for a unit, a container or the like."""
    found: set[Source] = set()
    for runner in nodes.runners().all:
        if runner.kind is RunnerKind.SCRIPT:
            continue
        named = (each.ros for each in runner.starts if each.ros.package and each.ros.target)
        programs = (nodes.program(str(ros.package), str(ros.target)) for ros in named)
        found |= {program.file.source for program in programs if program is not None}
    return frozenset(found)


def is_stopped(nodes: Nodes, file: NodeSource) -> bool:
    """Whether a unit, a container or the like starts a program that is not for tests, examples or a person, and so
    stops it with a signal; a launch file alone is stopped by a person at the keyboard."""
    if not is_supervised(nodes, file) or not nodes.is_for_robot(file.source):
        return False
    return not is_tool(nodes, file) and not nodes.launch.workspace.is_vendored(file.source)


def is_tool(nodes: Nodes, file: NodeSource) -> bool:
    """Whether a person runs a program to look at the robot or to set it up, or one for a simulator."""
    ending = nodes.ending(file)
    return ending.reads_keys or ending.drives_simulator or bool(_TOOL.search(file.source.basename))


def stopped_by(nodes: Nodes, file: NodeSource) -> set[str]:
    """The signals with which runners stop a file that they start; empty when none does, or that is not known."""
    signals = {runner.stop.signal for runner in runners_of(nodes, file)}
    return {signal for signal in signals if signal is not None} if None not in signals else set()


def chain_to(nodes: Nodes, file: NodeSource, *more: Related) -> tuple[Related, ...]:
    """How a runner and launch files lead to a file; empty when none does."""
    chains = (nodes.provenance().chain_to_node(each, *more) for each in nodes.launched(file))
    return next(filter(None, chains), ())
