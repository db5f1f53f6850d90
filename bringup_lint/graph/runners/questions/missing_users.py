"""Users as whom a container is to run, and that its image certainly does not have.

Source: docs.docker.com/reference/dockerfile, "USER": a name is looked up in /etc/passwd of the image.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.containers.base_images import runs_as_root
from bringup_lint.graph.containers.questions.devcontainers import Container
from bringup_lint.graph.containers.questions.devcontainers import containers
from bringup_lint.model.compose import Service
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of
from bringup_lint.parsers.dockerfile_variables import expanded
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files

_NAME = regex(r"[a-z_][\w-]*")
_SYSTEM = frozenset(
    "root daemon bin sys sync games man lp mail news uucp proxy www-data backup list irc gnats nobody _apt"
    " ubuntu".split()
)
"""Of base-passwd, and the user of Ubuntu's images since 23.04."""
_MAKERS = ("useradd", "adduser", "newusers", "usermod")
_READERS = ("sh", "bash", "zsh", "python", "python3", "ansible-playbook", "make")
_SCRIPT = regex(r"\S+\.(?:sh|bash|py|run)|(?!/(?:usr/)?s?bin/|/opt/ros/)\S*/\S*")
"""A program of the image's own."""
_OVER = regex(r"/etc/passwd|[ \t\"](?:/|/etc/?)[\"\]]?\s*$")
"""Files that a step puts over those of /etc."""
_FEATURES = regex(r'"features"|/etc/passwd')
"""What gives a development container users of its own."""


class MissingUser(NamedTuple):
    name: str
    where: Located
    image: Located
    """Where the image at the bottom is named."""


def missing_users(files: Files, compose: Compose) -> Iterator[MissingUser]:
    for file in compose.images.dockerfiles:
        for stage in file.stages:
            yield from _of_stage(stage)
    for service in compose.whole_services:
        if service.user is not None and not any(str(each.target).startswith("/etc") for each in service.volumes):
            yield from _of(compose.stage(service), _image(service), service.user.partition(":")[0], service.user)
    for container in containers(files):
        yield from _of_container(compose, container)


def _of_stage(stage: Stage) -> Iterator[MissingUser]:
    for instruction in stage.all("USER"):
        name = expanded(stage, instruction).partition(":")[0]
        yield from _of(stage, None, name, instruction.value)


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
    bottom = image if stage is None else list(stage.chain)[-1].image
    if bottom is None or not runs_as_root(stage.origin if stage is not None else bottom):
        return
    if not _NAME.fullmatch(name) or name in _SYSTEM:
        return
    if stage is None or not any(_may_make(one, name) for one in stage.chain):
        yield MissingUser(name, where, bottom)


def _may_make(stage: Stage, name: str) -> bool:
    """Whether a step of a stage may make a user: it says the name, or does what cannot be seen."""
    steps = [*stage.all("RUN", "COPY", "ADD")]
    text = "\n".join([*(str(each.value) for each in steps), *(str(each) for one in steps for each in one.heredocs)])
    if re.search(rf"(?<![\w-]){re.escape(name)}", text) or any(_OVER.search(str(each.value)) for each in steps):
        return True
    return any(map(_is_unseen, commands_of(stage)))


def _is_unseen(command: Command) -> bool:
    """Whether a command runs a program of the image's own, or makes a user whose name is a variable."""
    words = unwrapped(command.words)
    program = program_name(words[0]) if words else ""
    if words and ("$" in words[0] or _SCRIPT.fullmatch(words[0])):
        return True
    if program in _READERS and "-c" not in words:
        return True
    return any(each in command.words for each in _MAKERS) and any("$" in word for word in command.words)
