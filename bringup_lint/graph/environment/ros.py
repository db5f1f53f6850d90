"""The variables of ROS 2: every place that sets one, and what each process of the robot ends up with."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.tree import display_name
from bringup_lint.facts.ros.variables import misspelt
from bringup_lint.graph.commands.environment import UNKNOWN
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.target import mentions_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.env_file import parse
from bringup_lint.pattern import regex
from bringup_lint.templates import has_placeholder
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import CommandLine
    from bringup_lint.graph.commands.environment import Environment
    from bringup_lint.graph.commands.environment import Variable
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.environment.launched import Launched
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.runners.runner import Start
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Located
    from bringup_lint.source import Source
    from bringup_lint.source import Span

OF_ROS = regex(r"(?:ROS|RMW|CYCLONE|CYCLONE_?DDS|FAST_?RTPS|FAST_?DDS|RCUTILS|ZENOH)_\w+")
"""Names of variables that ROS 2 or its middleware reads, and such as are taken for them."""

_LOGIN_NAMES = (".bashrc", ".bash_profile", ".profile", ".zshrc", "bash.bashrc")
_LOGIN = regex(
    r"/(?:\.bashrc|\.(?:bash_)?profile|\.zshrc|bash\.bashrc)$|/profile\.d/[^/]+$|/etc/environment$",
    0,
    "bash profile zshrc /etc/",
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


class KnownSetting(NamedTuple):
    """A setting whose value is known."""

    name: str
    value: Located
    """As written, quotes removed."""
    text: str
    """What processes see."""
    origin: str
    expands: bool


@dataclass(frozen=True, eq=False)
class RosProcess:
    """A process, or a group of them, that runs ROS 2, and its environment."""

    name: str
    """How a message calls it: ``robot.service``, ``service 'driver'``, ``camera of robot.service``."""
    where: Span
    environment: Environment
    runner: Runner | None = None
    """Who starts it; None for what a launch file starts that nothing of the tree launches."""
    line: CommandLine | None = None
    """Its command line, when it has one."""
    starts: tuple[Start, ...] = ()
    """The ROS programs on its command line."""
    launched: tuple[Launched, ...] = ()
    """The processes of a launch file, when launch gives them another environment than it has itself."""
    launcher: RosProcess | None = None
    """The process that runs ``ros2 launch``; None when nothing of the tree does."""

    @property
    def source(self) -> Source:
        return self.where.source

    @property
    def place(self) -> Located:
        """Its command line; without one, its name or the node that launch starts."""
        if self.line is not None and self.unit is not None:
            return self.line.line
        return self.source.located(self.where.start, self.where.end)

    @property
    def unit(self) -> Unit | None:
        return self.runner.unit if self.runner is not None else None

    @property
    def service(self) -> Service | None:
        return self.runner.service if self.runner is not None else None


_ENV_FILE = regex(r"(?<![\w-])(?:(?P<folder>(?<![\w.-])[\w-][\w.-]*)/)?(?<![\w-])\.env(?![\w.-])")
"""A mention of a ``.env``, and the folder before it."""


@dataclass(eq=False)
class RosEnvironment:
    """All of it, read once."""

    files: Files
    runners: Runners
    units: Callable[[], Units]
    compose: Callable[[], Compose]
    launch: Callable[[], Launch]

    def is_development(self, place: Located | Span) -> bool:
        """Whether a file is not for the robot itself, but for tests, simulation, development or the like."""
        return self.files.purpose(place) is not Purpose.ROBOT

    @cached_property
    def login_files(self) -> list[Source]:
        """The files that only people's shells read: ``.bashrc``, ``profile.d``, ``/etc/environment`` and the like."""
        tree = self.files.tree
        found = {source.name: source for source in self.files.sources if _LOGIN.search(f"/{source.name}")}
        for path in (path for name in _LOGIN_NAMES for path in tree.named(name)):
            source = None if display_name(path) in found else tree.at(path)
            if source is not None:
                found[source.name] = source
        return list(found.values())

    def mentions(self, distro: str) -> Iterator[Located]:
        """The first word of each judged file that says which distribution runs."""
        pattern = mentions_of(distro)
        for source in self.files.sources:
            match = pattern.search(source.text) if source.judged and distro in source.text else None
            if match is not None:
                yield source.located(match.start("name"), match.end("name"))

    @cached_property
    def settings(self) -> list[Setting]:
        """Every place of the tree that sets a variable of ROS, each once."""
        found: dict[tuple[Source, int], Setting] = {}
        for setting in self._all_settings():
            span = setting.value.span
            if _is_of_ros(setting.name) and span.source.judged and not _is_filled_in(setting.value):
                found.setdefault((span.source, span.start), setting)
        return list(found.values())

    def of(self, *names: str) -> list[KnownSetting]:
        """The settings of some variables whose value is known."""
        return [
            KnownSetting(each.name, each.value, each.text, each.origin, each.expands)
            for each in self.settings
            if each.name in names and each.text is not None
        ]

    def _all_settings(self) -> Iterator[Setting]:
        for process in self.processes:
            yield from _settings(process.environment)
        if self.files.of_kind("systemd-unit", "systemd-dropin"):
            units = self.units()
            for unit in units.judged:
                yield from _settings(units.environment(unit))
        for source in self.files.of_kind("env-file"):
            yield from (setting for setting in _of_file(source) if self._is_passed_on(source, setting.name))
        for source in self.files.of_kind("shell-script"):
            yield from _of_script(source)
        if self._set_in_launch:
            from bringup_lint.graph.environment.launched import launch_variables

            yield from map(_setting, launch_variables(self.launch()))
        if self.files.of_kind("dockerfile"):
            from bringup_lint.graph.runners.containers import image_variables

            for dockerfile in self.compose().images.dockerfiles:
                for stage in dockerfile.stages:
                    yield from map(_setting, image_variables(stage))

    def _is_passed_on(self, source: Source, name: str) -> bool:
        """Whether a variable of a file reaches more than docker compose, which reads the ``.env`` beside its own file:
        a service or script names the file, or a compose file the variable."""
        if source.basename != ".env" or not self.files.of_kind("compose"):
            return True
        folder = os.path.dirname(source.absolute)
        beside = [file.text for file in self.files.of_kind("compose") if os.path.dirname(file.absolute) == folder]
        if not beside or any(name in text or _ENV_FILE.search(text) for text in beside):
            return True
        return any(_reads(reader, folder) for reader in self._env_file_readers)

    @cached_property
    def _env_file_readers(self) -> list[Source]:
        """The scripts, images, units and nodes that name a ``.env``."""
        others = self.files.of_kind("shell-script", "dockerfile", "systemd-unit", "python-node", "launch-python")
        named = (each for each in others if ".env" in each.text or "dotenv" in each.text)
        return [each for each in named if "dotenv" in each.text or _ENV_FILE.search(each.text)]

    @cached_property
    def processes(self) -> list[RosProcess]:
        """Everything that runs ROS 2: what runners start, and apart from it those processes of launch files to which
        launch gives another environment."""
        return [process for launcher in self.launchers for process in self._apart(launcher)] + list(self._by_hand())

    @cached_property
    def launchers(self) -> list[RosProcess]:
        """The command lines of runners that run ROS 2; the runner itself where none of them does."""
        return [process for runner in self.runners.ros for process in _of_runner(runner)]

    @memo
    def launched_by(self, launcher: RosProcess) -> list[Launched]:
        """Every process that the launch files of a runner start, with its environment."""
        from bringup_lint.graph.environment.launched import launched

        found = (launched(expansion, base) for expansion, base in self._expansions(launcher))
        return [each for processes in found for each in processes]

    def expansion(self, start: Start) -> Expansion | None:
        """What a command of a launcher leads to with its arguments, always the same object; None when its launch file
        is not in the tree."""
        return self.runners.expansion(start)

    def _expansions(self, launcher: RosProcess) -> list[tuple[Expansion, Environment]]:
        if not self.files.of_kind(*LAUNCH):
            return []
        found = ((self.expansion(start), start.environment) for start in launcher.starts)
        return [(expansion, base) for expansion, base in found if expansion is not None]

    def started_by(self, process: RosProcess) -> int:
        """How many processes have the environment of this one: a lower bound."""
        if process.launched:
            return sum(each.node.is_node for each in process.launched)
        apart = {each.node for other in self.processes if other.launcher is process for each in other.launched}
        known = [each.node for each in self.launched_by(process) if each.node not in apart]
        return max(1, sum(node.is_node for node in known))

    def is_settled(self, process: RosProcess) -> bool:
        """Whether all that launch does to the environment on the way to the nodes is known."""
        launches = [start for start in process.starts if start.ros.kind == "launch"]
        found = self._expansions(process)
        return len(found) == len(launches) and not any(expansion.open for expansion, _ in found)

    @cached_property
    def _set_in_launch(self) -> bool:
        """Whether launch files have anything to do with variables of ROS."""
        return any(source.matches(OF_ROS) for source in self.files.of_kind(*LAUNCH))

    def _apart(self, launcher: RosProcess) -> Iterator[RosProcess]:
        """The launcher for all that has its environment, then those that have another one."""
        expansions = self._expansions(launcher) if self._set_in_launch else []
        if not expansions:
            yield launcher
            return
        from bringup_lint.graph.environment.launched import alike
        from bringup_lint.graph.environment.launched import launched
        from bringup_lint.graph.environment.launched import view

        groups: dict[tuple[Any, ...], list[Launched]] = {}
        own = len(expansions) < len(launcher.starts)
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
        from bringup_lint.graph.environment.launched import alike
        from bringup_lint.graph.environment.launched import launched

        run = {file for each in self.launchers for expansion, _ in self._expansions(each) for file in expansion.files}
        seen: set[tuple[Span, tuple[Any, ...]]] = set()
        for expansion in self.launch().entries:
            if expansion.entry in run or not expansion.entry.source.judged:
                continue
            found = (each for each in launched(expansion, UNKNOWN) if any(map(OF_ROS.fullmatch, each.node.env)))
            for sight, members in alike(found, OF_ROS).items():
                new = [each for each in members if (each.node.span, sight) not in seen]
                seen |= {(each.node.span, sight) for each in new}
                if new:
                    yield _group(new, None)


def _reads(reader: Source, folder: str) -> bool:
    """Whether a file that names a ``.env`` may mean the one of a folder: it names the folder too, or lies in or below
    it; one that lies elsewhere names another."""
    named = {match["folder"] for match in _ENV_FILE.finditer(reader.text)}
    return os.path.basename(folder) in named or f"{os.path.dirname(reader.absolute)}/".startswith(f"{folder}/")


def _of_runner(runner: Runner) -> Iterator[RosProcess]:
    lines = [line for line in runner.main if line.mentions_ros]
    for line in lines:
        starts = tuple(runner.starts_of(line))
        environment = starts[0].environment if starts else runner.environment_at(line)
        yield RosProcess(runner.name, runner.where, environment, runner, line, starts)
    if not lines:
        yield RosProcess(runner.name, runner.where, runner.environment, runner)


def _group(members: list[Launched], launcher: RosProcess | None) -> RosProcess:
    """Processes with one environment, called by the first of them."""
    first = members[0]
    holder = launcher.name if launcher else first.expansion.entry.source.basename
    name = first.node.label() + (f" and {len(members) - 1} more" if len(members) > 1 else "")
    return RosProcess(
        f"{name} of {holder}",
        first.node.span,
        first.environment,
        launcher.runner if launcher else None,
        launched=tuple(members),
        launcher=launcher,
    )


def _settings(environment: Environment) -> Iterator[Setting]:
    return (_setting(variable) for chain in environment.chains.values() for variable in chain)


def _setting(variable: Variable) -> Setting:
    expands = variable.origin in ("export", "shell", "declare", "ENV", "environment:")
    return Setting(variable.name, variable.value, variable.text, variable.origin, expands)


def _of_file(source: Source) -> Iterator[Setting]:
    for entry in parse(source).entries:
        text = None if source.template else str(entry.value)
        yield Setting(str(entry.name), entry.value, text, "env file", False)


def _is_of_ros(name: str) -> bool:
    return OF_ROS.fullmatch(name) is not None or misspelt(name) is not None


def _of_script(source: Source) -> Iterator[Setting]:
    from bringup_lint.parsers.shell import shell_commands

    for command in shell_commands(source):
        words = (
            command.words[1:]
            if command.name in ("export", "declare")
            else command.assignments
            if not command.words
            else ()
        )
        for word in words:
            name, equals, text = word.partition("=")
            if equals and _is_of_ros(name):
                value = word.part(len(name) + 1, len(word))
                known = not re.search(r"[$`~]", text)
                yield Setting(name, value, str(value) if known else None, "export", True)


def _is_filled_in(value: Located) -> bool:
    """Whether a template fills the value in, of which a shell would take only the first word."""
    span = value.span
    line = span.source.text[span.start : span.source.text.find("\n", span.start) + 1 or None]
    return has_placeholder(value) or (value.startswith(("{{", "{%", "<%")) and has_placeholder(line))
