"""Development containers: the files and the service that a devcontainer.json names (containers.dev, "JSON schema")."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.jsonc import strings
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import ComposeFile
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage

_DOCKERFILE = (("dockerFile",), ("build", "dockerfile"))
_CONTEXT = (("context",), ("build", "context"))


class Broken(NamedTuple):
    what: str
    """``Dockerfile``, ``build context``, ``compose file`` or ``service``."""
    name: Located
    files: tuple[Source, ...] = ()
    """For a service, the compose files that do not define it."""


_IN_WORKSPACE = regex(r"(?:\.\./)?src/[\w.-]+/(?P<rest>[^/].*)", hints="src/")


@dataclass(frozen=True)
class Container:
    source: Source
    values: dict[tuple[str, ...], list[Located]]

    def first(self, *paths: tuple[str, ...]) -> Located | None:
        return next((value for path in paths for value in self.values.get(path, ())), None)

    def beside(self, path: str) -> str:
        return os.path.normpath(os.path.join(os.path.dirname(self.source.absolute), path))

    def service(self, compose: Compose) -> Service | None:
        """The service in which the container is, where only one of its compose files defines it."""
        name = self.first(("service",))
        files = [_compose_file(compose, self.beside(each)) for each in self.values.get(("dockerComposeFile",), ())]
        found = [each for file in files if file is not None for each in file.services if str(each.name) == name]
        return found[0] if len(found) == 1 and None not in files else None

    def stage(self, compose: Compose) -> Stage | None:
        """The stage of the Dockerfile from which the container is built."""
        path = self.first(*_DOCKERFILE)
        target = self.first(("build", "target"))
        where = None if path is None else self.beside(path)
        file = next((each for each in compose.images.dockerfiles if each.source.absolute == where), None)
        if file is None:
            return None
        return file.final if target is None else file.stage(target)


def containers(files: Files) -> Iterator[Container]:
    """The development containers of the tree."""
    for source in files.of_kind("devcontainer"):
        if source.judged and not source.template:
            values: dict[tuple[str, ...], list[Located]] = {}
            for path, value in strings(source):
                values.setdefault(path, []).append(value)
            yield Container(source, values)


def broken_references(files: Files, compose: Compose) -> Iterator[Broken]:
    """What the development containers of the tree name and what is certainly not there."""
    for container in containers(files):
        yield from _missing(files, container)
        yield from _undefined(compose, container)


def _missing(files: Files, container: Container) -> Iterator[Broken]:
    named = (
        *(("Dockerfile", value) for value in [container.first(*_DOCKERFILE)]),
        *(("build context", value) for value in [container.first(*_CONTEXT)]),
        *(("compose file", value) for value in container.values.get(("dockerComposeFile",), ())),
    )
    for what, value in named:
        if value is None or not value or re.search(r"[$\\]|^[/~]", value):
            continue
        path = container.beside(value)
        if (
            not files.tree.exists(path)
            and not files.tree.is_ignored(path)
            and not _fits_workspace(files, container, value)
        ):
            yield Broken(what, value)


def _fits_workspace(files: Files, container: Container, value: str) -> bool:
    """Whether a path leads to a file of this repository once `.devcontainer` is copied to the root of a workspace,
    where the repository lies in ``src``."""
    inside = _IN_WORKSPACE.match(value)
    return inside is not None and files.tree.exists(container.beside(f"../{inside['rest']}"))


def _undefined(compose: Compose, container: Container) -> Iterator[Broken]:
    service = container.first(("service",))
    names = container.values.get(("dockerComposeFile",), [])
    if service is None or not names:
        return
    files = [_compose_file(compose, container.beside(name)) for name in names]
    known = [file for file in files if file is not None]
    if len(known) < len(files) or not all(_is_whole(file) for file in known):
        return
    if not any(str(service) == str(each.name) for file in known for each in file.services):
        yield Broken("service", service, tuple(file.source for file in known))


def _compose_file(compose: Compose, path: str) -> ComposeFile | None:
    return next((file for file in compose.files if file.source.absolute == path), None)


def _is_whole(file: ComposeFile) -> bool:
    """Whether the file was read completely and takes no services from others."""
    root = file.yaml.root
    return file.yaml.complete and not file.source.template and isinstance(root, Mapping) and root.get("include") is None
