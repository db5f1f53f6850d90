"""A play names a role, a handler or a file that does not exist.

## What it finds
In Ansible's playbooks and roles:
- a role of `roles:`, `include_role` or `import_role` of which no folder `roles/NAME` and no requirements file speaks;
- a handler of `notify:` that no handler of the tree is called, by its name or its `listen`;
- a file of `copy: src`, `template: src`, `include_tasks` or `import_tasks` that is not in the folders in which Ansible
  looks for it.

Silent for names with variables, roles of collections (`namespace.name`), files that git ignores, and where handlers of
the tree have names with variables.

## Why it matters on a robot
The play stops at this task, on the robot that is half set up: packages are new, and the unit that starts them is the
old one or is not there. A missing handler shows only on the machine where its task changes something.

## Bad
```yaml
- name: udev rules
  ansible.builtin.copy: {src: 99-arm.rules, dest: /etc/udev/rules.d/99-arm.rules}
  notify: reload udev        # the handler is called "Reload udev rules"
```

## Good
```yaml
- name: udev rules
  ansible.builtin.copy: {src: 99-arm.rules, dest: /etc/udev/rules.d/99-arm.rules}
  notify: Reload udev rules
```

## When to ignore it
When the role or its handlers come from another repository that no requirements file names.

## References
- https://docs.ansible.com/ansible/latest/playbook_guide/playbooks_handlers.html
- https://docs.ansible.com/ansible/latest/playbook_guide/playbook_pathing.html
"""

import os
import re
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Task
from bringup_lint.api.shell import plays
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Node
from bringup_lint.api.yaml import Scalar
from bringup_lint.api.yaml import Sequence

ROLE = regex(r"(?P<role>.*/roles/[^/]+)/")
NAME = regex(r"[\w/-]+")
FOLDERS = {
    "copy": ("files", "."),
    "template": ("templates", "."),
    "include_tasks": (".", "tasks"),
    "import_tasks": (".", "tasks"),
    "script": ("files", "."),
}
"""Where Ansible looks, below the role and beside the file."""
INCLUDES = ("include_role", "import_role")
ROLES_PATH = regex(r"^[ \t]*roles_path[ \t]*=", re.M)


class Missing(NamedTuple):
    where: Located
    what: str


TEXTS = {
    "role": ("There is no role {}: the play does not start", "correct the name, or add the role"),
    "handler": ("No handler is called '{}': the play stops when this task changes something", "write its exact name"),
    "file": ("Ansible finds no {}: the play stops at this task", "correct the name, or add the file"),
}


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "the role * was not found in",
        "The requested handler * was not found",
        "Could not find or access",
    ],
)
def ansible_name_missing(robot: Robot) -> Iterator[Finding]:
    sources = [source for source in robot.of_kind("ansible") if source.judged and not source.template.startswith("c")]
    found: dict[tuple[Source, str, str], list[Located]] = {}
    for source in sources:
        for missing in (*_roles(robot, source), *_handlers(robot, source), *_files(robot, source)):
            found.setdefault((source, missing.what, str(missing.where)), []).append(missing.where)
    for (_, what, name), (first, *others) in found.items():
        message, advice = TEXTS[what]
        yield finding(
            first,
            message.format(name),
            advice=advice,
            related=[note(other, "named here too") for other in others[:20]],
        )


def _roles(robot: Robot, source: Source) -> Iterator[Missing]:
    for name in _named_roles(source):
        plain = str(name)
        if NAME.fullmatch(plain) and not _has_role(robot, source, plain.rpartition("/")[2]):
            yield Missing(name, "role")


def _named_roles(source: Source) -> Iterator[Located]:
    for play in plays(source):
        for entry in play.sequence("roles") or ():
            name = entry.scalar("role") or entry.scalar("name") if isinstance(entry, Mapping) else entry
            if isinstance(name, Scalar):
                yield name.value
    for task in tasks(source):
        for module, settings in task.modules:
            name = settings.scalar("name") if isinstance(settings, Mapping) else None
            if module.rpartition(".")[2] in INCLUDES and name is not None:
                yield name.value


def _has_role(robot: Robot, source: Source, name: str) -> bool:
    """Whether a role is somewhere in the tree, or comes from elsewhere."""
    if any(f"/roles/{name}/" in f"/{path}" for path in robot.tree.paths):
        return True
    folder = _folder(source)
    near = (folder, f"{folder}/roles", f"{folder}/../roles", f"{folder}/../../roles")
    if any(_is_there(robot, os.path.normpath(f"{each}/{name}")) for each in near):
        return True
    if not any("/roles/" in f"/{path}" for path in robot.tree.paths):
        return True
    configured = (robot.tree.read(path, judged=False) for path in robot.tree.named("ansible.cfg"))
    if any(each is not None and ROLES_PATH.search(each.text) for each in configured):
        return True
    required = (
        robot.tree.read(path, judged=False)
        for file in ("requirements.yml", "requirements.yaml", "galaxy.yml")
        for path in robot.tree.named(file)
    )
    return any(each is not None and name in each.text for each in required)


def _handlers(robot: Robot, source: Source) -> Iterator[Missing]:
    asked = [(task, name) for task in tasks(source) for name in _words(task.keys.get("notify"))]
    if not asked:
        return
    known, certain = _known_handlers(robot)
    for _, name in asked:
        plain = str(name).rpartition(" : ")[2]
        if certain and "{{" not in plain and plain not in known:
            yield Missing(name, "handler")


def _words(node: Node | None) -> Iterator[Located]:
    if isinstance(node, Scalar):
        yield node.value
    elif isinstance(node, Sequence):
        yield from (each.value for each in node.scalars)


def _known_handlers(robot: Robot) -> tuple[frozenset[str], bool]:
    """The names that a task may notify, and whether these are all."""
    known: set[str] = set()
    certain = True
    for source in robot.files.of_kind("ansible"):
        for task in _own_handlers(source):
            names = [*_words(task.keys.get("name")), *_words(task.keys.get("listen"))]
            known.update(map(str, names))
            certain &= not task.includes and not any("{{" in name for name in names)
    return frozenset(known), certain


def _own_handlers(source: Source) -> Iterator[Task]:
    """All tasks of a file that may hold handlers: of a play those below tasks, too, which have other names."""
    if "/handlers/" in f"/{source.name}" or "handlers" in source.text or "handler" in source.basename:
        yield from tasks(source)


def _files(robot: Robot, source: Source) -> Iterator[Missing]:
    for task in tasks(source):
        if task.keys.get("loop") is not None or task.keys.get("ignore_errors") is not None:
            continue
        for module, settings in task.modules:
            folders = FOLDERS.get(module.rpartition(".")[2])
            word = _file(settings) if folders is not None else None
            if folders is not None and word is not None and _is_missing(robot, source, str(word), folders):
                yield Missing(word, "file")


def _file(settings: Node) -> Located | None:
    """The file of the tree that a module reads."""
    if isinstance(settings, Scalar):
        return settings.value if re.fullmatch(r"[\w./-]+\.ya?ml", settings.value) else None
    if not isinstance(settings, Mapping) or settings.get("remote_src") is not None:
        return None
    word = settings.scalar("src") or settings.scalar("file")
    return word.value if word is not None else None


def _is_missing(robot: Robot, source: Source, path: str, folders: tuple[str, ...]) -> bool:
    if "{{" in path or "*" in path or path.startswith(("/", "~", "http")) or not path.strip():
        return False
    here = _folder(source)
    role = ROLE.match(os.path.abspath(source.name))
    tops = [here, os.path.dirname(here), *([role["role"]] if role is not None else [])]
    if role is None and not any(
        f"/{each}/" in f"/{known}" for each in ("roles", "tasks") for known in robot.tree.paths
    ):
        return False
    tried = [os.path.normpath(os.path.join(top, folder, path)) for top in tops for folder in folders]
    if any(robot.tree.exists(each) or robot.tree.is_ignored(each) for each in tried):
        return False
    outer = (os.path.normpath(os.path.join(top, "../..", folder, path)) for top in tops for folder in folders)
    return not any(_is_there(robot, each) for each in outer)


def _is_there(robot: Robot, path: str) -> bool:
    """Whether the tree has it; what lies outside is not known to be there."""
    return robot.tree.holds(path) and robot.tree.exists(path)


def _folder(source: Source) -> str:
    return os.path.dirname(os.path.abspath(source.name))
