"""The files of an Ansible project that its playbooks copy to hosts: by ``copy`` and ``template``, in the tasks of plays
and of their roles. What depends on a condition, a variable or a vault is not known, and left out.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.fleet.plays import Play
from bringup_lint.fleet.plays import Project
from bringup_lint.fleet.plays import for_host
from bringup_lint.fleet.plays import mappings
from bringup_lint.fleet.plays import plays
from bringup_lint.fleet.plays import scalars
from bringup_lint.graph.installed.paths import destination
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible import puts_of
from bringup_lint.parsers.ansible import variables_of

_CONDITIONS = ("when", "delegate_to", "run_once", "local_action")
_INCLUDED = ("import_tasks", "include_tasks")
_ROLES = ("import_role", "include_role")
_SOURCES = ("files", "templates", "")
"""Where ``src`` is looked for, in the folder of a role or playbook."""
_DEPTH = 10
"""Blocks, includes and roles inside each other."""
_MOST = 1000
"""Files of one folder that is copied."""
Files = tuple[tuple[str, str], ...]
"""Place on the robot, and the file that is copied there."""


class _Task(NamedTuple):
    node: Mapping
    folder: str
    """Of its role or playbook."""


class _Copy(NamedTuple):
    folder: str
    """Of its role or playbook."""
    name: str
    """Of the file or folder, as the task writes it."""
    place: str


@dataclass(eq=False)
class _Walk:
    """The way through the tasks of one play."""

    project: Project
    seen: set[tuple[str, ...]] = field(default_factory=set)
    """Roles and files of tasks that were met: what comes again brings nothing new."""

    def is_new(self, *what: str) -> bool:
        before = len(self.seen)
        self.seen.add(what)
        return len(self.seen) > before


def delivered(inventory: str, groups: dict[str, frozenset[str]]) -> dict[str, Files]:
    """Host -> the files that it gets; not where two files go to one place."""
    project = Project.of(inventory)
    known: dict[_Copy, Files] = {}
    found: dict[str, dict[str, str]] = defaultdict(dict)
    for play in plays(project, groups):
        for copy in filter(_is_known, dict.fromkeys(_copies(play, project))):
            for host in play.hosts:
                own = _Copy(copy.folder, for_host(copy.name, host), for_host(copy.place, host))
                if own not in known:
                    known[own] = tuple(_files(own, project))
                for place, path in known[own]:
                    _note(found[host], place, path)
    alike: dict[Files, Files] = {}
    for_hosts = {host: _single(places) for host, places in found.items()}
    return {host: alike.setdefault(files, files) for host, files in for_hosts.items() if files}


def _note(places: dict[str, str], place: str, path: str) -> None:
    """Note what comes to a place of a host: nothing is known where several files do."""
    places[place] = path if places.get(place, path) == path else ""


def _single(places: dict[str, str]) -> Files:
    return tuple((place, path) for place, path in sorted(places.items()) if path)


def _copies(play: Play, project: Project) -> Iterator[_Copy]:
    for task in _tasks_of(play, _Walk(project)):
        variables = variables_of([play.node, task.node])
        for put in puts_of(task.node, variables):
            if put.copied is not None and put.certain and not _is_remote(task.node):
                yield _Copy(task.folder, str(put.copied), str(put.path))


def _is_remote(task: Mapping) -> bool:
    """Whether the file lies on the host already."""
    return any(isinstance(value, Mapping) and value.get("remote_src") is not None for _, value in task.entries)


def _tasks_of(play: Play, walk: _Walk) -> Iterator[_Task]:
    if not _is_certain(play.node):
        return
    for name in ("pre_tasks", "tasks", "post_tasks"):
        yield from _tasks(play.node.get(name), play.folder, walk, _DEPTH)
    for role in _items(play.node.get("roles")):
        yield from _listed(role, play.folder, walk, _DEPTH)


def _listed(role: Node, folder: str, walk: _Walk, left: int) -> Iterator[_Task]:
    """The tasks of a role in a list: its name, or what else is said of it."""
    if isinstance(role, Scalar):
        yield from _of_role(str(role.value), folder, walk, left)
    elif isinstance(role, Mapping) and _is_certain(role):
        yield from _of_role(_name(role, "role") or _name(role, "name"), folder, walk, left)


def _tasks(node: Node | None, folder: str, walk: _Walk, left: int) -> Iterator[_Task]:
    """The tasks of a list, of its blocks, and of what it includes."""
    if not left:
        return
    for task in filter(_is_certain, mappings(node)):
        for inner in ("block", "always"):
            yield from _tasks(task.get(inner), folder, walk, left - 1)
        for key, value in task.entries:
            module = key.value.rpartition(".")[2]
            if module in _INCLUDED:
                yield from _included(_name(value, "file"), folder, walk, left - 1)
            elif module in _ROLES:
                yield from _of_role(_name(value, "name"), folder, walk, left - 1)
        yield _Task(task, folder)


def _included(name: str, folder: str, walk: _Walk, left: int) -> Iterator[_Task]:
    """The tasks of a file beside those of a role or playbook."""
    if walk.is_new(folder, name):
        tasks = walk.project.read(folder, "tasks", name) or walk.project.read(folder, name)
        yield from _tasks(tasks, folder, walk, left)


def _of_role(name: str, folder: str, walk: _Walk, left: int) -> Iterator[_Task]:
    """The tasks of a role, and of those that it depends on."""
    read = walk.project.read
    places = [os.path.join(top, "roles", name) for top in dict.fromkeys((folder, walk.project.folder))]
    role = next(filter(os.path.isdir, filter(walk.project.holds, places)), None)
    if not name or role is None or not left or not walk.is_new(os.path.realpath(role)):
        return
    meta = next(mappings(read(role, "meta", "main.yml")), None)
    for each in _items(meta and meta.get("dependencies")):
        yield from _listed(each, folder, walk, left - 1)
    tasks = read(role, "tasks", "main.yml") or read(role, "tasks", "main.yaml")
    yield from _tasks(tasks, role, walk, left - 1)


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
    tags = {word.strip() for each in scalars(node.get("tags")) for word in each.value.split(",")}
    return "never" not in tags


def _is_known(copy: _Copy) -> bool:
    """Whether both ends are known when the name of the host is."""
    return not any("{{" in for_host(text, "host") or "{%" in text for text in (copy.name, copy.place))


def _files(copy: _Copy, project: Project) -> Iterator[tuple[str, str]]:
    """The place and path of the file that is meant, or of all files of the folder. What lies outside of the project is
    not looked at."""
    name = copy.name
    if not name or os.path.isabs(name) or ".." in name.split("/"):
        return
    whole = [os.path.join(copy.folder, inner, name) for inner in _SOURCES]
    if not all(map(project.holds, whole)):
        return
    found = [os.path.normpath(each) for each in whole if os.path.exists(each)]
    if len(set(found)) != 1:
        return
    if os.path.isfile(found[0]):
        target = destination(copy.place, os.path.basename(found[0]), several=False)
        if target:
            yield target, found[0]
        return
    top = copy.place.rstrip("/") + ("" if name.endswith("/") else f"/{os.path.basename(found[0])}")
    yield from ((top + path[len(found[0]) :], path) for path in _below(found[0]) if project.holds(path))


def _below(folder: str) -> list[str]:
    found: list[str] = []
    for top, folders, names in os.walk(folder):
        folders.sort()
        found += (os.path.join(top, name) for name in sorted(names))
        if len(found) > _MOST:
            return []
    return found
