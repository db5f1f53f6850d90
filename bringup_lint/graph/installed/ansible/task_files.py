"""The files of the tree that tasks copy, fill in and include, and the folders in which Ansible looks for them."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.installed.script_files import GENERATED
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible_tasks import Task
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_ROLE = regex(r"(?P<role>.*/roles/[^/]+)/")
_FOLDERS = {
    "copy": ("files", "."),
    "template": ("templates", "."),
    "include_tasks": (".", "tasks"),
    "import_tasks": (".", "tasks"),
    "script": ("files", "."),
}
"""Where Ansible looks, below the role and beside the file."""
_ELSEWHERE = regex(r"[/~]|http|\s*$")
"""How a path begins that is not one of the tree."""
_ASKS = regex(r"\bexists\b|\bis (?:not )?(?:file|link)\b")
"""A condition that a file is there."""


class _Named(NamedTuple):
    path: Located
    folders: tuple[str, ...]
    """Where Ansible looks for it, below the role and beside the file."""
    dest: Located | None


@dataclass(eq=False)
class TaskFiles:
    files: Files

    def missing(self, source: Source) -> Iterator[Located]:
        for named in _named(source):
            if self._is_missing(source, named.path, named.folders) and not self._is_made(named.path):
                yield named.path

    def _is_made(self, path: str) -> bool:
        """Whether something else than the tasks that read a file names it: it may put it there before."""
        name = os.path.basename(path.rstrip("/"))
        written = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-])")
        return sum(len(written.findall(text)) for text in self._texts if name in text) > self._read[name]

    @cached_property
    def _texts(self) -> list[str]:
        return [source.text for source in self.files.of_kind("ansible", "shell-script")]

    @cached_property
    def _read(self) -> Counter[str]:
        """How often the tasks that read a file of a name say the name: in ``dest``, too."""
        named = [each for source in self.files.of_kind("ansible") for each in _named(source)]
        words = [word for each in named for word in (each.path, each.dest) if word is not None]
        return Counter(os.path.basename(word.rstrip("/")) for word in words)

    def _is_missing(self, source: Source, path: str, folders: tuple[str, ...]) -> bool:
        if "{{" in path or "*" in path or _ELSEWHERE.match(path) or GENERATED.search(path):
            return False
        here = os.path.dirname(source.absolute)
        role = _ROLE.match(source.absolute)
        if role is None and not self._is_project and not self._has_folder(here, folders, path):
            return False
        tree = self.files.tree
        above = os.path.dirname(here)  # of the role, or of the play that takes the tasks in
        is_inside = tree.holds(os.path.join(above, os.path.basename(here)))
        tops = [here, *([above] if is_inside else []), *([role["role"]] if role is not None else [])]
        if any(tree.exists(each) or tree.is_ignored(each) for each in _paths(tops, folders, path)):
            return False
        outer = _paths([f"{top}/../.." for top in tops], folders, path)
        return not any(tree.holds(each) and tree.exists(each) for each in outer)

    def _has_folder(self, here: str, folders: tuple[str, ...], path: str) -> bool:
        """Whether one of the folders in which a play looks for a file is there: ``templates``, and the file's own."""
        inner = {os.path.dirname(each) for each in _paths([here], folders, path)} - {here}
        return any(self.files.tree.exists(each) for each in inner)

    @cached_property
    def _is_project(self) -> bool:
        """Whether the tree has folders of Ansible, so that plays find their files in the usual places."""
        paths = (f"/{path}" for path in self.files.tree.paths)
        return any("/roles/" in path or "/tasks/" in path for path in paths)


def _paths(tops: list[str], folders: tuple[str, ...], path: str) -> list[str]:
    return [os.path.normpath(os.path.join(top, folder, path)) for top in tops for folder in folders]


def _named(source: Source) -> Iterator[_Named]:
    """The files that tasks read."""
    for task in tasks(source):
        if not _may_fail(task):
            yield from _of_task(task)


def _may_fail(task: Task) -> bool:
    """Whether the play goes on without the file, or the task runs only where something asked for it."""
    condition = task.keys.scalar("when")
    asked = condition is not None and _ASKS.search(condition.value) is not None
    return asked or task.may_fail or task.keys.get("loop") is not None


def _of_task(task: Task) -> Iterator[_Named]:
    for module in task.modules:
        folders = _FOLDERS.get(module.name)
        word = _file(module.settings)
        if folders is not None and word is not None:
            dest = module.settings.scalar("dest") if isinstance(module.settings, Mapping) else None
            yield _Named(word, folders, dest.value if dest is not None else None)


def _file(settings: Node) -> Located | None:
    """The file of the tree that a module reads."""
    if isinstance(settings, Scalar):
        return settings.value if re.fullmatch(r"[\w./-]+\.ya?ml", settings.value) else None
    if not isinstance(settings, Mapping) or settings.get("remote_src") is not None:
        return None
    word = settings.scalar("src") or settings.scalar("file")
    return word.value if word is not None else None
