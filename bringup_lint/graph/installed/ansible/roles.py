"""The roles that plays and tasks name, and the folders in which Ansible looks for them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.installed.ansible.projects import concerns
from bringup_lint.graph.installed.ansible.projects import project_of
from bringup_lint.graph.memo import memo
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.ansible_tasks import plays
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_NAME = regex(r"[\w/-]+")
_INCLUDES = ("include_role", "import_role")
_ROLES_PATH = regex(r"^[ \t]*roles_path[ \t]*=", re.M)
_VARIABLE = regex(r"\bANSIBLE_ROLES_PATH\b")
_SETTING = regex(r"(?:^|/)(?:[Mm]akefile|[Jj]ustfile|\.envrc|[^/]+\.(?:sh|bash|ya?ml|env|toml|ini))$")
"""Files that may set it for the commands of Ansible."""
_OF_ROLE = regex(r"(?:^|/)(?P<name>[\w.-]+)/(?:tasks|handlers|defaults|meta|vars)/main\.ya?ml$")
_MOST_FILES = 500
_SIZE = 64 * 1024
"""Bytes of a file that are looked at."""
_REQUIREMENTS = ("requirements.yml", "requirements.yaml", "galaxy.yml")


@dataclass(eq=False)
class Roles:
    """Which roles Ansible finds in the tree."""

    files: Files

    def missing(self, source: Source) -> Iterator[Located]:
        """The names of roles that are not in the tree and that nothing brings."""
        yield from (name for name in named_roles(source) if self._is_missing(source, name))

    def take_others(self, source: Source) -> bool:
        """Whether the plays and tasks of a file take in roles that come from elsewhere."""
        return any(self._is_from_elsewhere(source, name) for name in named_roles(source))

    def _is_from_elsewhere(self, source: Source, name: str) -> bool:
        own = name.rpartition("/")[2]
        return own not in self._own and not self._is_near(source, own) and not self._is_missing(source, name)

    def are_all_own(self, project: str) -> bool:
        """Whether no role of a project depends on one that is not in the tree."""
        metadata = (path for path in self._metadata if concerns(path, project))
        return all(name in self._own for path in metadata for name in self._needed(path))

    @property
    def needed(self) -> Iterator[str]:
        """The roles that others depend on."""
        return (name.rpartition("/")[2] for path in self._metadata for name in self._needed(path))

    @property
    def _metadata(self) -> Iterator[str]:
        names = ("main.yml", "main.yaml")
        paths = (path for name in names for path in self.files.tree.named(name))
        return (path for path in paths if os.path.dirname(path).endswith("/meta"))

    def _needed(self, path: str) -> Iterator[str]:
        """The roles that the metadata of a role name as its dependencies."""
        source = self.files.tree.read(path, judged=False)
        roots = [document.root for document in parse(source).documents] if source is not None else []
        for root in roots:
            for entry in (root.sequence("dependencies") if isinstance(root, Mapping) else None) or ():
                name = _role_name(entry)
                if name is not None:
                    yield str(name)

    def _is_missing(self, source: Source, name: str) -> bool:
        if not _NAME.fullmatch(name) or any(play.get("collections") is not None for play in plays(source)):
            return False
        return not self._is_there(source, name.rpartition("/")[2])

    def _is_there(self, source: Source, name: str) -> bool:
        """Whether a role is somewhere in the tree, or comes from elsewhere."""
        if name in self._own or self._is_near(source, name):
            return True
        return self._has_others(project_of(source.name)) or self._is_required(name) or self._is_submodule(name)

    @cached_property
    def _own(self) -> frozenset[str]:
        """The roles of the tree, in whatever folder."""
        paths = [f"/{path}" for path in self.files.tree.paths]
        found = {path.partition("/roles/")[2].partition("/")[0] for path in paths if "/roles/" in path}
        return frozenset(found | {match["name"] for path in paths if (match := _OF_ROLE.search(path))})

    def _is_submodule(self, name: str) -> bool:
        """Whether a submodule is the role, or may hold it."""
        modules = [path.split("/") for path in self.files.tree.submodules]
        return any(parts[-1] in (name, "roles") or "ansible" in parts[-1] for parts in modules)

    def _is_near(self, source: Source, name: str) -> bool:
        """Whether a role is beside the file or in a folder ``roles`` near it."""
        folder = os.path.dirname(source.absolute)
        near = (folder, f"{folder}/roles", f"{folder}/../roles", f"{folder}/../../roles")
        paths = (os.path.normpath(f"{each}/{name}") for each in near)
        tree = self.files.tree
        return any(tree.holds(path) and (tree.exists(path) or tree.is_ignored(path)) for path in paths)

    @memo
    def _has_others(self, project: str) -> bool:
        """Whether roles of a project may lie in folders that are not known."""
        if not any("/roles/" in f"/{path}" for path in self.files.tree.paths):
            return True
        return any(concerns(path, project) for path in self._naming_folders)

    @cached_property
    def _naming_folders(self) -> list[str]:
        """The settings of Ansible and the files with commands that say where roles are."""
        settings = (path for path in self.files.tree.named("ansible.cfg") if self._says(path, _ROLES_PATH))
        callers = [path for path in self.files.tree.paths if _SETTING.search(path)][:_MOST_FILES]
        return [*settings, *(path for path in callers if self._says(path, _VARIABLE))]

    def _says(self, path: str, wanted: re.Pattern[str]) -> bool:
        return wanted.search(self.files.tree.head(path, _SIZE)) is not None

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
        yield from roles_of(play)
    for task in tasks(source):
        for module in task.modules:
            name = module.settings.scalar("name") if isinstance(module.settings, Mapping) else None
            if module.name in _INCLUDES and name is not None:
                yield name.value


def roles_of(play: Mapping) -> Iterator[Located]:
    """The roles that a play names under ``roles:``."""
    names = map(_role_name, play.sequence("roles") or ())
    return (name for name in names if name is not None)


def _role_name(entry: Node) -> Located | None:
    """The role that an entry of a list means."""
    name = entry.scalar("role") or entry.scalar("name") if isinstance(entry, Mapping) else entry
    return name.value if isinstance(name, Scalar) else None
