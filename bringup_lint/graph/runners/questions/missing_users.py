"""Users as whom a container is to run, and that its image certainly does not have.

Source: docs.docker.com/reference/dockerfile, "USER": a name is looked up in /etc/passwd of the image.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.containers.base_images import runs_as_root
from bringup_lint.graph.containers.questions.devcontainers import Container
from bringup_lint.graph.containers.questions.devcontainers import containers
from bringup_lint.model.compose import Service
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files

_NAME = regex(r"[a-z_][\w-]*")
_WORD = regex(r"[\w-]+")
_SYSTEM = frozenset(
    "root daemon bin sys sync games man lp mail news uucp proxy www-data backup list irc gnats nobody _apt"
    " ubuntu".split()
)
"""Of base-passwd, and the user of Ubuntu's images since 23.04."""
_PROGRAMS = frozenset(
    "apt apt-get pip pip3 colcon git echo printf rm mkdir chmod chown cd touch ls true : set export locale-gen".split()
)
"""Programs that make no users, as long as apt only installs packages that make none."""
_INSTALLS_SYSTEM = ("apt", "apt-get")
_HARMLESS = regex(
    r"ros-[\w.${}-]+|python3-[\w.-]+|lib[\w.+-]+-dev|build-essential|cmake|git|curl|wget|nano|vim|sudo|less|can-utils"
    r"|iproute2|ca-certificates|locales|tzdata|update|upgrade|install|clean|autoremove"
)
"""Packages without users of their own, and the commands of apt."""
_SETUP = regex(r"/opt/ros/[\w.${}-]+/setup\.(?:ba)?sh")
_SAYS = regex(r"/etc/passwd|sources\.list")
"""A step changes the users, or where packages come from."""
_WITHIN = regex(r"/(?!etc(?:/|$)|usr/lib/sysusers)[\w.-][^$\s]*")
"""A folder of an image in which there are no users."""
_FEATURES = regex(r'"features"|/etc\b|initializeCommand')
"""What gives a development container users of its own."""
_ELSEWHERE = regex(r"\badditional_contexts\b", hints="additional_contexts")
"""A build takes its images from where it wants."""
_DEEPEST = 20
"""Stages below one another that are looked at."""


class MissingUser(NamedTuple):
    name: str
    where: Located
    image: Located
    """Where the image at the bottom is named."""


def missing_users(files: Files, compose: Compose) -> Iterator[MissingUser]:
    if any(file.source.says(_ELSEWHERE) for file in compose.files):
        return
    for file in compose.images.dockerfiles:
        for stage in file.stages:
            yield from _of_stage(stage)
    for service in compose.whole_services:
        if service.user is not None and not _gets_users(service):
            yield from _of(compose.stage(service), _image(service), service.user.partition(":")[0], service.user)
    for container in containers(files):
        yield from _of_container(compose, container)


def _gets_users(service: Service) -> bool:
    """Whether files that the service is given may have users."""
    mounts = any(str(each.target).startswith("/etc") for each in service.volumes)
    return mounts or any(service.get(key) is not None for key in ("configs", "secrets"))


def _of_stage(stage: Stage) -> Iterator[MissingUser]:
    for instruction in stage.all("USER"):
        yield from _of(stage, None, instruction.value.partition(":")[0], instruction.value)


def _of_container(compose: Compose, container: Container) -> Iterator[MissingUser]:
    user = container.first(("remoteUser",), ("containerUser",))
    if user is None or container.source.says(_FEATURES):
        return
    service = container.service(compose)
    if service is not None:
        yield from _of(compose.stage(service), _image(service), str(user), user)
    else:
        stage = container.stage(compose)
        yield from _of(stage, container.first(("image",)) if stage is None else None, str(user), user)


def _image(service: Service) -> Located | None:
    return service.image if service.build is None else None


def _of(stage: Stage | None, image: Located | None, name: str, where: Located) -> Iterator[MissingUser]:
    if not _NAME.fullmatch(name) or name in _SYSTEM:
        return
    chain = [] if stage is None else list(islice(stage.chain, _DEEPEST + 1))
    bottom = chain[-1].image if chain else image
    if bottom is None or len(chain) > _DEEPEST or any("$" in one.image for one in chain) or not runs_as_root(bottom):
        return
    if not any(_may_make(one, name) for one in chain):
        yield MissingUser(name, where, bottom)


def _may_make(stage: Stage, name: str) -> bool:
    """Whether a step of a stage may make a user: it says the name, or does what cannot be seen."""
    where = stage.start.keyword.span
    words = where.source.once((_said, where.start), partial(_said, stage))
    at = 0 if words is None else bisect_left(words, name)
    return words is None or (at < len(words) and words[at].startswith(name))


def _said(stage: Stage) -> list[str] | None:
    """The words of the steps of a stage, in order; None where a step does what cannot be seen."""
    steps = [*stage.all("RUN", "COPY", "ADD")]
    text = "\n".join([*(str(each.value) for each in steps), *(str(each) for one in steps for each in one.heredocs)])
    if _SAYS.search(text) or not all(map(_is_seen, commands_of(stage))):
        return None
    folders = [str(each.value) for each in stage.all("WORKDIR")]
    inside = bool(folders) and all(map(_WITHIN.fullmatch, folders))
    if not all(_stays_within(each, inside) for each in stage.all("COPY", "ADD")):
        return None
    return sorted(set(_WORD.findall(text)))


def _stays_within(copy: Instruction, inside: bool) -> bool:
    """Whether files are copied to a folder in which there are no users; ``inside`` for the working folders."""
    target = (copy.exec_form or copy.value.split() or [""])[-1]
    if ".." in target or "$" in target:
        return False
    return _WITHIN.fullmatch(target) is not None or (inside and not target.startswith("/"))


def _is_seen(command: Command) -> bool:
    """Whether a command certainly makes no user."""
    words = unwrapped(command.words)
    program = str(words[0]) if words else ""
    if program in (".", "source"):
        return len(words) == 2 and _SETUP.fullmatch(words[1]) is not None
    if program in _INSTALLS_SYSTEM:
        return all(word.startswith("-") or _HARMLESS.fullmatch(word) for word in words[1:])
    return program in _PROGRAMS or not command.words
