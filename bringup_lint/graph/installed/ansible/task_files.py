"""The files of the tree that tasks copy, fill in and include, and the folders in which Ansible looks for them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
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


@dataclass(eq=False)
class TaskFiles:
    files: Files

    def missing(self, source: Source) -> Iterator[Located]:
        for word, folders in _named(source):
            if self._is_missing(source, word, folders):
                yield word

    def _is_missing(self, source: Source, path: str, folders: tuple[str, ...]) -> bool:
        if "{{" in path or "*" in path or _ELSEWHERE.match(path):
            return False
        here = os.path.dirname(os.path.abspath(source.name))
        role = _ROLE.match(os.path.abspath(source.name))
        if role is None and not self._is_project:
            return False
        tops = [here, os.path.dirname(here), *([role["role"]] if role is not None else [])]
        tree = self.files.tree
        if any(tree.exists(each) or tree.is_ignored(each) for each in _paths(tops, folders, path)):
            return False
        outer = _paths([f"{top}/../.." for top in tops], folders, path)
        return not any(tree.holds(each) and tree.exists(each) for each in outer)

    @cached_property
    def _is_project(self) -> bool:
        """Whether the tree has folders of Ansible, so that plays find their files in the usual places."""
        paths = (f"/{path}" for path in self.files.tree.paths)
        return any("/roles/" in path or "/tasks/" in path for path in paths)


def _paths(tops: list[str], folders: tuple[str, ...], path: str) -> list[str]:
    return [os.path.normpath(os.path.join(top, folder, path)) for top in tops for folder in folders]


def _named(source: Source) -> Iterator[tuple[Located, tuple[str, ...]]]:
    """The files that tasks read, with the folders in which Ansible looks for them."""
    for task in tasks(source):
        if not _may_fail(task):
            yield from _of_task(task)


def _may_fail(task: Task) -> bool:
    return any(task.keys.get(key) is not None for key in ("loop", "ignore_errors"))


def _of_task(task: Task) -> Iterator[tuple[Located, tuple[str, ...]]]:
    for module, settings in task.modules:
        folders = _FOLDERS.get(module.rpartition(".")[2])
        word = _file(settings)
        if folders is not None and word is not None:
            yield word, folders


def _file(settings: Node) -> Located | None:
    """The file of the tree that a module reads."""
    if isinstance(settings, Scalar):
        return settings.value if re.fullmatch(r"[\w./-]+\.ya?ml", settings.value) else None
    if not isinstance(settings, Mapping) or settings.get("remote_src") is not None:
        return None
    word = settings.scalar("src") or settings.scalar("file")
    return word.value if word is not None else None
