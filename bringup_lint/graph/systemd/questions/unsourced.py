"""Services that start programs of ROS 2 without the environment that a setup file gives them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_ENOUGH = ("AMENT_PREFIX_PATH", "PYTHONPATH", "LD_LIBRARY_PATH", "BASH_ENV")
"""Variables that may replace a setup file."""
_INTERPRETER = regex(r"python[0-9.]*$")


class SourcedBefore(NamedTuple):
    """Setup files are sourced in ExecStartPre= only, for processes that exit before the service starts."""

    unit: Unit
    sourcing: list[Process]
    start: Process
    """The first process that starts without them."""
    every: bool
    """No process of the service sources any; else this one is a Python program beside processes that do."""


class NotSourced(NamedTuple):
    """Nothing sources a setup file before a program of ROS 2."""

    unit: Unit
    process: Process
    step: Step
    ros: Ros
    certain: bool
    """Whether all of its environment is known."""


def unsourced(units: Units) -> Iterator[SourcedBefore | NotSourced]:
    """The processes of services that surely start without a setup file."""
    for unit in units.services:
        lost = [
            process for process in units.processes(unit) if process.key == "ExecStartPre" and _only_sources(process)
        ]
        started = units.started(unit)
        if lost and started and not any(process.setup_files for process in started):
            yield SourcedBefore(unit, lost, started[0], True)
            continue
        environment = units.environment(unit)
        if unit.unsure_of() or any(environment.get(name) for name in _ENOUGH):
            continue
        for process in started:
            if not process.profiles:
                yield from _of(unit, process, lost, environment.complete)


def _of(unit: Unit, process: Process, lost: list[Process], certain: bool) -> Iterator[SourcedBefore | NotSourced]:
    found = next(((step, ros) for step, ros in process.ros if not process.sourced_before(step)), None)
    if found is not None:
        if not _is_bare(process, found[1]) and not _is_hidden(process, *found):
            yield NotSourced(unit, process, *found, certain)
    elif lost and _INTERPRETER.match(process.name) and not process.setup_files:
        yield SourcedBefore(unit, lost, process, False)


def _only_sources(process: Process) -> bool:
    """Whether the line sources setup files and does nothing with them."""
    return bool(process.setup_files) and process.steps[-1].command.name in ("source", ".")


def _is_bare(process: Process, ros: Ros) -> bool:
    """Whether systemd itself looks for ``ros2``, which systemd/exec-bare-ros2 reports."""
    return ros.program == "ros2" and ros.program.span == process.program.span


def _is_hidden(process: Process, step: Step, ros: Ros) -> bool:
    """Whether something that runs before the program and is not in the tree may source a setup file."""
    return process.opaque and (process.steps.index(step) > 0 or ros.command is not step.command)
