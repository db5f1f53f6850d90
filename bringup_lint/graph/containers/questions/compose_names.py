"""What compose files name that has to exist: files beside them, volumes, networks and services."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.questions.compose_projects import Projects
from bringup_lint.graph.memo import kept
from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import Service
from bringup_lint.model.compose import is_variable
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files

_DEFAULT = regex(r"(?:docker-)?compose\.ya?ml")
"""The names that ``docker compose`` reads by itself; other files may only be parts of a project."""
_NAMED_VOLUME = regex(r"[A-Za-z0-9][\w.-]+")
_EXTENSION = regex(r"\.(?:xml|ya?ml|json|toml|conf|cfg|ini|sh|bash|py|properties|launch|rules|urdf|xacro|rviz)$")
"""Of files that a program of the container reads."""

_TEMPORARY = regex(r"/tmp/(?:[\w.-]+/)*[\w.-]*(?:\.xauth|\.Xauthority|\.(?:xml|ya?ml|json|conf|cfg|ini))")
"""A file that is gone after each boot."""
_GIVEN = regex(
    r"\./(?:[\w.-]+/)*(?:configs?|conf|params?|launch|scripts?|src|urdf|description|rviz|behavior_trees|maps)/?"
)
"""A folder of files that a container is to read, not of those that it writes."""
_RECIPES = regex(r"(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile|Taskfile\.ya?ml)$")
"""Files of commands that are no scripts of a shell."""
_RECIPES_READ = 200_000
_DOCKERFILES = ("Dockerfile", "dockerfile", "Containerfile")
_WORD = regex(r"([^\s\"'`(){}=:,;]+)( ?)")
_KEYSTORE = regex(r"(?:^|/)[\w.-]*keystore")
"""Is made by hand on each robot."""


class MissingFile(NamedTuple):
    what: str
    """``build context``, ``Dockerfile``, ``default Dockerfile``, ``env_file``, ``mount``, ``mounted program`` (that the
    container starts) or ``mounted folder``."""
    service: Service
    path: Located
    fatal: bool
    """docker compose ends; for a mount, docker makes a folder of that name."""


class UndefinedName(NamedTuple):
    kind: str
    """``volume``, ``network`` or ``service``."""
    service: Service
    name: Located


def missing_files(files: Files, compose: Compose) -> Iterator[MissingFile]:
    """The files that the services name beside their compose file, and that the tree certainly lacks."""
    for file in _complete(compose):
        for service in file.services:
            if not service.is_whole and not _DEFAULT.fullmatch(file.source.basename):
                continue
            for found in (*_built(files, service), *_read(service)):
                if _is_own(service, found.path) and _is_missing(files, service, found):
                    yield found


def _complete(compose: Compose) -> Iterator[ComposeFile]:
    for file in compose.files:
        if file.source.judged and not file.source.template and file.yaml.complete:
            yield file


def _projects(compose: Compose) -> Iterator[ComposeFile]:
    return (file for file in _complete(compose) if _DEFAULT.fullmatch(file.source.basename))


def _is_own(service: Service, where: Located) -> bool:
    return where.span.start >= service.body.span.start


def _built(files: Files, service: Service) -> Iterator[MissingFile]:
    build = service.build
    if build is None or service.inline_dockerfile:
        return
    fatal = service.image is None
    if build.context is not None and not _is_folder(files, service, build.context):
        yield MissingFile("build context", service, build.context, fatal)
    elif build.dockerfile is not None and not is_variable(build.dockerfile) and not is_variable(build.context or ""):
        path = build.dockerfile
        if not files.tree.exists(_beside(service, build.context or ".", path)):
            yield MissingFile("Dockerfile", service, path, fatal)
    elif build.dockerfile is None and build.context is not None and _lacks_dockerfile(files, service, build.context):
        yield MissingFile("default Dockerfile", service, build.context, fatal)


def _read(service: Service) -> Iterator[MissingFile]:
    node = service.body.get("env_file")
    items = list(node.items) if isinstance(node, Sequence) else [node]
    for item in items:
        if isinstance(item, Scalar) and not item.is_null:
            yield MissingFile("env_file", service, item.value, True)
    for volume in service.volumes:
        is_path = volume.source is not None and volume.source.startswith("./") and _EXTENSION.search(volume.source)
        if volume.source is not None and is_path and _EXTENSION.search(volume.target or ""):
            starts = volume.target in _started(service)
            yield MissingFile("mounted program" if starts else "mount", service, volume.source, starts)
        elif volume.source is not None and _TEMPORARY.fullmatch(volume.source):
            yield MissingFile("mount", service, volume.source, False)
        elif volume.source is not None and _is_read(volume.source, read_only=volume.read_only):
            yield MissingFile("mounted folder", service, volume.source, False)


def _started(service: Service) -> tuple[Located, ...]:
    """The program of a service, and the script that a shell as its program reads."""
    words = service.entrypoint or service.command
    return words[: 2 if words and words[0].rpartition("/")[2] in ("sh", "bash") else 1]


def _is_read(source: str, *, read_only: bool) -> bool:
    """Whether a folder is mounted for what it holds."""
    return bool(_GIVEN.fullmatch(source)) or (read_only and source.startswith("./") and not _EXTENSION.search(source))


def _lacks_dockerfile(files: Files, service: Service, context: Located) -> bool:
    """Whether a context of the tree certainly holds no Dockerfile."""
    folder = _beside(service, context)
    if re.search(r"://|^git@|^[/~]|^[\w-]+:", context) or is_variable(context) or not files.tree.holds(f"{folder}/x"):
        return False
    if any(folder.startswith(each) for each in files.tree.submodules):
        return False
    return not any(files.tree.exists(os.path.join(folder, name)) for name in _DOCKERFILES)


def _is_folder(files: Files, service: Service, context: Located) -> bool:
    remote = re.search(r"://|^git@|^[/~]|\.git(?:#|$)|^[\w-]+:", context)
    return bool(remote) or is_variable(context) or files.tree.exists(_beside(service, context))


def _beside(service: Service, *parts: str) -> str:
    return os.path.normpath(os.path.join(os.path.dirname(service.source.absolute), *parts))


def _is_missing(files: Files, service: Service, found: MissingFile) -> bool:
    if _TEMPORARY.fullmatch(found.path):
        return not _is_named(files, os.path.basename(found.path))
    if found.what == "default Dockerfile":
        return not any("Dockerfile" in source.text for source in files.sources if source.kind == "shell-script")
    if is_variable(found.path) or found.path.startswith(("/", "~")) or _KEYSTORE.search(found.path):
        return False
    context = service.build.context if found.what == "Dockerfile" and service.build else None
    relative = os.path.normpath(os.path.join(context or ".", found.path))
    path = _beside(service, relative)
    if files.tree.exists(path) or files.tree.is_ignored(path):
        return False
    if found.what == "build context" and _is_own_folder(files, path):
        return not _is_moved(files, service)
    if _elsewhere(files, service, relative) and (found.fatal or _is_moved(files, service)):
        return False
    may_be_copied = found.what in ("env_file", "mount") or (found.what == "mounted program" and not _near(files, path))
    is_copied = may_be_copied and any(files.tree.named(os.path.basename(path)))
    return not is_copied and not _is_made(files, path)


def nearly_named(files: Files, missing: MissingFile) -> list[str]:
    """The paths that may be meant in place of one that is missing: of files beside it with nearly its name."""
    if missing.what not in ("env_file", "mount", "mounted program"):
        return []
    folder = os.path.dirname(missing.path)
    return [f"{folder}/{name}" if folder else name for name in _near(files, _beside(missing.service, missing.path))]


def _near(files: Files, path: str) -> list[str]:
    """The files beside a path that it may have been called after: nearly its name, and the same ending."""
    folder, name = os.path.split(path)
    ending = os.path.splitext(name)[1]
    beside = (os.path.basename(each) for each in files.tree.walked_in(folder))
    return nearest(name, [each for each in beside if each.endswith(ending)], 3)


def _is_named(files: Files, name: str) -> bool:
    """Whether a script or a text for people speaks of a file, so that somebody makes it, or opens the display to all
    so that nobody needs it."""
    return any(name in text or "xhost +" in text for text in _texts(files))


def _texts(files: Files) -> Iterator[str]:
    """What scripts, recipes and texts for people say."""
    texts = [path for path in files.tree.paths if path.endswith((".md", ".rst", ".txt", "Makefile", "justfile"))]
    told = (files.tree.read(path, judged=False) for path in texts)
    sources = (source for source in (*files.sources, *told) if source is not None and source.kind != "compose")
    yield from (source.text for source in sources)


def _elsewhere(files: Files, service: Service, relative: str) -> bool:
    """Whether a folder of the tree above has it: ``--project-directory`` may name that one."""
    folder = _beside(service, ".")
    while (above := os.path.dirname(folder)) != folder:
        if files.tree.exists(os.path.join(folder, ".git")):
            return False
        folder = above
        path = os.path.join(folder, relative)
        if not files.tree.holds(path):
            return False
        if files.tree.exists(path):
            return True
    return False


def _is_own_folder(files: Files, context: str) -> bool:
    """Whether a context is called as the folder of its compose file, which holds the Dockerfile itself."""
    folder, name = os.path.split(context)
    return os.path.basename(folder) == name and files.tree.exists(os.path.join(folder, "Dockerfile"))


def _is_moved(files: Files, service: Service) -> bool:
    """Whether something of the tree starts its services from another folder, or together with another file."""
    folder = os.path.basename(os.path.dirname(service.source.absolute))
    return _are_moved(files) or f"{folder}/{service.source.basename}" in _before_others(files)


@kept
def _are_moved(files: Files) -> bool:
    """Whether something of the tree sets the folder or the files of projects."""
    if any("project_directory" in source.text for source in files.of_kind("compose")):
        return True
    return any("project-directory" in text or "COMPOSE_FILE" in text for text in _texts(files))


@kept
def _before_others(files: Files) -> frozenset[str]:
    """The words of the tree behind which others stand, of paths the last folder and the name."""
    words = (word for text in _texts(files) for word, blank in _WORD.findall(text) if blank and "/" in word)
    return frozenset("/".join(word.rsplit("/", 2)[-2:]) for word in words)


def _is_made(files: Files, path: str) -> bool:
    """Whether something of the tree may put it there: a template beside it, a submodule, a script or a
    recipe of make."""
    folder, name = os.path.split(path)
    if any(path.startswith(each) for each in files.tree.submodules):
        return True
    if any(os.path.basename(each).startswith(name) for each in files.tree.walked_in(folder)):
        return True
    recipes = (files.tree.head(each, _RECIPES_READ) for each in files.tree.like(_RECIPES))
    scripts = (source.text for source in files.sources if source.kind in ("shell-script", "ansible"))
    return any(name in text for texts in (scripts, recipes) for text in texts)


def undefined_names(compose: Compose) -> Iterator[UndefinedName]:
    """Volumes, networks and services that a project names and does not define."""
    projects = Projects(compose)
    for file in _projects(compose):
        project = projects.of(file)
        if project is None or projects.has_parts(project):
            continue
        defined = {kind: defined_names(project, kind) for kind in ("volume", "network", "service")}
        for service in file.services:
            for found in _named(service):
                if _is_own(service, found.name) and str(found.name) not in defined[found.kind]:
                    yield found


def _named(service: Service) -> Iterator[UndefinedName]:
    # Of entries with one target, Compose keeps the last, and asks then what it names (compose-go, EnforceUnicity).
    last = {str(volume.target): volume for volume in service.volumes}
    for volume in last.values():
        short = volume.where is not volume.target
        if short and volume.source is not None and _NAMED_VOLUME.fullmatch(volume.source):
            yield UndefinedName("volume", service, volume.source)
    for name in _keys(service, "networks"):
        yield UndefinedName("network", service, name)
    for name in _keys(service, "depends_on"):
        yield UndefinedName("service", service, name)


def _keys(service: Service, key: str) -> Iterator[Located]:
    """The entries of a list, or the keys of a mapping."""
    node = service.body.get(key)
    if isinstance(node, Sequence):
        names = [scalar.value for scalar in node.scalars]
    elif isinstance(node, Mapping):
        names = [entry.value for entry, body in node.merged if not _is_optional(body)]
    else:
        names = []
    yield from (name for name in names if not is_variable(name))


def _is_optional(body: object) -> bool:
    required = body.scalar("required") if isinstance(body, Mapping) else None
    return required is not None and required.boolean is False


def defined_names(project: Iterable[ComposeFile], kind: str) -> set[str]:
    """The volumes, networks or services that the files of a project define."""
    roots = (file.yaml.root for file in project)
    sections = [root.mapping(f"{kind}s") for root in roots if isinstance(root, Mapping)]
    names = {str(key.value) for section in sections if section is not None for key, _ in section.merged}
    return names | {"default"} if kind == "network" else names
