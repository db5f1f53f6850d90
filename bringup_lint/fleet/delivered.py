"""The files of an Ansible project that its playbooks copy to hosts: by ``copy`` and ``template``, in the tasks of plays
and of their roles. What depends on a condition, a variable or a vault is not known, and left out.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cache

from bringup_lint.fleet.plays import Play
from bringup_lint.fleet.plays import mappings
from bringup_lint.fleet.plays import plays
from bringup_lint.fleet.plays import project_of
from bringup_lint.fleet.plays import read
from bringup_lint.graph.installed.paths import destination
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible import puts_of
from bringup_lint.parsers.ansible import variables_of
from bringup_lint.pattern import regex

_HOST_NAME = regex(r"\{\{ *inventory_hostname *\}\}")
_CONDITIONS = ("when", "delegate_to", "run_once", "local_action")
_INCLUDED = ("import_tasks", "include_tasks")
_ROLES = ("import_role", "include_role")
_SOURCES = ("files", "templates", "")
"""Where ``src`` is looked for, in the folder of a role or playbook."""
_DEPTH = 10
_MOST = 1000
"""Files of one folder that is copied."""
Files = tuple[tuple[str, str], ...]
"""Place on the robot, and the file that is copied there."""


class _Task(NamedTuple):
    node: Mapping
    folder: str
    """Of its role or playbook."""


class _Copy(NamedTuple):
    source: str
    """Absolute."""
    place: str


def delivered(inventory: str, groups: dict[str, frozenset[str]]) -> dict[str, Files]:
    """Host -> the files that it gets; not where two files go to one place."""
    project = project_of(inventory)
    found: dict[str, dict[str, set[str]]] = defaultdict(lambda: defaultdict(set))
    for play in plays(project, groups):
        for copy in filter(_is_known, dict.fromkeys(_copies(play, project))):
            for host in play.hosts:
                for each in _files(_for_host(copy.source, host), _for_host(copy.place, host)):
                    found[host][each.place].add(each.source)
    alike: dict[Files, Files] = {}
    for_host = {host: _single(places) for host, places in found.items()}
    return {host: alike.setdefault(files, files) for host, files in for_host.items() if files}


def _single(places: dict[str, set[str]]) -> Files:
    return tuple((place, min(sources)) for place, sources in sorted(places.items()) if len(sources) == 1)


def _copies(play: Play, project: str) -> Iterator[_Copy]:
    for task in _tasks_of(play, project):
        variables = variables_of([play.node, task.node])
        for put in puts_of(task.node, variables):
            if put.copied is not None and put.certain and not _is_remote(task.node):
                yield _Copy(os.path.join(task.folder, "\0", str(put.copied)), str(put.path))


def _is_remote(task: Mapping) -> bool:
    """Whether the file lies on the host already."""
    return any(isinstance(value, Mapping) and value.get("remote_src") is not None for _, value in task.entries)


def _tasks_of(play: Play, project: str) -> Iterator[_Task]:
    if not _is_certain(play.node):
        return
    for name in ("pre_tasks", "tasks", "post_tasks"):
        yield from _tasks(play.node.get(name), play.folder, project, _DEPTH)
    for role in _items(play.node.get("roles")):
        if isinstance(role, Scalar):
            yield from _of_role(str(role.value), play.folder, project, _DEPTH)
        elif isinstance(role, Mapping) and _is_certain(role):
            yield from _of_role(_name(role, "role") or _name(role, "name"), play.folder, project, _DEPTH)


def _tasks(node: Node | None, folder: str, project: str, left: int) -> Iterator[_Task]:
    """The tasks of a list, of its blocks, and of what it includes."""
    if not left:
        return
    for task in filter(_is_certain, mappings(node)):
        for inner in ("block", "always"):
            yield from _tasks(task.get(inner), folder, project, left - 1)
        for key, value in task.entries:
            module = key.value.rpartition(".")[2]
            if module in _INCLUDED:
                file = os.path.join(folder, "tasks", _name(value, "file"))
                beside = os.path.join(folder, _name(value, "file"))
                yield from _tasks(read(file) or read(beside), folder, project, left - 1)
            elif module in _ROLES:
                yield from _of_role(_name(value, "name"), folder, project, left - 1)
        yield _Task(task, folder)


def _of_role(name: str, folder: str, project: str, left: int) -> Iterator[_Task]:
    """The tasks of a role, and of those that it depends on."""
    places = [os.path.join(top, "roles", name) for top in dict.fromkeys((folder, project))]
    role = next(filter(os.path.isdir, places), None)
    if not name or role is None or not left:
        return
    meta = next(mappings(read(os.path.join(role, "meta", "main.yml"))), None)
    for each in _items(meta and meta.get("dependencies")):
        if not isinstance(each, Mapping) or _is_certain(each):
            yield from _of_role(_name(each, "role") or _name(each, "name"), folder, project, left - 1)
    tasks = read(os.path.join(role, "tasks", "main.yml")) or read(os.path.join(role, "tasks", "main.yaml"))
    yield from _tasks(tasks, role, project, left - 1)


def _items(node: Node | None) -> Iterable[Node]:
    """Those of a list; nothing of anything else."""
    return node if isinstance(node, Sequence) else ()


def _name(node: Node | None, key: str) -> str:
    """A text, or that of a key."""
    given = node.get(key) if isinstance(node, Mapping) else node
    return str(given.value) if isinstance(given, Scalar) else ""


def _is_certain(node: Mapping) -> bool:
    """Whether a play, role, block or task does what it says, on each of its hosts and on no other."""
    if any(node.get(name) is not None for name in _CONDITIONS):
        return False
    tags = node.get("tags")
    words = [tags] if isinstance(tags, Scalar) else _items(tags)
    return "never" not in {_name(each, "") for each in words}


def _is_known(copy: _Copy) -> bool:
    """Whether both ends are known when the name of the host is."""
    return not any("{{" in _for_host(text, "host") or "{%" in text for text in copy)


def _for_host(text: str, host: str) -> str:
    return _HOST_NAME.sub(lambda _: host, text)


@cache
def _files(source: str, place: str) -> tuple[_Copy, ...]:
    """The file that is meant, or all files of the folder, with their places."""
    folder, _, name = source.partition("/\0/")
    whole = [os.path.join(folder, inner, name) for inner in _SOURCES]
    found = [os.path.normpath(each) for each in whole if os.path.exists(each)]
    if len(set(found)) != 1 or ".." in name.split("/"):
        return ()
    if os.path.isfile(found[0]):
        target = destination(place, os.path.basename(found[0]), several=False)
        return (_Copy(found[0], target),) if target else ()
    top = place.rstrip("/") + ("" if name.endswith("/") else f"/{os.path.basename(found[0])}")
    return tuple(_Copy(path, top + path[len(found[0]) :]) for path in _below(found[0]))


def _below(folder: str) -> list[str]:
    found: list[str] = []
    for top, folders, names in os.walk(folder):
        folders.sort()
        found += (os.path.join(top, name) for name in sorted(names))
        if len(found) > _MOST:
            return []
    return found
