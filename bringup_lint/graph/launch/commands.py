"""The commands that start launch files: ``ros2 launch`` in units, in the scripts they run, and in compose services."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.systemd.process import Ros
from bringup_lint.graph.systemd.process import ros_command
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands as shell_commands
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.graph.systemd.process import Step
    from bringup_lint.model.compose import Service
    from bringup_lint.robot import Robot


class LaunchCommand(NamedTuple):
    """``ros2 launch package target name:=value ...``, and what runs it: a process of a unit, or a compose service."""

    package: Located | None
    target: Located
    arguments: list[tuple[Located, Located]]
    file: LaunchFile | None
    """The launch file, when it is in the tree."""
    process: Process | None = None
    step: Step | None = None
    service: Service | None = None

    @property
    def is_of_tree(self) -> bool:
        """Whether it surely starts what the tree holds: an image from elsewhere may hold another version."""
        return self.process is not None or (self.service is not None and self.service.build is not None)

    @property
    def runner(self) -> str:
        """``robot.service``, or ``service 'driver'`` of a compose file."""
        if self.process is not None:
            return self.process.unit.name
        return f"service '{self.service.name}'" if self.service is not None else ""


def launch_commands(robot: Robot, launch: Launch) -> Iterator[LaunchCommand]:
    if robot.of_kind("systemd-unit", "systemd-dropin"):
        yield from _of_units(robot, launch)
    if robot.of_kind("compose"):
        yield from _of_services(robot, launch)


def _of_units(robot: Robot, launch: Launch) -> Iterator[LaunchCommand]:
    for unit in robot.units.judged:
        for process in robot.units.processes(unit):
            for step, ros in process.launches:
                if ros.target is not None:
                    yield _command(launch, ros)._replace(process=process, step=step)


def _of_services(robot: Robot, launch: Launch) -> Iterator[LaunchCommand]:
    for service in robot.compose.services:
        if service.source.judged and service.launches is not None and service.launches.span.source is service.source:
            for ros in _started(service):
                if ros.kind == "launch" and ros.target is not None:
                    yield _command(launch, ros)._replace(service=service)


def _started(service: Service) -> Iterator[Ros]:
    words = (*service.entrypoint, *service.command)
    at = next((at for at, word in enumerate(words) if word.rpartition("/")[2] == "ros2"), None)
    if at is not None:
        found = [ros_command(Command(words[at:]))]
    else:
        texts = [word for word in words if "ros2 launch" in word]
        found = [ros_command(command) for text in texts for command in shell_commands(text)]
    yield from (ros for ros in found if ros is not None)


def _command(launch: Launch, ros: Ros) -> LaunchCommand:
    passed = [(word, word.find(":=")) for word in ros.arguments]
    arguments = [(word.part(0, at), word.part(at + 2, len(word))) for word, at in passed if at > 0]
    return LaunchCommand(ros.package, ros.target, arguments, launch.named(ros.package, ros.target))
