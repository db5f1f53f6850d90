"""Copies of compose files whose paths only hold where the other one is, in a folder above."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from itertools import islice

from bringup_lint.graph.containers.compose import Compose
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.set_aside.texts import Texts
from bringup_lint.graph.set_aside.texts import is_copy
from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import is_variable
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_ALIKE = 50
"""Files in the folders above with which one is compared."""
_CALLS = regex(r"\bdocker(?:-compose|[ \t]+compose)(?![\w.-])", hints="compose")
_ENTERED = (
    r"(?:\b(?:cd|pushd|cp|mv|ln|rsync|scp)[ \t]|[ \t]-C|--(?:project-)?directory\b)[^\n;&|]{0,200}?"
    r"(?<![\w.-])NAME(?![\w.-]|/[\w.-])"
    r"|(?i:dir|cwd|folder|path|src)[\w-]{0,40}[\"']?[ \t]*[:=][ \t]*[\"']?(?:[^\s\"'=]{0,200}/)?NAME/?[\"']?[ \t]*"
    r"(?=[,)}]|$)"
    r"|(?<![\w.-])NAME/(?![\w-]|\.[\w.])"
)
"""What enters a folder or takes it as a whole; NAME is its name."""


class MisplacedCopies:
    """Asked for a compose file, or a Dockerfile: whether the tree keeps it and does not use it."""

    def __init__(self, files: Files, texts: Texts, compose: Callable[[], Compose]) -> None:
        self._files = files
        self._texts = texts
        self._compose = compose

    @memo
    def have(self, source: Source) -> bool:
        """Whether nothing names a compose file, and a folder above has one of the same services beside which there is
        what this one mounts and does not have beside itself."""
        own = self._files_of.get(source)
        if own is None or not any(self._is_misplaced(own, each) for each in islice(self._above(source), _ALIKE)):
            return False
        return not self._is_named(source)

    @memo
    def build(self, source: Source) -> bool:
        """Whether only such copies build a Dockerfile."""
        places = self._builders.get(source)
        return places is not None and all(each.kind == "compose" and self.have(each) for each in places)

    @cached_property
    def _files_of(self) -> dict[Source, ComposeFile]:
        return {each.source: each for each in self._compose().files}

    @cached_property
    def _builders(self) -> dict[Source, set[Source]]:
        """Dockerfile -> the files that build images of it."""
        compose = self._compose()
        known = {stage: file.source for file in compose.images.dockerfiles for stage in file.stages}
        found: dict[Source, set[Source]] = {}
        for stage, source in known.items():
            for service in compose.users(stage):
                found.setdefault(source, set()).add(service.source)
        for built in chain.from_iterable(compose.images.built.values()):
            if built.stage in known:
                found.setdefault(known[built.stage], set()).add(built.where.span.source)
        return found

    def _is_named(self, source: Source) -> bool:
        """Whether a text names the file or enters its folder, or one beside it calls docker compose."""
        path = self._texts.path_of(source.absolute)
        folder, place = os.path.dirname(path), "/".join(path.split("/")[-2:])
        beside = (each for each in self._texts.by_folder.get(folder, ()) if each.path != path)
        if any(_CALLS.search(each.text) for each in beside):
            return True
        if any(place in each.text for each in self._texts.saying(source.basename, source)):
            return True
        name = os.path.basename(folder)
        entered = re.compile(_ENTERED.replace("NAME", re.escape(name)), re.M)
        return any(entered.search(each.text) for each in self._texts.saying(name, source))

    def _above(self, source: Source) -> Iterator[ComposeFile]:
        """The compose files in the folders above that of one."""
        folder = os.path.dirname(source.name)
        while folder.strip("/"):
            folder = os.path.dirname(folder)
            yield from self._compose().by_folder.get(folder, ())

    def _is_misplaced(self, own: ComposeFile, other: ComposeFile) -> bool:
        names, others = ({str(service.name) for service in each.services} for each in (own, other))
        if names != others or not is_copy(own.source.text, other.source.text):
            return False
        paths = [path for path in _mounted(own) if not self._is_beside(own, path)]
        return bool(paths) and all(self._is_beside(other, path) for path in paths)

    def _is_beside(self, file: ComposeFile, path: str) -> bool:
        return self._files.tree.exists(os.path.normpath(os.path.join(os.path.dirname(file.source.absolute), path)))


def _mounted(file: ComposeFile) -> Iterator[str]:
    """The paths beside a compose file that its services mount."""
    volumes = (volume for service in file.services for volume in service.volumes)
    paths = (str(volume.source) for volume in volumes if volume.source is not None)
    return (path for path in paths if path.startswith(("./", "../")) and not is_variable(path))
