"""All runners of a robot, from every kind of file that starts processes."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Set
from functools import cached_property
from importlib import import_module

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.starters import STARTERS
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.runners.described import Described
from bringup_lint.graph.runners.launching import Launching
from bringup_lint.graph.runners.launching import expansion_of
from bringup_lint.graph.runners.runner import SUPERVISING
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Start
from bringup_lint.graph.runners.runner import is_launch
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.layers import Layers
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.source import Source
    from bringup_lint.source import Span


@dataclass(eq=False)
class Runners:
    """Asked as ``robot.runners``: everything that starts processes, and what of ROS it starts."""

    files: Files
    layers: Layers
    launch: Callable[[], Launch]

    @cached_property
    def all(self) -> list[Runner]:
        """Every runner of the judged files; scripts only where no other runner starts them."""
        found: list[Runner] = []
        for module, starter in STARTERS.items():
            if self.files.of_kind(*starter.kinds):
                make = import_module(f"bringup_lint.graph.runners.{module}").runners
                started = {step.script for other in found for line in other.lines for step in line.steps}
                found += [runner for runner in make(self.files, self.layers) if not _is_started(runner, started)]
        return found

    @cached_property
    def in_containers(self) -> list[Runner]:
        """Compose services, and images that no service starts."""
        return [runner for runner in self.all if runner.in_container]

    @cached_property
    def ros(self) -> list[Runner]:
        """Those that take part in the communication of ROS 2."""
        return [runner for runner in self.all if runner.runs_ros]

    @cached_property
    def launches(self) -> list[Launching]:
        """Every ``ros2 launch`` with a known launch file name, of every runner."""
        return [self._launching(runner, start) for runner in self.all for start in runner.launches]

    @cached_property
    def typed_launches(self) -> list[Launching]:
        """Those that are started in terminals, or have a short name."""
        return [self._launching(runner, start) for runner in self.all for start in runner.typed if is_launch(start)]

    @cached_property
    def run(self) -> list[tuple[Runner, Ros]]:
        """Every ``ros2 run`` of every runner, those in terminals, too."""
        return [
            (runner, ros)
            for runner in self.all
            for ros in (*(ros for line in runner.lines for _, ros in line.ros), *(each.ros for each in runner.typed))
            if ros.kind == "run"
        ]

    def _launching(self, runner: Runner, start: Start) -> Launching:
        return Launching(runner, start, self.launch().named(start.ros.package, start.ros.target))

    def is_supervised(self, runner: Runner) -> bool:
        """Whether something other than a person starts it: a script counts where a unit, service or image names it."""
        if runner.kind is not RunnerKind.SCRIPT:
            return True
        return any(runner.source.basename in each.text for each in self.files.of_kind(*SUPERVISING))

    def of_service(self, service: Service) -> Runner | None:
        """The runner of a compose service; None when its file is not judged."""
        return self._by_service.get(service)

    def runs_ros2(self, service: Service) -> bool:
        """Whether a service certainly runs something of ROS 2: as its own keys say, or the image that it builds."""
        runner = self.of_service(service)
        return service.is_ros or (runner is not None and any(each.name == "ros2" for each in runner.commands))

    @cached_property
    def _by_service(self) -> dict[Service, Runner]:
        return {runner.service: runner for runner in self.all if runner.service is not None}

    def of_stage(self, stage: Stage) -> list[Runner]:
        """The runners of the containers that a stage of a Dockerfile makes."""
        return self._by_stage.get(id(stage), [])

    @cached_property
    def _by_stage(self) -> dict[int, list[Runner]]:
        found: dict[int, list[Runner]] = {}
        for runner in self.all:
            if runner.stage is not None:
                found.setdefault(id(runner.stage), []).append(runner)
        return found

    def packages_of(self, unit: Unit) -> set[str | None]:
        """The packages of which a unit starts programs; None among them when there may be others."""
        from bringup_lint.graph.launch.started import literal_text

        found = {str(ros.package) if ros.package else None for runner, ros in self.run if runner.unit is unit}
        for each in self.launches:
            if each.runner.unit is unit:
                expansion = self.expansion(each.start)
                found |= {None} if expansion is None else {literal_text(node.package) for node in expansion.nodes}
        return found or {None}

    def launching(self, file: LaunchFile) -> list[Launching]:
        """Those that start a launch file."""
        return self._by_file.get(file, [])

    def launched_by(self, source: Source) -> list[Launching]:
        """Those in a file."""
        return self._by_source.get(source, [])

    @cached_property
    def _by_source(self) -> dict[Source, list[Launching]]:
        found: dict[Source, list[Launching]] = {}
        for each in self.launches:
            found.setdefault(each.runner.source, []).append(each)
        return found

    def always_passed(self, file: LaunchFile) -> set[str]:
        """The arguments that every command of the tree that launches a file passes: they exist before it is read."""
        names = [{str(name) for name, _ in command.arguments} for command in self.launching(file)]
        return set.intersection(*names) if names else set()

    @cached_property
    def _by_file(self) -> dict[LaunchFile, list[Launching]]:
        found: dict[LaunchFile, list[Launching]] = {}
        for each in self.launches:
            if each.file is not None:
                found.setdefault(each.file, []).append(each)
        return found

    def purpose(self, place: Span) -> Purpose:
        """What the runner at a place is for; for a Dockerfile, all those that build it."""
        described = self._described.get(place.source)
        if described is None:
            return Purpose.ROBOT
        around = described.around(place)
        purposes = {runner.purpose for runner in around}
        return Purpose.ROBOT if Purpose.ROBOT in purposes or not around else around[0].purpose

    @cached_property
    def _described(self) -> dict[Source, Described]:
        """The runners that a file describes, whole or in a part of it."""
        found: dict[Source, list[Runner]] = {}
        for runner in self.all:
            image = [] if runner.stage is None else [runner.stage.start.keyword.span.source]
            own = [] if runner.extent is None else [runner.extent.source]
            for source in dict.fromkeys((*image, *own)):
                found.setdefault(source, []).append(runner)
        return {source: Described(source, runners) for source, runners in found.items()}

    def expansion(self, start: Start) -> Expansion | None:
        """What a command leads to with its arguments, always the same object; None when its launch file is not in
        the tree."""
        if start.ros not in self._expansions:
            self._expansions[start.ros] = expansion_of(start.ros, self.launch())
        return self._expansions[start.ros]

    @cached_property
    def _expansions(self) -> dict[Ros, Expansion | None]:
        return {}


def _is_started(runner: Runner, scripts: Set[Source | None]) -> bool:
    """Whether a script is one that another runner starts."""
    return runner.kind is RunnerKind.SCRIPT and runner.source in scripts
