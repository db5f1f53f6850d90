"""The texts that the shell of an image reads: its build steps, what it starts in shell form, and health checks."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import TYPE_CHECKING

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Instruction
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.model.shell import Command
    from bringup_lint.source import Located

_PLAIN_HEREDOC = regex(r"<<-?[ \t]*(?P<quote>['\"]?)\w+(?P=quote)[ \t]*")
"""The text itself is the script; with a program before it, ``RUN python3 <<EOF``, that one reads it."""
_CHECK = regex(r"CMD[ \t]+(?=[^\s\[])")


class Reads(Enum):
    STEP = "a step of the build"
    START = "what the container starts"
    CHECK = "a health check"


class ShellText(NamedTuple):
    reads: Reads
    commands: list[Command]


def shell_texts(compose: Compose, file: Dockerfile, stage: Stage) -> Iterator[ShellText]:
    """What the shell of a stage reads."""
    for instruction in stage.all("RUN"):
        if instruction.exec_form is None and _is_for_sh(instruction):
            yield ShellText(Reads.STEP, list(commands_of_run(instruction)))
    if stage is file.final or compose.users(stage):
        own = (each for each in _started(compose, stage) if each in stage.instructions)
        yield from (ShellText(Reads.START, commands(each.value)) for each in own)
        check = stage.last("HEALTHCHECK")
        match = _CHECK.match(check.value) if check in stage.instructions and check is not None else None
        if check is not None and match is not None:
            yield ShellText(Reads.CHECK, commands(check.value.part(match.end(), len(check.value))))


def _is_for_sh(instruction: Instruction) -> bool:
    if not instruction.heredocs or not instruction.value.startswith("<<"):
        return True
    is_script = _PLAIN_HEREDOC.fullmatch(instruction.value) is not None
    return is_script and not any(text.lstrip().startswith("#!") for text in instruction.heredocs)


def _started(compose: Compose, stage: Stage) -> Iterator[Instruction]:
    """ENTRYPOINT and CMD in shell form, where something runs them."""
    users = compose.users(stage)
    entrypoint, command = stage.last("ENTRYPOINT"), stage.last("CMD")
    in_shell = entrypoint is not None and entrypoint.exec_form is None
    if entrypoint is not None and in_shell and not (users and all(each.entrypoint for each in users)):
        yield entrypoint
    replaced = bool(users) and all(each.entrypoint or each.command for each in users)
    if command is not None and command.exec_form is None and not in_shell and not replaced:
        yield command


def checks_of(service: Service) -> list[Command]:
    """What a shell reads of the health check of a service: a plain text, or the word after CMD-SHELL."""
    check = service.get("healthcheck")
    test = check.get("test") if isinstance(check, Mapping) and check.get("disable") is None else None
    text = _text(test)
    return [] if text is None else commands(text)


def _text(test: object) -> Located | None:
    if isinstance(test, Scalar):
        return None if test.is_null else test.value
    words = [each.value for each in test.scalars] if isinstance(test, Sequence) else []
    return words[1] if len(words) == 2 and words[0] == "CMD-SHELL" else None
