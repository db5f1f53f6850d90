"""Workspaces that an image has built and that a bind mount of its service hides."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.folders import joined
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile import commands_of_run
from bringup_lint.parsers.dockerfile_variables import expanded
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.compose import Service
    from bringup_lint.model.compose import Volume
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.source import Located


_BUILDS = regex(r"\bdocker[ -]compose\b[^\n]{0,200}[ \t](?:run|exec)\b[^\n]{0,200}\bcolcon\b")
_GUIDES = ("Makefile", "justfile", "Justfile", "README.md", "Taskfile.yml")
_MOST = 64 * 1024
"""Bytes of a guide that are read."""


class HiddenWorkspace(NamedTuple):
    service: Service
    volume: Volume
    folder: str
    build: Located
    sourced: Located


def hidden_workspaces(files: Files, runners: Iterable[Runner]) -> Iterator[HiddenWorkspace]:
    found = list(_hidden(files, runners))
    if found and not _is_built_by_hand(files):
        yield from found


def _hidden(files: Files, runners: Iterable[Runner]) -> Iterator[HiddenWorkspace]:
    known = [each for each in runners if each.service is not None]
    builders = {runner.source for runner in known if any("colcon" in each.words for each in runner.commands)}
    built: dict[int, list[tuple[str, Located]]] = {}
    for runner in known:
        if runner.service is None or runner.stage is None or runner.source in builders:
            continue
        if id(runner.stage) not in built:
            built[id(runner.stage)] = list(_built(runner.stage))
        for folder, build in built[id(runner.stage)]:
            sourced = _sourced(runner, folder)
            volume = _over(files, runner.service, folder)
            if sourced is not None and volume is not None:
                yield HiddenWorkspace(runner.service, volume, folder, build, sourced)


def _is_built_by_hand(files: Files) -> bool:
    """Whether somebody builds in a container of Compose, as a guide, a script or a Makefile says."""
    tree = files.tree
    paths = (path for name in _GUIDES for path in tree.named(name))
    texts = (*(tree.head(path, _MOST) for path in paths), *(each.text for each in files.of_kind("shell-script")))
    return any(map(_BUILDS.search, texts))


def _built(stage: Stage) -> Iterator[tuple[str, Located]]:
    """The folders in which the steps of an image build workspaces."""
    folder = "/"
    for one in reversed(list(stage.chain)):
        for each in one.all("WORKDIR", "RUN"):
            if each.name == "WORKDIR":
                folder = joined(folder, str(expanded(one, each)).strip("\"'"))
                continue
            here = folder
            for command in commands_of_run(each):
                if command.name == "cd" and len(command.words) > 1:
                    here = joined(here, str(command.words[1]))
                if command.name == "colcon" and "build" in command.words and "--install-base" not in command.words:
                    yield here, command.words[0]


def _sourced(runner: Runner, folder: str) -> Located | None:
    """Where a command of the service reads the set-up file of a workspace, without a condition."""
    for command in runner.commands:
        if command.name in ("source", ".") and len(command.words) > 1 and not command.depth:
            if command.words[1].startswith(f"{folder}/install/"):
                return command.words[1]
    return None


def _over(files: Files, service: Service, folder: str) -> Volume | None:
    """The bind mount of a folder of the tree over a workspace, or over what is installed in it."""
    if any(str(each.target or "").startswith(f"{folder}/install") for each in service.volumes):
        return None
    for volume in service.volumes:
        target, source = str(volume.target or "").rstrip("/"), str(volume.source or "")
        covers = target in (folder, f"{folder}/install") or (target and folder.startswith(f"{target}/"))
        if not covers or not source.startswith("."):
            continue
        below = folder[len(target) :].lstrip("/") if folder.startswith(target) else "."
        beside = os.path.dirname(service.source.absolute)
        host = os.path.normpath(os.path.join(beside, source, below))
        if files.tree.exists(host) and not files.tree.exists(os.path.join(host, "install")):
            return volume
    return None
