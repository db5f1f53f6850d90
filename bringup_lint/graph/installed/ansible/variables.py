"""The variables that tasks read and to which nothing of the tree gives a value."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.installed.ansible.projects import project_of
from bringup_lint.graph.installed.ansible.roles import Roles
from bringup_lint.graph.installed.ansible.roles import named_roles
from bringup_lint.graph.memo import memo
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers.ansible_tasks import Task
from bringup_lint.parsers.ansible_tasks import plays
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_READ = regex(r"\{\{-?[ \t]*(?P<name>[a-z_][a-z0-9_]{2,80})(?=[ \t]*(?:-?\}\}|[|.\[]))(?P<rest>[^{}]{0,300})\}\}")
"""An expression that begins with a variable."""
_NAME = regex(r"(?<!\w)[a-z_][a-z0-9_]{2,80}(?!\w)")
_FORGIVING = regex(r"\bdefault\b|\bd\(|\bdefined\b|\bomit\b")
_GIVEN = regex(
    r"(?:ansible|inventory|facter|ohai|molecule|ec2|playbook|role)_\w+|hostvars|groups?|group_names|item|omit|vars|now"
    r"|environment|services|packages|play_hosts|lookup|query|undef|loop|template_\w+"
)
"""Variables that Ansible sets itself, its modules and inventories among them."""
_INVENTORY = regex(r"/(?:group|host)_vars/|/[^/]*(?:hosts|inventor)[^/]*(?:/[^/]+)?$")
_GROWS = regex(r"(?m)^[ \t]*plugin[ \t]*:|\bset_fact:[ \t]*\n[ \t]*[\"']?\{\{|\badd_host\b")
"""What brings variables that no file names."""
_PLUGINS = regex(r"/(?:library|(?:action|vars|lookup|inventory)_plugins)/[^/]+\.py$|/(?:hosts|inventory)[^/]*\.py$")
_ROLE = regex(r"/roles/(?P<name>[^/]+)/")
_OF_GROUPS = regex(r"/(?:group|host)_vars/")
_VAULT = "$ANSIBLE_VAULT"
_TEXT = regex(
    r"(?:^|/)[^/.]+$|\.(?:ya?ml|j2|jinja2?|ini|cfg|conf|sh|bash|md|rst|txt|json|toml|env|py|mk|service|local|example)$"
)
_SIZE = 200_000
_MOST = 4000
"""Files of a tree in which a variable is looked for."""


@dataclass(eq=False)
class Variables:
    files: Files
    roles: Roles

    def missing(self, source: Source) -> Iterator[Located]:
        """The variables of tasks whose name the tree says in such expressions only, and without a default."""
        if "{{" not in source.text or self._has_unknown(project_of(source.name)) or self._is_given_more(source):
            return
        for task in tasks(source):
            for name in _read(task):
                if not _GIVEN.fullmatch(name) and str(name) not in self._said:
                    yield name

    @memo
    def _has_unknown(self, project: str) -> bool:
        """Whether a project may have variables that are not in the tree."""
        sources = self.files.of_kind("ansible")
        has_inventory = any(_INVENTORY.search(f"/{each.name}") for each in self.files.of_kind("ansible-vars"))
        if not has_inventory or self._has_plugins or any(map(self.roles.take_others, sources)):
            return True
        return not self.roles.are_all_own(project) or any(map(self._includes_unknown, sources))

    @cached_property
    def _has_plugins(self) -> bool:
        """Whether code of the tree, an inventory of a plugin, or what is encrypted, gives hosts their variables."""
        if any(_GROWS.search(each.text) for each in self.files.of_kind("ansible", "ansible-vars")):
            return True
        tree = self.files.tree
        paths = [path for path in tree.paths if _OF_GROUPS.search(path)]
        return bool(tree.like(_PLUGINS)) or any(tree.start(path, 32).startswith(_VAULT) for path in paths)

    def _includes_unknown(self, source: Source) -> bool:
        """Whether a task reads variables from a file that is not in the tree."""
        if "include_vars" not in source.text:
            return False
        named = (module.settings for task in tasks(source) for module in task.modules if module.name == "include_vars")
        return any(not self._is_readable(path) for settings in named for path in _paths(settings))

    def _is_readable(self, path: str) -> bool:
        """Whether a file of variables is in the tree, in clear text."""
        if "{{" in path:
            return True
        found = list(self.files.tree.named(os.path.basename(path.rstrip("/"))))
        return bool(found) and not any(self.files.tree.start(each, 32).startswith(_VAULT) for each in found)

    def _is_given_more(self, source: Source) -> bool:
        """Whether the plays of a file, or those that use its role, read variables that nobody knows."""
        playbooks, roles = self._given_more
        role = _ROLE.search(f"/{source.name}")
        if role is not None:
            return role["name"] in roles
        return bool(playbooks) and (source in playbooks or not plays(source))

    @cached_property
    def _given_more(self) -> tuple[set[Source], set[str]]:
        sources = {
            source
            for source in self.files.of_kind("ansible")
            for play in plays(source)
            if any(not self._is_readable(path) for path in _paths(play.get("vars_files")))
        }
        return sources, {name.rpartition("/")[2] for source in sources for name in named_roles(source)}

    @cached_property
    def _said(self) -> set[str]:
        """What the texts of the tree say otherwise than to read it."""
        tree = self.files.tree
        return {name for path in tree.like(_TEXT)[:_MOST] for name in _names(tree.start(path, _SIZE))}


def _names(text: str) -> Iterator[str]:
    """What a text says outside of expressions that read it, or of which it says that it may be undefined."""
    read = {match.start("name") for match in _READ.finditer(text) if not _FORGIVING.search(match["rest"])}
    return (match[0] for match in _NAME.finditer(text) if match.start() not in read)


def _read(task: Task) -> Iterator[Located]:
    """The variables that the expressions of a task begin with."""
    for key, value in task.keys.entries:
        if key.value != "name":
            yield from _of_node(value)


def _of_node(node: Node) -> Iterator[Located]:
    if isinstance(node, Scalar):
        for match in _READ.finditer(node.value):
            if not _FORGIVING.search(match["rest"]):
                yield node.value.part(*match.span("name"))
    elif isinstance(node, Sequence):
        for each in node:
            yield from _of_node(each)
    elif isinstance(node, Mapping):
        for _, value in node.pairs:
            yield from _of_node(value)


def _paths(node: Node | None) -> Iterator[str]:
    """The files that ``vars_files`` or ``include_vars`` names."""
    if isinstance(node, Scalar):
        yield node.value
    elif isinstance(node, Sequence):
        yield from (each.value for each in node.scalars)
    elif isinstance(node, Mapping):
        yield from (given.value for key in ("file", "dir") if (given := node.scalar(key)) is not None)
