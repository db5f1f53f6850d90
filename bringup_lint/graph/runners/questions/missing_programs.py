"""Scripts that containers start and that nothing brings into their images."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.folders import above
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.containers.base_images import is_plain
from bringup_lint.graph.runners.containers import in_image
from bringup_lint.graph.runners.containers import may_hold
from bringup_lint.graph.runners.containers import words_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.compose import Service
    from bringup_lint.model.compose import Volume
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.source import Located

_SCRIPT = regex(r"[\w./-]+\.(?:sh|bash|py)")
_MADE = regex(r"^/(?:usr|bin|sbin|lib|proc|dev|opt/ros)/|/(?:install|build|devel|venv|\.venv|site-packages)/")
"""Folders that packages and builds fill."""
_LONGEST = 4096
"""Characters of a path that the kernel takes (PATH_MAX)."""
_ENTRYPOINT = "/ros_entrypoint.sh"
_FETCHES = regex(r"\b(?:clone|vcs|unzip|tar|rsync|svn|cp|mv|ln)\b|\b(?:curl|wget)\b[^\n;&]{0,400}\.(?:sh|py|zip|tgz)\b")
"""May put files into folders that the step does not name."""
_BRINGING = ("configs", "secrets", "develop", "extends", "volumes_from")
"""Keys of a service by which it may get files that its own volumes do not name."""
_GIVEN = regex(r"(?::|target=)(/[\w/.-]+)")
"""Where a volume appears in a container, as an option of ``docker run`` says it."""
_CHANGES_MODE = regex(r"\bchmod\b[^\n;&|]*")


class MissingProgram(NamedTuple):
    word: Located
    """As the entrypoint or command names it."""
    path: str
    """In the image."""
    stage: Stage
    runner: Runner
    found: str
    """The file of the tree with this name; empty without one, or with several."""


def missing_programs(files: Files, runners: Iterable[Runner]) -> Iterator[MissingProgram]:
    for runner in runners:
        stage = runner.stage
        if stage is None or not runner.source.judged or not is_plain(stage.origin):
            continue
        if runner.service is not None and any(map(_starts, _beside(files, runner.service))):
            continue
        for word in _programs(runner, stage):
            path = _path(runner, stage, word)
            if path is not None and lacks(files, runner, path):
                found = [os.path.relpath(each) for each in files.tree.named(posixpath.basename(path))]
                yield MissingProgram(word, path, stage, runner, found[0] if len(found) == 1 else "")


def _starts(service: Service) -> bool:
    """Whether it says itself what its container starts."""
    return bool(service.entrypoint or service.command)


def _programs(runner: Runner, stage: Stage) -> Iterator[Located]:
    """The scripts that are started first: the first word, and the one after a shell or the entrypoint of ROS."""
    service = runner.service
    entrypoint = tuple(service.entrypoint if service is not None else ()) or tuple(words_of(stage.last("ENTRYPOINT")))
    own = service is not None and bool(service.entrypoint)
    command = tuple(service.command if service is not None else ())
    if not command and not own:
        command = tuple(words_of(stage.last("CMD")))
    words = unwrapped((*entrypoint, *command))
    while words:
        first, *rest = words
        if len(first) <= _LONGEST and _SCRIPT.fullmatch(first) and "/" in first and first != _ENTRYPOINT:
            yield first
            return
        if first != _ENTRYPOINT and program_name(first) not in (*SHELLS, "python3", "python"):
            return
        words = unwrapped(tuple(rest))


def _path(runner: Runner, stage: Stage, word: Located) -> str | None:
    folder = runner.service.scalar("working_dir") if runner.service is not None else None
    path = in_image(stage, str(word), folder)
    return None if path is None or _MADE.search(path) else path


def lacks(files: Files, runner: Runner, path: str) -> bool:
    """Whether the container of a runner certainly has no file at a path, as far as the tree says."""
    stage, service = runner.stage, runner.service
    pulled = service.image if service is not None and service.build is None else None
    origin = stage.origin if stage is not None else str(pulled or "")
    if not is_plain(origin) or "$" in path or _MADE.search(path) or runner.reads(path) is not None:
        return False
    return not _is_mounted(files, runner, path) and (stage is None or not _is_in_image(files, stage, path))


def _is_in_image(files: Files, stage: Stage, path: str) -> bool:
    """Whether a step may put a file there."""
    if may_hold(files, stage, path):
        return True
    name = posixpath.basename(path)
    for one in stage.chain:
        for step in one.all("RUN", "ONBUILD"):
            text = _CHANGES_MODE.sub("", "\n".join([str(step.value), *map(str, step.heredocs), *step.flags]))
            if name in text or (posixpath.dirname(path) != "/" and _FETCHES.search(text)):
                return True
    return False


def _is_mounted(files: Files, runner: Runner, path: str) -> bool:
    """Whether a volume may hold it, or somebody mounts something there by hand."""
    service = runner.service
    if service is not None:
        return any(_brings(files, each, path) for each in (service, *_beside(files, service)))
    folders = {path, *above(path)}
    return any(match[1] in folders for source in files.sources for match in _GIVEN.finditer(source.text))


def _beside(files: Files, service: Service) -> Iterator[Service]:
    """The services of this name in the files of its folder, which may be given together with its own."""
    from bringup_lint.parsers.compose import parse

    for file in files.parsed(parse, [each for each in files.beside(service.source) if each.kind == "compose"]):
        other = file.service(str(service.name))
        if other is not None:
            yield other


def _brings(files: Files, service: Service, path: str) -> bool:
    if any(service.get(key) is not None for key in _BRINGING):
        return True
    over = (each for each in service.volumes if f"{path}/".startswith(f"{str(each.target).rstrip('/')}/"))
    return any(_may_hold(files, service, each, path) for each in over)


def _may_hold(files: Files, service: Service, volume: Volume, path: str) -> bool:
    """Whether a volume over a path may hold its file: all but folders of the tree may, which are known."""
    source = str(volume.source or "")
    if not source.startswith("."):
        return True
    below = path[len(str(volume.target).rstrip("/")) :].lstrip("/")
    folder = os.path.join(os.path.dirname(service.source.absolute), source)
    host = os.path.normpath(os.path.join(folder, below))
    return not files.tree.exists(os.path.normpath(folder)) or files.tree.exists(host) or files.tree.is_ignored(host)
