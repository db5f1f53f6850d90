"""All runners of a robot, from every kind of file that starts processes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.files import Files
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.runners.launching import Launching
from bringup_lint.graph.runners.launching import expansion_of
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Start
from bringup_lint.model.launch import LaunchFile

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

MAKERS = {
    "units": ("systemd-unit", "systemd-dropin"),
    "services": ("compose",),
    "images": ("dockerfile",),
    "cron": ("cron",),
    "scripts": ("shell-script",),
}
"""Module of this package -> the kinds of file that it makes runners of. What others may start comes last."""


@dataclass(eq=False)
class Runners:
    files: Files
    layers: Layers
    launch: Callable[[], Launch]

    @cached_property
    def all(self) -> list[Runner]:
        """Every runner of the judged files; scripts only where no other runner starts them."""
        found: list[Runner] = []
        for module, kinds in MAKERS.items():
            if self.files.of_kind(*kinds):
                make = import_module(f"bringup_lint.graph.runners.{module}").runners
                found += [runner for runner in make(self.files, self.layers) if not _is_started(runner, found)]
        return found

    @cached_property
    def ros(self) -> list[Runner]:
        """Those that take part in the communication of ROS 2."""
        return [runner for runner in self.all if runner.runs_ros]

    @cached_property
    def launches(self) -> list[Launching]:
        """Every ``ros2 launch`` with a known launch file name, of every runner."""
        return [self._launching(runner, start) for runner in self.all for start in runner.launches]

    def _launching(self, runner: Runner, start: Start) -> Launching:
        return Launching(runner, start, self.launch().named(start.ros.package, start.ros.target))

    def launching(self, file: LaunchFile) -> list[Launching]:
        """Those that start a launch file."""
        return self._by_file.get(file, [])

    @cached_property
    def _by_file(self) -> dict[LaunchFile, list[Launching]]:
        found: dict[LaunchFile, list[Launching]] = {}
        for each in self.launches:
            if each.file is not None:
                found.setdefault(each.file, []).append(each)
        return found

    def expansion(self, start: Start) -> Expansion | None:
        """What a command leads to with its arguments, always the same object; None when its launch file is not in
        the tree."""
        if start.ros not in self._expansions:
            self._expansions[start.ros] = expansion_of(start.ros, self.launch())
        return self._expansions[start.ros]

    @cached_property
    def _expansions(self) -> dict[Ros, Expansion | None]:
        return {}


def _is_started(runner: Runner, others: list[Runner]) -> bool:
    """Whether a script is one that another runner starts."""
    if runner.kind is not RunnerKind.SCRIPT:
        return False
    return any(step.script is runner.source for other in others for line in other.lines for step in line.steps)
