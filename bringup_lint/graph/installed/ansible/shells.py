"""The commands that tasks of Ansible give to ``/bin/sh`` (ansible.builtin.shell)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.shell import Command
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.ansible_tasks import Task
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_OTHER_SHELL = regex(r"\bansible_shell_executable\b|\bansible_shell_type\b|\bwin_\w+:|\b(?:dnf5?|yum|pacman|rpm_key):")
"""A variable with the shell, or a task for a distribution whose /bin/sh is bash."""
_DEFAULTS = regex(r"\bmodule_defaults:(?:[^\n]{0,200}\n){1,20}?[^\n]{0,200}\bexecutable:")
"""A play gives all its tasks a shell."""
_CONFIGURED = regex(r"(?m)^[ \t]*executable[ \t]*=[ \t]*\S*(?:bash|zsh)")


def sh_commands(files: Files) -> Iterator[Command]:
    """The commands of all tasks whose shell is ``/bin/sh`` and that stop the play when they fail."""
    sources = files.of_kind("ansible")
    if any(map(_chooses_shell, [*sources, *files.of_kind("ansible-vars")])) or _is_configured(files):
        return
    for source in sources:
        if source.judged and "shell" in source.text and not _DEFAULTS.search(source.text):
            for task in tasks(source):
                for script in _scripts(task):
                    yield from commands(script)


def _chooses_shell(source: Source) -> bool:
    return _OTHER_SHELL.search(source.text) is not None


def _is_configured(files: Files) -> bool:
    """Whether an ``ansible.cfg`` names another shell for all tasks."""
    return any(_CONFIGURED.search(files.tree.head(path, 64 * 1024)) for path in files.tree.named("ansible.cfg"))


def _scripts(task: Task) -> Iterator[Located]:
    arguments = task.keys.mapping("args")
    if task.may_fail or (arguments is not None and arguments.get("executable") is not None):
        return
    for module in task.modules:
        if module.name == "shell":
            text = _text(module.settings)
            if text is not None and "executable=" not in text:
                yield text


def _text(settings: Node) -> Located | None:
    if isinstance(settings, Mapping):
        given = settings.scalar("cmd") if settings.get("executable") is None else None
        return given.value if given is not None else None
    return settings.value if isinstance(settings, Scalar) else None
