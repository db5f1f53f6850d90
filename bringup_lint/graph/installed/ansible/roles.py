"""The roles that plays and tasks name, and the folders in which Ansible looks for them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.ansible_tasks import plays
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_NAME = regex(r"[\w/-]+")
_INCLUDES = ("include_role", "import_role")
_ROLES_PATH = regex(r"^[ \t]*roles_path[ \t]*=", re.M)
_REQUIREMENTS = ("requirements.yml", "requirements.yaml", "galaxy.yml")


@dataclass(eq=False)
class Roles:
    files: Files

    def missing(self, source: Source) -> Iterator[Located]:
        """The names of roles that are not in the tree and that nothing brings."""
        for name in named_roles(source):
            if _NAME.fullmatch(name) and not self._is_there(source, name.rpartition("/")[2]):
                yield name

    def _is_there(self, source: Source, name: str) -> bool:
        """Whether a role is somewhere in the tree, or comes from elsewhere."""
        if any(f"/roles/{name}/" in f"/{path}" for path in self.files.tree.paths):
            return True
        return self._is_near(source, name) or self._has_others or self._is_required(name)

    def _is_near(self, source: Source, name: str) -> bool:
        """Whether a role is beside the file or in a folder ``roles`` near it."""
        folder = os.path.dirname(os.path.abspath(source.name))
        near = (folder, f"{folder}/roles", f"{folder}/../roles", f"{folder}/../../roles")
        paths = (os.path.normpath(f"{each}/{name}") for each in near)
        return any(self.files.tree.holds(path) and self.files.tree.exists(path) for path in paths)

    @cached_property
    def _has_others(self) -> bool:
        """Whether roles lie in folders that are not known."""
        if not any("/roles/" in f"/{path}" for path in self.files.tree.paths):
            return True
        return any(_ROLES_PATH.search(text) for text in self._texts("ansible.cfg"))

    def _is_required(self, name: str) -> bool:
        """Whether a list of what ansible-galaxy installs names the role."""
        return any(name in text for text in self._texts(*_REQUIREMENTS))

    def _texts(self, *names: str) -> Iterator[str]:
        for name in names:
            for path in self.files.tree.named(name):
                source = self.files.tree.read(path, judged=False)
                if source is not None:
                    yield source.text


def named_roles(source: Source) -> Iterator[Located]:
    """The roles of ``roles:``, ``include_role`` and ``import_role``."""
    for play in plays(source):
        for entry in play.sequence("roles") or ():
            name = entry.scalar("role") or entry.scalar("name") if isinstance(entry, Mapping) else entry
            if isinstance(name, Scalar):
                yield name.value
    for task in tasks(source):
        for module, settings in task.modules:
            name = settings.scalar("name") if isinstance(settings, Mapping) else None
            if module.rpartition(".")[2] in _INCLUDES and name is not None:
                yield name.value
