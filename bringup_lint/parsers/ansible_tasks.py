"""The tasks of Ansible's plays and roles, with the rights that they run with (playbooks_privilege_escalation)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_LISTS = ("pre_tasks", "tasks", "post_tasks", "handlers")
_BLOCKS = ("block", "rescue", "always")
_INCLUDES = ("include_tasks", "import_tasks", "include_role", "import_role", "include", "import_playbook", "roles")
_FORGIVING = ("ignore_errors", "failed_when", "rescue")
_DEEPEST = 20
_SETTING = regex(
    r"[ \t\r\n]*(?P<name>[a-z_]\w*)="
    r"(?:\"(?P<double>[^\"\\]*)\"|'(?P<single>[^'\\]*)'|(?P<plain>(?:\{\{[^{}]*\}\}|[^\s\"'\\{])*))(?=\s|\Z)"
)
"""One ``name=value`` of the settings in one line."""
_FREE = frozenset({"command", "shell", "raw", "script", "expect"})
"""Modules that take the line as it is."""


class Module(NamedTuple):
    """A key of a task that may name its module, with the settings."""

    key: Located
    settings: Node

    @property
    def name(self) -> str:
        """Without its collection: ``copy`` of ``ansible.builtin.copy``."""
        return self.key.rpartition(".")[2]


class Task(NamedTuple):
    """One task, and whether it runs as root."""

    keys: Mapping
    """All that the task says."""
    become: bool | None
    """Of the task, or of the blocks and the play around it; None: none of them says it, or the value is not known."""
    may_fail: bool = False
    """The play goes on when it fails: by its own keys, or by a block with ``rescue``."""
    conditional: bool = False
    """It runs where a condition holds: its own, or that of a block around it."""

    @property
    def own_become(self) -> bool | None:
        return _become(self.keys)

    @property
    def modules(self) -> Iterator[Module]:
        return modules(self.keys)

    @property
    def includes(self) -> bool:
        """Whether it takes in other tasks."""
        return any(module.name in _INCLUDES for module in self.modules)


class _Around(NamedTuple):
    """What the blocks and the play around a task say for it."""

    become: bool | None = None
    may_fail: bool = False
    conditional: bool = False


def modules(task: Mapping) -> Iterator[Module]:
    return (Module(key.value, _settings(key.value, value)) for key, value in task.entries if key.value != "name")


def _settings(key: Located, value: Node) -> Node:
    """The settings of a module; of those in one line (``src=a dest=b``) the mapping that they stand for."""
    if not isinstance(value, Scalar) or "=" not in value.value or key.rpartition(".")[2] in _FREE:
        return value
    pairs: list[tuple[Node, Node]] = []
    at = 0
    while match := _SETTING.match(value.value, at):
        name, word = (value.value.part(*match.span(group)) for group in ("name", _filled_group(match)))
        pairs.append((Scalar(name, name.span), Scalar(word, word.span, style="'")))
        at = match.end()
    return Mapping(value.span, pairs) if pairs and not value.value[at:].strip() else value


def _filled_group(match: re.Match[str]) -> str:
    return next(group for group in ("double", "single", "plain") if match[group] is not None)


def tasks(source: Source) -> tuple[Task, ...]:
    """The tasks of a playbook or of a role's file, those in blocks included."""
    return source.once(tasks, lambda: tuple(_tasks(source)))


def plays(source: Source) -> tuple[Mapping, ...]:
    """The plays of a file."""
    return source.once(plays, lambda: tuple(item for item in _items(source) if item.get("hosts") is not None))


def _tasks(source: Source) -> Iterator[Task]:
    for item in _items(source):
        yield from _of_play(item) if item.get("hosts") is not None else _of_task(item, _Around(), 0)


def _items(source: Source) -> Iterator[Mapping]:
    for document in source.once(parse, lambda: parse(source)).documents:
        if isinstance(document.root, Sequence):
            yield from (item for item in document.root if isinstance(item, Mapping))


def _of_play(play: Mapping) -> Iterator[Task]:
    for name in _LISTS:
        for item in play.sequence(name) or ():
            if isinstance(item, Mapping):
                yield from _of_task(item, _Around(_become(play)), 0)


def _of_task(keys: Mapping, around: _Around, depth: int) -> Iterator[Task]:
    own = _become(keys)
    become = around.become if own is None else own
    may_fail = around.may_fail or any(keys.get(key) is not None for key in _FORGIVING)
    conditional = around.conditional or keys.get("when") is not None
    inner = [each for name in _BLOCKS for each in keys.sequence(name) or ()]
    if not inner:
        yield Task(keys, become, may_fail, conditional)
    elif depth < _DEEPEST:
        for each in inner:
            if isinstance(each, Mapping):
                yield from _of_task(each, _Around(become, may_fail, conditional), depth + 1)


def _become(keys: Mapping) -> bool | None:
    value = keys.get("become")
    return value.boolean if isinstance(value, Scalar) else None
