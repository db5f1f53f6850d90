"""Build contexts: what COPY and ADD of a Dockerfile take from them (docs.docker.com/build/concepts/context)."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.compose import is_variable
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service

_ELSEWHERE = regex(r"[$<]|://|^git@|\*\*|\[")
_MAKERS = regex(r"(?:^|/)(?:[Mm]akefile|[Jj]ustfile|\.gitignore|[^/]+\.(?:sh|bash|py|mk|md|rst|ya?ml|bat|ps1|repos))$")
_MOST_MAKERS = 500
_PRUNED = regex(r"(?:^|/)(?:vendor|node_modules)/")
"""Folders that a package manager fills with a part of what their packages have."""


class Lacking(NamedTuple):
    source: Located
    """The file or folder as the instruction writes it."""
    service: Service | None
    """Whose build context lacks it; None where no folder that may be the context has it."""


def lacking_sources(files: Files, compose: Compose) -> Iterator[Lacking]:
    """The files and folders that COPY and ADD name and that are certainly not in the build context."""
    known = _builders(compose)
    makers = _Makers(files)
    for file in compose.images.dockerfiles:
        if not file.source.judged or _PRUNED.search(file.source.name):
            continue
        builders = known.get(file.source.absolute, [])
        for word in _sources(file):
            lacking = _judged(files, file, word, builders)
            if lacking is not None and not makers.name(word):
                yield lacking


def _sources(file: Dockerfile) -> Iterator[Located]:
    """The paths in the build context that the file names."""
    for stage in file.stages:
        for instruction in stage.all("COPY", "ADD"):
            if not any(flag.startswith(("--from", "--parents")) for flag in instruction.flags):
                yield from _paths(instruction)


def _paths(instruction: Instruction) -> Iterator[Located]:
    words = list(instruction.value.words()) if instruction.exec_form is None else []
    for word in words[:-1]:
        if word and not word.startswith("<<") and not _ELSEWHERE.search(word):
            yield word


def _builders(compose: Compose) -> dict[str, list[tuple[Service, str]]]:
    """Path of a Dockerfile -> the compose services that build it, with the folders of their contexts."""
    found: dict[str, list[tuple[Service, str]]] = {}
    for service in compose.services:
        build = service.build
        if build is None or service.inline_dockerfile or is_variable(build.context or ""):
            continue
        context = os.path.normpath(os.path.join(_folder(service.source.name), build.context or "."))
        path = os.path.join(context, build.dockerfile or "Dockerfile")
        found.setdefault(path, []).append((service, context))
    return found


def _judged(files: Files, file: Dockerfile, word: Located, builders: list[tuple[Service, str]]) -> Lacking | None:
    """The first context that lacks the path; without a known one, all folders above the Dockerfile have to."""
    for service, context in builders:
        if not _is_in(files, context, word):
            return None if files.tree.is_ignored(_at(context, word)) else Lacking(word, service)
    if builders:
        return None
    above = list(_folders(files, _folder(file.source.name)))
    if any(_is_in(files, folder, word) or files.tree.is_ignored(_at(folder, word)) for folder in above):
        return None
    return Lacking(word, None)


def _folder(name: str) -> str:
    return os.path.dirname(os.path.abspath(name))


def _folders(files: Files, folder: str) -> Iterator[str]:
    """The folder and those above it, up to the top of the repository or of the tree."""
    while True:
        yield folder
        above = os.path.dirname(folder)
        if above == folder or files.tree.exists(os.path.join(folder, ".git")):
            return
        if not files.tree.holds(os.path.join(above, "Dockerfile")):
            return
        folder = above


def _at(folder: str, word: str) -> str:
    """The path in a context: what leads out of it stops at its top."""
    return os.path.join(folder, re.sub(r"^(?:\.{0,2}/+)+", "", word)).rstrip("/")


def _is_in(files: Files, folder: str, word: str) -> bool:
    path = _at(folder, word)
    return files.tree.matches(path) if re.search(r"[*?]", word) else files.tree.exists(path)


class _Makers:
    """What of the tree may put a file there: submodules, and scripts and build files that name it."""

    def __init__(self, files: Files) -> None:
        self._tree = files.tree

    @cached_property
    def _texts(self) -> list[str]:
        makers = [path for path in self._tree.paths if _MAKERS.search(path)][:_MOST_MAKERS]
        read = (self._tree.read(path, judged=False) for path in makers)
        return [source.text for source in read if source is not None]

    def name(self, word: str) -> bool:
        """Whether one of them may put something at a path of a build context."""
        path = f"/{_at('', word)}"
        for each in self._tree.submodules:
            if f"{path}/" in f"{each}/" or os.path.basename(each) in path.split("/"):
                return True
        name = os.path.basename(path).partition("*")[0]
        return any(name in text for text in self._texts)
