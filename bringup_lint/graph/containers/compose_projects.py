"""Compose projects: files that docker compose loads together because one names the other."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
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


def project_of(compose: Compose, file: ComposeFile) -> list[ComposeFile] | None:
    """The file, those that ``include`` it or extend its services, and all that these include. None when an included
    file is not known, which may define anything.

    docker compose looks for what an included file names in the merged project: compose-go loads the file with
    ``SkipConsistencyCheck``."""
    loaders = _reached([file], lambda one: (other for other in compose.files if one in _loaded(compose, other)))
    project: list[ComposeFile] = []
    for each in _reached(loaders, lambda one: _found(compose, one)):
        if None in _included(compose, each):
            return None
        project.append(each)
    return project


def _reached(start: list[ComposeFile], following: Callable[[ComposeFile], Iterable[ComposeFile]]) -> list[ComposeFile]:
    reached = list(start)
    for one in reached:
        reached += [other for other in dict.fromkeys(following(one)) if other not in reached]
    return reached


def _loaded(compose: Compose, file: ComposeFile) -> list[ComposeFile | None]:
    extended = [_at(compose, file, path) for path in _extended_paths(file)]
    return [*_included(compose, file), *extended]


def _found(compose: Compose, file: ComposeFile) -> Iterator[ComposeFile]:
    return (other for other in _included(compose, file) if other is not None)


def _included(compose: Compose, file: ComposeFile) -> list[ComposeFile | None]:
    return [_at(compose, file, path) for path in _included_paths(file)]


def _at(compose: Compose, file: ComposeFile, path: Located) -> ComposeFile | None:
    source = None if is_variable(path) else compose.tree.beside(file.source, path)
    if source is None or source.template:
        return None
    return next((other for other in compose.files if other.source is source and other.yaml.complete), None)


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
