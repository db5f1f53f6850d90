"""The handlers of a tree, and the tasks that notify them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.installed.ansible.projects import concerns
from bringup_lint.graph.installed.ansible.projects import project_of
from bringup_lint.graph.installed.ansible.roles import Roles
from bringup_lint.graph.memo import memo
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers.ansible_tasks import Task
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files


@dataclass(eq=False)
class Handlers:
    files: Files
    roles: Roles

    def missing(self, source: Source) -> Iterator[Located]:
        """The names of ``notify:`` that no handler of the tree has; nothing where not all handlers are known."""
        for name in _notified(source):
            if "{{" in name or name.rpartition(" : ")[2] in self._names:
                continue
            if self._are_all_known(project_of(source.name)):
                yield name

    @cached_property
    def _all(self) -> list[Task]:
        return [task for source in self.files.of_kind("ansible") for task in _handlers(source)]

    @cached_property
    def _names(self) -> frozenset[str]:
        """What a task may notify."""
        return frozenset(str(name) for task in self._all for name in _names(task))

    @memo
    def _are_all_known(self, project: str) -> bool:
        """Whether the names of all handlers are in the tree: none has a variable, and no role comes from elsewhere."""
        if any(task.includes or any("{{" in name for name in _names(task)) for task in self._all):
            return False
        sources = [source for source in self.files.of_kind("ansible") if concerns(source.name, project)]
        return self.roles.are_all_own(project) and not any(map(self.roles.take_others, sources))


def _notified(source: Source) -> Iterator[Located]:
    for task in tasks(source):
        yield from _words(task.keys.get("notify"))


def _handlers(source: Source) -> Iterator[Task]:
    """All tasks of a file that may hold handlers: of a play those below tasks, too, which have other names."""
    if "/handlers/" in f"/{source.name}" or "handlers" in source.text or "handler" in source.basename:
        yield from tasks(source)


def _names(task: Task) -> Iterator[Located]:
    yield from _words(task.keys.get("name"))
    yield from _words(task.keys.get("listen"))


def _words(node: Node | None) -> Iterator[Located]:
    if isinstance(node, Scalar):
        yield node.value
    elif isinstance(node, Sequence):
        yield from (each.value for each in node.scalars)
