"""Commands of an image that use a distribution of ROS that it lacks, and workspaces that another one built."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.base_images import ros_distro
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Stage
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import CommandLine
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.shell import Command

_NAMED = regex(r"/opt/ros/(?P<distro>[a-z]+)(?=/|$)")
_TESTS = ("[", "[[", "test")
_HARMLESS = frozenset("rm mkdir echo printf export test [ [[".split())
"""Programs that need nothing of a path that they name."""
_BUILDS = regex(r"\bcolcon\s+build\b")
_LIBRARIES = regex(r"(?:^|/)install/?$|^/opt/(?!ros/)[\w/-]*$")


_BRINGS = (
    r"\bros-{name}-|\b{name}\b[^\n]*(?:tar|curl|wget|git)|--from=\S+[^\n]*/opt/ros|--mount=\S*/opt/ros"
    r"|^(?:COPY|ADD)\b[^\n]*[ \t]/opt(?:/ros(?:/{name})?)?/?$"
    r"|\b(?:ln|cp|mv|rsync|mkdir)[ \t][^\n;&]*/opt/ros/{name}\b|--install-base[ =]/opt/ros/{name}\b"
    r"|\bros-\$\{{?(?!ROS_DISTRO\b)\w|{name}[\w.-]*\.(?:sh|bash|py)\b"
)
"""What may bring a distribution: packages of its name, also by another variable, archives, copies, and scripts."""


class OtherDistro(NamedTuple):
    """A path of a distribution that the image lacks."""

    word: Located
    stage: Stage
    name: str


class ForeignWorkspace(NamedTuple):
    """A workspace that an image takes from a stage of another distribution."""

    word: Located
    stage: Stage
    built: Stage


def other_distros(dockerfiles: Iterable[Dockerfile], runners: Iterable[Runner]) -> Iterator[OtherDistro]:
    """What the steps of images and the commands of their containers take from distributions that are not there."""
    for file in dockerfiles:
        for stage in file.stages:
            yield from _of_steps(stage)
    for runner in runners:
        if runner.stage is not None and not _is_mounted(runner):
            for line in runner.lines:
                yield from _of_line(line, runner.stage)


def _is_mounted(runner: Runner) -> bool:
    """Whether a volume may bring a distribution."""
    volumes = runner.service.volumes if runner.service is not None else []
    return any((volume.target or "").startswith("/opt") for volume in volumes)


def _of_steps(stage: Stage) -> Iterator[OtherDistro]:
    for command in commands_of(stage):
        if not command.depth and command.ends != "||" and command.name not in _HARMLESS:
            yield from _of_words(command.words, stage)


def _of_line(line: CommandLine, stage: Stage) -> Iterator[OtherDistro]:
    tested = False
    for step in line.steps:
        if not tested and _is_sourced(step.command):
            yield from _of_words(step.command.words[1:2], stage)
        tested = step.command.ends == "&&" and step.command.name in _TESTS


def _is_sourced(command: Command) -> bool:
    if command.name not in ("source", ".") or command.hides_errors:
        return False
    return not command.depth and command.ends not in ("||", "&&")


def _of_words(words: Iterable[Located], stage: Stage) -> Iterator[OtherDistro]:
    for word in words:
        match = _NAMED.match(word)
        if match is not None and _lacks(stage, match["distro"]):
            yield OtherDistro(word, stage, match["distro"])


def _lacks(stage: Stage, other: str) -> bool:
    """Whether no step brings another distribution."""
    own = ros_distro(stage.origin)
    if not own or other == own:
        return False
    brings = re.compile(_BRINGS.format(name=re.escape(other)))
    return not any(brings.search(text) for text in _texts(stage))


def _texts(stage: Stage) -> Iterator[str]:
    """What brings files into an image."""
    for each in stage.chain:
        for instruction in each.all("RUN", "COPY", "ADD"):
            yield " ".join((instruction.name, *instruction.flags, instruction.value))


def foreign_workspaces(dockerfiles: Iterable[Dockerfile]) -> Iterator[ForeignWorkspace]:
    """The workspaces that COPY --from takes from a stage of another distribution."""
    for file in dockerfiles:
        for stage in file.stages:
            yield from _copied(file, stage)


def _copied(file: Dockerfile, stage: Stage) -> Iterator[ForeignWorkspace]:
    for instruction in stage.all("COPY"):
        origin = next((flag.removeprefix("--from=") for flag in instruction.flags if flag.startswith("--from=")), "")
        other = file.stage(origin)
        if other is None or not _are_apart(stage, other) or not _builds(other):
            continue
        words = list(instruction.value.words())
        if any(_LIBRARIES.search(word) for word in words[:-1]):
            yield ForeignWorkspace(words[0], stage, other)


def _are_apart(one: Stage, other: Stage) -> bool:
    distros = (ros_distro(one.origin), ros_distro(other.origin))
    return all(distros) and distros[0] != distros[1]


def _builds(stage: Stage) -> bool:
    return any(_BUILDS.search(each.value) for link in stage.chain for each in link.all("RUN"))
