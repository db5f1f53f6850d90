"""The roles, handlers, files and hosts that plays and roles name and that Ansible certainly does not find."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.installed.ansible.connections import unknown_connections
from bringup_lint.graph.installed.ansible.handlers import Handlers
from bringup_lint.graph.installed.ansible.hosts import PlayHosts
from bringup_lint.graph.installed.ansible.roles import Roles
from bringup_lint.graph.installed.ansible.task_files import TaskFiles
from bringup_lint.graph.installed.ansible.variables import Variables
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files


class MissingName(NamedTuple):
    where: Located
    what: str
    """``role``, ``handler``, ``file``, ``hosts``, ``variable`` or ``connection``."""
    meant: str = ""
    """The name that it nearly is; only of ``hosts``."""


def missing_names(files: Files, sources: Iterable[Source]) -> Iterator[MissingName]:
    """Each place that names a role, a handler, a file or hosts that are not there, in the order of the sources."""
    roles = Roles(files)
    handlers = Handlers(files, roles)
    task_files = TaskFiles(files)
    hosts = PlayHosts(files)
    variables = Variables(files, roles)
    for source in sources:
        if _is_read(source):
            yield from (MissingName(where, "role") for where in roles.missing(source))
            yield from (MissingName(where, "handler") for where in handlers.missing(source))
            yield from (MissingName(where, "file") for where in task_files.missing(source))
            yield from (MissingName(where, "hosts", meant) for where, meant in hosts.misspelt(source))
            yield from (MissingName(where, "variable") for where in variables.missing(source))
    yield from (MissingName(where, "connection") for where in unknown_connections(files))


def _is_read(source: Source) -> bool:
    """Whether Ansible reads the file as it is, names in braces being its own, and for a robot: Molecule brings roles
    and files of its own to its tests."""
    return source.judged and source.template in ("", "jinja") and "/molecule/" not in f"/{source.name}"
