"""The variables of ROS 2: every place that sets one, and what each process of the robot ends up with."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.tree import display_name
from bringup_lint.graph.environment.launched import UNKNOWN
from bringup_lint.graph.environment.launched import launch_variables
from bringup_lint.graph.environment.launching import Launched
from bringup_lint.graph.environment.launching import Launching
from bringup_lint.graph.environment.launching import alike
from bringup_lint.graph.environment.launching import expansion_of
from bringup_lint.graph.environment.launching import launched
from bringup_lint.graph.environment.launching import of_script
from bringup_lint.graph.environment.launching import of_service
from bringup_lint.graph.environment.launching import of_unit
from bringup_lint.graph.environment.launching import view
from bringup_lint.graph.systemd.environment import Environment
from bringup_lint.graph.systemd.environment import Variable
from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.target import mentions_of
from bringup_lint.parsers.env_file import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder

if TYPE_CHECKING:
    from bringup_lint.graph.environment.images import Lacking
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.systemd.process import Step
    from bringup_lint.model.compose import Service
    from bringup_lint.robot import Robot

OF_ROS = re.compile(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|RCUTILS|ZENOH)_\w+")
"""Names of variables that ROS 2 or its middleware reads."""

_LOGIN_NAMES = (".bashrc", ".bash_profile", ".profile", ".zshrc", "bash.bashrc")
_LOGIN = re.compile(r"/(?:\.bashrc|\.(?:bash_)?profile|\.zshrc|bash\.bashrc)$|/profile\.d/[^/]+$|/etc/environment$")
_ROS2 = re.compile(r"\bros2[ \t]+(?:launch|run)\b")

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
    """How a message calls it: ``robot.service``, ``service 'driver'``, ``camera of robot.service``."""
    where: Span
    environment: Environment
    unit: Unit | None = None
    service: Service | None = None
    starts: tuple[Launching, ...] = ()
    """The ROS programs on its command lines."""
    launched: tuple[Launched, ...] = ()
    """The processes of a launch file, when launch gives them another environment than it has itself."""
    launcher: RosProcess | None = None
    """Who runs ``ros2 launch``; None when nothing of the tree does."""

    @property
    def source(self) -> Source:
        return self.where.source


@dataclass(eq=False)
class RosEnvironment:
    """All of it, read once."""

    robot: Robot
    _launched: dict[int, list[Launched]] = field(default_factory=dict)
    _expanded: dict[int, Expansion | None] = field(default_factory=dict)

    @staticmethod
    def is_development(place: Located | Span) -> bool:
        """Whether the path of the file says that it is for tests, simulation or development."""
        return bool(_SIMULATION.search(place.path))

    @cached_property
    def login_files(self) -> list[Source]:
        """The files that only people's shells read: ``.bashrc``, ``profile.d``, ``/etc/environment`` and the like."""
        tree = self.robot.tree
        found = {source.name: source for source in self.robot.sources if _LOGIN.search(f"/{source.name}")}
        for path in (path for name in _LOGIN_NAMES for path in tree.named(name)):
            source = None if display_name(path) in found else tree.read(path)
            if source is not None:
                found[source.name] = source
        return list(found.values())

    @property
    def lacking_middleware(self) -> Iterator[Lacking]:
        """The places that select a middleware which the image of the container does not contain."""
        from bringup_lint.graph.environment.images import lacking

        return lacking(self.robot)

    def first_mention(self, distro: str) -> Located | None:
        """The first word of a judged file that says which distribution runs."""
        pattern = mentions_of(distro)
        for source in self.robot.sources:
            match = pattern.search(source.text) if source.judged else None
            if match is not None:
                return source.located(match.start("name"), match.end("name"))
        return None

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
        if self._set_in_launch:
            yield from map(_setting, launch_variables(self.robot))
        if self.robot.of_kind("dockerfile"):
            for dockerfile in self.robot.dockerfiles:
                for stage in dockerfile.stages:
                    yield from map(_setting, image_variables(stage))

    @cached_property
    def processes(self) -> list[RosProcess]:
        """Everything that runs ROS 2: units, compose services and scripts, and apart from them those processes of their
        launch files to which launch gives another environment."""
        return [process for launcher in self.launchers for process in self._apart(launcher)] + list(self._by_hand())

    @cached_property
    def launchers(self) -> list[RosProcess]:
        """The units, compose services and scripts that run ROS 2."""
        found = []
        if self.robot.of_kind("systemd-unit", "systemd-dropin"):
            found += list(self._units())
        if self.robot.of_kind("compose"):
            found += list(self._services())
        if self.robot.of_kind("shell-script"):
            found += list(self._scripts(found))
        return found

    def launched_by(self, launcher: RosProcess) -> list[Launched]:
        """Every process that the launch files of a unit, service or script start, with its environment."""
        if id(launcher) not in self._launched:
            found = (launched(expansion, base) for expansion, base in self._expansions(launcher))
            self._launched[id(launcher)] = [each for processes in found for each in processes]
        return self._launched[id(launcher)]

    def expansion(self, start: Launching) -> Expansion | None:
        """What a command of a launcher leads to with its arguments, always the same object; None when its launch file
        is not in the tree."""
        if id(start) not in self._expanded:
            self._expanded[id(start)] = expansion_of(start.ros, self.robot.launch)
        return self._expanded[id(start)]

    def _expansions(self, launcher: RosProcess) -> list[tuple[Expansion, Environment]]:
        if not self.robot.of_kind(*LAUNCH):
            return []
        found = ((self.expansion(start), start.environment) for start in launcher.starts)
        return [(expansion, base) for expansion, base in found if expansion is not None]

    def started_by(self, process: RosProcess) -> int:
        """How many processes have the environment of this one: a lower bound."""
        if process.launched:
            return sum(each.node.is_node for each in process.launched)
        apart = {id(each.node) for other in self.processes if other.launcher is process for each in other.launched}
        known = [each.node for each in self.launched_by(process) if id(each.node) not in apart]
        return max(1, sum(node.is_node for node in known))

    def is_settled(self, process: RosProcess) -> bool:
        """Whether all that launch does to the environment on the way to the nodes is known."""
        launches = [start for start in process.starts if start.ros.kind == "launch"]
        found = self._expansions(process)
        return len(found) == len(launches) and not any(expansion.open for expansion, _ in found)

    @cached_property
    def _set_in_launch(self) -> bool:
        """Whether launch files have anything to do with variables of ROS."""
        return any(OF_ROS.search(source.text) for source in self.robot.of_kind(*LAUNCH))

    def _apart(self, launcher: RosProcess) -> Iterator[RosProcess]:
        """The launcher for all that has its environment, then those that have another one."""
        expansions = self._expansions(launcher) if self._set_in_launch else []
        groups: dict[tuple, list[Launched]] = {}
        own = len(expansions) < len(launcher.starts) or not expansions
        for expansion, base in expansions:
            by_view = alike(launched(expansion, base), OF_ROS)
            own |= by_view.pop(view(base, OF_ROS), None) is not None or expansion.open or not by_view
            for seen, members in by_view.items():
                groups.setdefault(seen, []).extend(members)
        if own:
            yield launcher
        for members in groups.values():
            yield _group(members, launcher)

    def _by_hand(self) -> Iterator[RosProcess]:
        """The processes of launch files that nothing of the tree starts, as far as they set variables of ROS."""
        if not self._set_in_launch:
            return
        run = {
            id(file) for each in self.launchers for expansion, _ in self._expansions(each) for file in expansion.files
        }
        seen: set[tuple[Span, tuple]] = set()
        for expansion in self.robot.launch.entries:
            if id(expansion.entry) in run or not expansion.entry.source.judged:
                continue
            found = (each for each in launched(expansion, UNKNOWN) if any(map(OF_ROS.fullmatch, each.node.env)))
            for sight, members in alike(found, OF_ROS).items():
                new = [each for each in members if (each.node.span, sight) not in seen]
                seen |= {(each.node.span, sight) for each in new}
                if new:
                    yield _group(new, None)

    def _units(self) -> Iterator[RosProcess]:
        for unit in self.robot.units.dds:
            started = [process for process in self.robot.units.started(unit) if process.mentions_ros]
            for process in started:
                until = process.ros[0][0] if process.ros else None
                environment = process_environment(process, self.robot, until)
                environment.complete &= not process.opaque
                starts = tuple(of_unit(process, self.robot))
                yield RosProcess(unit.name, unit.where, environment, unit=unit, starts=starts)
            if not started:
                yield RosProcess(unit.name, unit.where, self.robot.units.environment(unit), unit=unit)

    def _services(self) -> Iterator[RosProcess]:
        compose = self.robot.compose
        for service in compose.services:
            if service.source.judged and service.is_ros:
                environment = self._service_environment(service)
                starts = tuple(of_service(service, compose.stage(service), environment))
                if starts:
                    environment = starts[0].environment
                name = service.name
                yield RosProcess(f"service '{name}'", name.span, environment, service=service, starts=starts)

    def _scripts(self, found: list[RosProcess]) -> Iterator[RosProcess]:
        """The scripts that no unit runs."""
        run = {id(step.script) for each in found if each.unit for step in self._steps(each.unit) if step.script}
        for source in self.robot.of_kind("shell-script"):
            if source.judged and not source.template and id(source) not in run and _ROS2.search(source.text):
                starts = tuple(of_script(source.located(0, len(source.text)), UNKNOWN))
                if starts:
                    where = starts[0].ros.program.span
                    yield RosProcess(source.basename, where, starts[0].environment, starts=starts)

    def _steps(self, unit: Unit) -> Iterator[Step]:
        return (step for process in self.robot.units.processes(unit) for step in process.steps)

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


def _group(members: list[Launched], launcher: RosProcess | None) -> RosProcess:
    """Processes with one environment, called by the first of them."""
    first = members[0]
    holder = launcher.name if launcher else first.expansion.entry.source.basename
    name = first.node.label() + (f" and {len(members) - 1} more" if len(members) > 1 else "")
    return RosProcess(
        f"{name} of {holder}",
        first.node.span,
        first.environment,
        launcher.unit if launcher else None,
        launcher.service if launcher else None,
        launched=tuple(members),
        launcher=launcher,
    )


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
