"""Who owns the folders of an image: what WORKDIR, COPY and mkdir make, and builds that need to write there.

Source: docs.docker.com/reference/dockerfile, "COPY --chown": files and folders belong to root without it.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.folders import above
from bringup_lint.folders import joined
from bringup_lint.graph.containers.base_images import runs_as_root
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.parsers.dockerfile_variables import expanded
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_HOME = regex(r"/home/[^/]+")
"""Belongs to its user, whoever names it first."""
_LONGEST = 4096
"""Characters of a path that the kernel takes (PATH_MAX)."""
_GIVERS = ("install", "useradd", "adduser", "usermod")
_MODE = regex(r"-\w*m|--mode")
_TAKE_VARIABLES = ("USER", "WORKDIR", "COPY", "ADD")
_PLACES = ("--build-base", "--install-base", "--log-base")


class ForeignBuild(NamedTuple):
    """A build of a workspace in a folder that another user made."""

    instruction: Instruction
    command: Located
    folder: str
    made: Located
    """The instruction that made the folder for root."""


def builds_of_others(stage: Stage) -> Iterator[ForeignBuild]:
    """The builds of a stage, as a user of its own, in folders that root made. Who the user is, is for others to say."""
    if not runs_as_root(stage.origin):
        return
    root_made: dict[str, Located | None] = {}
    """None for a folder that another user made."""
    folder, root = "/", True
    for one in reversed(list(stage.chain)):
        for each in one.instructions:
            value = str(expanded(one, each)) if each.name in _TAKE_VARIABLES else ""
            if each.name == "USER":
                root = value.partition(":")[0] in ("root", "0")
            elif each.name == "WORKDIR":
                folder = joined(folder, value.strip("\"'"))
                root_made.setdefault(folder, each.keyword if root else None)
            elif each.name in ("COPY", "ADD"):
                owned = any(flag.startswith("--chown") for flag in each.flags)
                target = _target(folder, value)
                root_made.setdefault(target, None if owned else each.keyword)
            elif each.name == "RUN" and each.exec_form is None:
                for command in commands_of_run(each):
                    for path in _given(command):
                        root_made.setdefault(joined(folder, path), None)
                    for path in _made(command):
                        root_made.setdefault(joined(folder, path), command.words[0] if root else None)
                build = _build(each, folder)
                if one is stage and build is not None and not root:
                    made = root_made.get(build[1])
                    if made is not None and not _HOME.fullmatch(build[1]):
                        yield ForeignBuild(each, *build, made)


def _target(folder: str, value: str) -> str:
    """The folder that a copy goes to."""
    words = value.split()
    return joined(folder, words[-1].strip("\"'[],")) if words else folder


def _given(command: Command) -> Iterator[str]:
    """The folders that a command may make for another user."""
    if command.name in _GIVERS or (command.name == "mkdir" and any(map(_MODE.match, command.words[1:]))):
        yield from (str(word) for word in command.words[1:] if word.startswith("/"))


def _made(command: Command) -> Iterator[str]:
    """The folders that mkdir makes, those above included."""
    if command.name == "mkdir":
        for path in (word for word in command.words[1:] if not word.startswith("-") and "$" not in word):
            if len(path) <= _LONGEST:
                yield from (str(path), *above(path))


def _build(instruction: Instruction, folder: str) -> tuple[Located, str] | None:
    """The first ``colcon build`` of a step that keeps its folders, and where it runs."""
    for command in commands_of_run(instruction):
        words = command.words
        if command.name == "cd" and len(words) > 1:
            if "$" in words[1] or "~" in words[1]:
                return None
            folder = joined(folder, words[1])
        if command.name == "colcon" and "build" in words[1:2] and not any(word in _PLACES for word in words):
            return words[0], folder
    return None
