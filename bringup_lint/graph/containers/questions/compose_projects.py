"""Compose projects: files that docker compose loads together because one names the other."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import is_variable
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.source import Located


class Projects:
    """The projects of a tree, and which files load which."""

    def __init__(self, compose: Compose) -> None:
        self._compose = compose

    def of(self, file: ComposeFile) -> list[ComposeFile] | None:
        """The file, those that ``include`` it or extend its services, and all that these include. None when an
        included file is not known, which may define anything.

        docker compose looks for what an included file names in the merged project: compose-go loads the file with
        ``SkipConsistencyCheck``."""
        loaders = _reached([file], lambda one: self._loaders.get(id(one), ()))
        project: list[ComposeFile] = []
        for each in _reached(loaders, self._found):
            if None in self._included[id(each)]:
                return None
            project.append(each)
        return project

    def has_parts(self, project: list[ComposeFile]) -> bool:
        """Whether other compose files are beside those of a project, which may define the rest."""
        own = set(map(id, project))
        folders = {os.path.dirname(file.source.name) for file in project}
        return any(id(other) not in own for folder in folders for other in self._compose.by_folder[folder])

    def _found(self, file: ComposeFile) -> Iterator[ComposeFile]:
        return (other for other in self._included[id(file)] if other is not None)

    @cached_property
    def _included(self) -> dict[int, list[ComposeFile | None]]:
        """``id`` of a file -> those that it includes, None for one that is not known."""
        return {id(file): [self._at(file, path) for path in _included_paths(file)] for file in self._compose.files}

    @cached_property
    def _loaders(self) -> dict[int, list[ComposeFile]]:
        """``id`` of a file -> those that include it or extend its services."""
        found: dict[int, list[ComposeFile]] = {}
        for file in self._compose.files:
            extended = (self._at(file, path) for path in _extended_paths(file))
            for other in {id(other) for other in (*self._included[id(file)], *extended) if other is not None}:
                found.setdefault(other, []).append(file)
        return found

    @cached_property
    def _whole(self) -> dict[int, ComposeFile]:
        """``id`` of a source -> its file, where all of it can be read."""
        return {id(file.source): file for file in self._compose.files if file.yaml.complete}

    def _at(self, file: ComposeFile, path: Located) -> ComposeFile | None:
        source = None if is_variable(path) else self._compose.tree.beside(file.source, path)
        return None if source is None or source.template else self._whole.get(id(source))


def _reached(start: list[ComposeFile], following: Callable[[ComposeFile], Iterable[ComposeFile]]) -> list[ComposeFile]:
    reached = {id(one): one for one in start}
    waiting = list(start)
    for one in waiting:
        new = {id(other): other for other in following(one) if id(other) not in reached}
        waiting += new.values()
        reached |= new
    return list(reached.values())


def _included_paths(file: ComposeFile) -> Iterator[Located]:
    root = file.yaml.root
    node = root.get("include") if isinstance(root, Mapping) else None
    if not isinstance(node, Sequence):
        return
    for item in node.items:
        yield from _paths(item.get("path") if isinstance(item, Mapping) else item)


def _paths(node: Node | None) -> Iterator[Located]:
    if isinstance(node, Scalar):
        yield node.value
    elif isinstance(node, Sequence):
        yield from (scalar.value for scalar in node.scalars)


def _extended_paths(file: ComposeFile) -> Iterator[Located]:
    for service in file.services:
        node = service.body.get("extends")
        path = node.scalar("file") if isinstance(node, Mapping) else None
        if path is not None:
            yield path.value
