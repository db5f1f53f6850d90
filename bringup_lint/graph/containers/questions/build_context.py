"""Build contexts: what COPY and ADD of a Dockerfile take from them (docs.docker.com/build/concepts/context)."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.compose import is_variable
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Instruction
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service

_ELSEWHERE = regex(r"[$<\\]|://|^git@|\*\*|\[")
_MAKERS = regex(r"(?:^|/)(?:[Mm]akefile|[Jj]ustfile|\.gitignore|[^/]+\.(?:sh|bash|py|mk|md|rst|ya?ml|bat|ps1|repos))$")
_MOST_MAKERS = 500
_OF_WORKSPACE = ("src", "install", "build")
"""Folders of a workspace, which packages do not have at their top but for ``src``."""
_PRUNED = regex(r"(?:^|/)(?:vendor|node_modules)/")
"""Folders that a package manager fills with a part of what their packages have."""


class Lacking(NamedTuple):
    source: Located
    """The file or folder as the instruction writes it."""
    service: Service | None
    """Whose build context lacks it; None where no folder that may be the context has it."""
    ignoring: Source | None = None
    """The file that keeps it out of the context, where the tree has it."""


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
            if lacking is None or (lacking.ignoring is None and _is_of_workspace(files, file, lacking)):
                continue
            if lacking.ignoring is not None or not makers.name(word):
                yield lacking


def _is_of_workspace(files: Files, file: Dockerfile, lacking: Lacking) -> bool:
    """Whether the context may be a workspace around the repository: no service says it, the Dockerfile is in a package,
    and the path is a folder of workspaces."""
    if lacking.service is not None or lacking.source.startswith("../"):
        return False
    first = _at("", lacking.source).partition("/")[0]
    above = _folders(files, _folder(file.source.name))
    return first in _OF_WORKSPACE and any(files.tree.is_file(os.path.join(each, "package.xml")) for each in above)


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
        path = os.path.normpath(os.path.join(context, build.dockerfile or "Dockerfile"))
        found.setdefault(path, []).append((service, context))
    return found


def _judged(files: Files, file: Dockerfile, word: Located, builders: list[tuple[Service, str]]) -> Lacking | None:
    """The first context that lacks the path; without a known one, all folders above the Dockerfile have to."""
    for service, context in builders:
        if not _is_in(files, context, word):
            return None if files.tree.is_ignored(_at(context, word)) else Lacking(word, service)
        if (ignoring := _ignoring(files, file, context, word)) is not None:
            return Lacking(word, service, ignoring)
    if builders:
        return None
    above = list(_folders(files, _folder(file.source.name)))
    having = [folder for folder in above if _is_in(files, folder, word)]
    if having and (found := [_ignoring(files, file, folder, word) for folder in having]) and all(found):
        return Lacking(word, None, found[0])
    if any(_is_in(files, folder, word) or files.tree.is_ignored(_at(folder, word)) for folder in above):
        return None
    return Lacking(word, None)


def _ignoring(files: Files, file: Dockerfile, context: str, word: str) -> Source | None:
    """The file that keeps a path out of a context; None, too, where it has exceptions (``!``)."""
    own = f"{file.source.absolute}.dockerignore"
    path = next((each for each in (own, os.path.join(context, ".dockerignore")) if files.tree.is_file(each)), None)
    source = files.tree.read(path, judged=False) if path is not None else None
    if source is None or re.search(r"^[ \t]*!", source.text, re.M) or re.search(r"[*?]", word):
        return None
    parts = _at("", word).split("/")
    above = ["/".join(parts[:count]) for count in range(1, len(parts) + 1)]
    lines = (line.strip() for line in source.text.splitlines() if not line.startswith("#"))
    patterns = [posixpath.normpath(line.lstrip("/")) for line in lines if line.strip("/")]
    return source if any(_matches(pattern, each) for pattern in patterns for each in above) else None


def _matches(pattern: str, path: str) -> bool:
    """Whether a pattern means a path: a star stays in its folder, ``**/`` means any number of folders."""
    if pattern.startswith("**/"):
        return _matches(pattern[3:], path) or _matches(pattern[3:], posixpath.basename(path))
    if "**" in pattern or pattern.count("/") != path.count("/"):
        return False
    return all(map(fnmatchcase, path.split("/"), pattern.split("/")))


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
        if word.startswith("../"):
            copied = re.compile(rf"\b(?:cp|mv|ln|rsync|tar|copy(?:tree)?)\b[^\n]{{0,200}}\b{re.escape(name)}\b")
            return any(name in text and copied.search(text) for text in self._texts)
        return any(name in text for text in self._texts)
