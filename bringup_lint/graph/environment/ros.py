"""The variables of ROS 2: every place that sets one, and what each process of the robot ends up with."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.environment.effective import Environment
from bringup_lint.graph.environment.effective import Variable
from bringup_lint.graph.environment.effective import process_environment
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.env_file import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder

if TYPE_CHECKING:
    from bringup_lint.model.compose import Service
    from bringup_lint.robot import Robot

OF_ROS = re.compile(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|RCUTILS|ZENOH)_\w+")
"""Names of variables that ROS 2 or its middleware reads."""

_SIMULATION = re.compile(
    r"(?:^|[/_.-])(?:sim|simulation|gazebo|gz|test|tests|ci|dev|devel|develop|development|example|examples)(?:[/_.-]|$)",
    re.I,
)


class Setting(NamedTuple):
    """One place that gives a variable a value."""

    name: str
    value: Located
    """As written, quotes removed."""
    text: str | None
    """What processes see; None when that depends on something unknown."""
    origin: str
    """``Environment=``, ``EnvironmentFile=``, ``environment:``, ``env file``, ``ENV``, ``export``, ``launch``."""
    expands: bool
    """Whether whoever reads it puts in ``$NAME`` and ``~``, as a shell does."""

    @property
    def development(self) -> bool:
        """Whether the path of the file says that it is for tests, simulation or development."""
        return bool(_SIMULATION.search(self.value.span.path))


@dataclass(frozen=True, eq=False)
class RosProcess:
    """A process, or a group of them, that runs ROS 2, and its environment."""

    name: str
    """How a message calls it: ``robot.service``, ``service 'driver'``."""
    where: Span
    environment: Environment
    unit: Unit | None = None
    service: Service | None = None

    @property
    def source(self) -> Source:
        return self.where.source


@dataclass(eq=False)
class RosEnvironment:
    """All of it, read once."""

    robot: Robot

    @staticmethod
    def is_development(value: Located) -> bool:
        """Whether the path of the file says that it is for tests, simulation or development."""
        return bool(_SIMULATION.search(value.span.path))

    @cached_property
    def settings(self) -> list[Setting]:
        """Every place of the tree that sets a variable of ROS, each once."""
        found: dict[tuple[int, int], Setting] = {}
        for setting in self._all_settings():
            span = setting.value.span
            if OF_ROS.fullmatch(setting.name) and span.source.judged and not has_placeholder(setting.value):
                found.setdefault((id(span.source), span.start), setting)
        return list(found.values())

    def of(self, *names: str) -> list[Setting]:
        """The settings of some variables whose value is known."""
        return [setting for setting in self.settings if setting.name in names and setting.text is not None]

    def _all_settings(self) -> Iterator[Setting]:
        for process in self.processes:
            for chain in process.environment.chains.values():
                yield from (_setting(variable) for variable in chain)
        if self.robot.of_kind("systemd-unit", "systemd-dropin"):
            for unit in self.robot.units.judged:
                for chain in self.robot.units.environment(unit).chains.values():
                    yield from (_setting(variable) for variable in chain)
        for source in self.robot.of_kind("env-file"):
            yield from _of_file(source)
        for source in self.robot.of_kind("shell-script"):
            yield from _of_script(source)
        if self.robot.of_kind("dockerfile"):
            for dockerfile in self.robot.dockerfiles:
                for stage in dockerfile.stages:
                    yield from map(_setting, image_variables(stage))

    @cached_property
    def processes(self) -> list[RosProcess]:
        """The units and compose services that run ROS 2."""
        found = []
        if self.robot.of_kind("systemd-unit", "systemd-dropin"):
            found += list(self._units())
        if self.robot.of_kind("compose"):
            found += list(self._services())
        return found

    def _units(self) -> Iterator[RosProcess]:
        for unit in self.robot.units.dds:
            started = [process for process in self.robot.units.started(unit) if process.mentions_ros]
            for process in started:
                until = process.ros[0][0] if process.ros else None
                environment = process_environment(process, self.robot, until)
                environment.complete &= not process.opaque
                yield RosProcess(unit.name, unit.where, environment, unit=unit)
            if not started:
                yield RosProcess(unit.name, unit.where, self.robot.units.environment(unit), unit=unit)

    def _services(self) -> Iterator[RosProcess]:
        compose = self.robot.compose
        for service in compose.services:
            if service.source.judged and service.is_ros:
                environment = self._service_environment(service)
                name = service.name
                yield RosProcess(f"service '{name}'", name.span, environment, service=service)

    def _service_environment(self, service: Service) -> Environment:
        """Dockerfile ENV, then env files, then ``environment:``."""
        compose = self.robot.compose
        environment = Environment()
        stage = compose.stage(service)
        environment.complete = stage is not None and not compose.extends_elsewhere(service)
        for one in reversed(list(stage.chain) if stage else []):
            for variable in image_variables(one):
                environment.set(variable)
        sources = compose.env_files(service)
        environment.complete &= len(sources) == len(service.env_files)
        for source in sources:
            for setting in _of_file(source):
                environment.set(Variable(setting.name, setting.value, setting.text, "env_file:"))
        for name, variable in service.environment.items():
            value = variable.value
            if value is None:
                environment.set(Variable(name, variable.name, None, "environment:"))
            else:
                environment.set(Variable(name, value, None if "$" in value else str(value), "environment:"))
        return environment


def image_variables(stage) -> Iterator[Variable]:
    """What the ENV instructions of a Dockerfile stage set: ``NAME=value ...`` or the old ``NAME value``."""
    from bringup_lint.parsers.systemd_values import split_words

    for instruction in stage.all("ENV"):
        first = next(instruction.value.words(), None)
        if first is not None and "=" not in first:
            value = instruction.value.part(len(first), len(instruction.value)).strip_located()
            yield Variable(str(first), value, None if "$" in value else str(value), "ENV")
            continue
        for word in split_words(instruction.value).words:
            name, equals, text = word.partition("=")
            if equals:
                value = word.part(len(name) + 1, len(word))
                yield Variable(name, value, None if "$" in text else str(value), "ENV")


def _setting(variable: Variable) -> Setting:
    expands = variable.origin in ("export", "shell", "declare", "ENV", "environment:")
    return Setting(variable.name, variable.value, variable.text, variable.origin, expands)


def _of_file(source: Source) -> Iterator[Setting]:
    for entry in parse(source).entries:
        text = None if source.template else str(entry.value)
        yield Setting(str(entry.name), entry.value, text, "env file", False)


def _of_script(source: Source) -> Iterator[Setting]:
    from bringup_lint.parsers.shell import commands

    for command in commands(source.located(0, len(source.text))):
        words = (
            command.words[1:]
            if command.name in ("export", "declare")
            else command.assignments
            if not command.words
            else ()
        )
        for word in words:
            name, equals, text = word.partition("=")
            if equals and OF_ROS.fullmatch(name):
                value = word.part(len(name) + 1, len(word))
                known = not re.search(r"[$`~]", text)
                yield Setting(name, value, str(value) if known else None, "export", True)
