"""Files that a service mounts at one path of its container, and opens at another."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.runners.questions.missing_programs import lacks
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.compose import Service

_MAKES = regex(r"(?:>|\b(?:cp|mv|tee|ln|install|curl|wget)\b)[^\n;&|]*\Z")
"""What is before a path of a file that the command makes."""


class MisplacedMount(NamedTuple):
    named: Located
    """The path that the command or a variable names."""
    target: Located
    """Where the file is mounted."""
    service: Service


def misplaced_mounts(files: Files, containers: Iterable[Runner]) -> Iterator[MisplacedMount]:
    """The paths with the name of a file that the service mounts in another folder, and that nothing else of it names,
    where nothing else brings such a file: the name is one that the mount gives, or the image surely lacks it."""
    for runner in containers:
        service = runner.service
        if service is None or not runner.source.judged or service.base is not None:
            continue
        texts = [*service.command, *service.entrypoint]
        texts += [each.value for each in service.environment.values() if each.value is not None]
        for source, target in _mounted_files(files, service):
            folder = posixpath.dirname(target)
            if any(target in text or (folder != "/" and f"{folder}/" in f"{text}/") for text in texts):
                continue
            is_named_so = posixpath.basename(target) != posixpath.basename(source)
            for path in _named(posixpath.basename(target), texts):
                if not _is_mounted(service, path) and (is_named_so or lacks(files, runner, str(path))):
                    yield MisplacedMount(path, target, service)
                    break


def _mounted_files(files: Files, service: Service) -> Iterator[tuple[Located, Located]]:
    for volume in service.volumes:
        source, target = volume.source, volume.target
        if source is None or target is None or "$" in source or "$" in target or "." not in posixpath.basename(target):
            continue
        if source.startswith(".") and files.tree.beside(service.source, source) is not None:
            yield source, target


def _named(name: str, texts: Iterable[Located]) -> Iterator[Located]:
    pattern = re.compile(rf"(?<![\w./$}}-])(?:/[\w.-]+)+/{re.escape(name)}(?![\w.-])")
    for text in texts:
        for found in pattern.finditer(text):
            if not _MAKES.search(text, 0, found.start()):
                yield text.part(*found.span())


def _is_mounted(service: Service, path: str) -> bool:
    targets = (str(volume.target or volume.where).rstrip("/") for volume in service.volumes)
    return any("$" in target or path == target or path.startswith(f"{target}/") for target in targets)
