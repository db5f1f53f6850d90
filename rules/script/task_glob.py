"""A task of Ansible names files by a pattern that its module takes for a name.

## What it finds
`*` in `path`, `dest` or `src` of the modules file, copy, template, unarchive, lineinfile, blockinfile, replace,
slurp and fetch, outside of expressions.

## Why it matters on a robot
Only a shell and the lookup `fileglob` expand patterns. `file` with `state: absent` looks for a file that is called
`*.list`, finds none, and is "ok": what was to go away stays, on each robot. The other modules end the play.

## Bad
```yaml
- name: Remove the old drivers
  ansible.builtin.file: {path: /opt/arm/drivers/*.so, state: absent}
```

## Good
```yaml
- name: Old drivers
  ansible.builtin.find: {paths: /opt/arm/drivers, patterns: "*.so"}
  register: old
- name: Remove the old drivers
  ansible.builtin.file: {path: "{{ item.path }}", state: absent}
  loop: "{{ old.files }}"
```

## When to ignore it
When the file really has an asterisk in its name.

## References
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/file_module.html
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/find_module.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping

MODULES = frozenset("file copy template unarchive lineinfile blockinfile replace slurp fetch".split())
KEYS = ("path", "dest", "src", "name")
EXPRESSION = regex(r"\{\{[^{}]{0,400}\}\}|\{%[^{}%]{0,400}%\}")


@rule("error", silent="the file module finds nothing to remove, and the task is ok")
def task_glob(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("ansible"):
        if not source.judged or "*" not in source.text:
            continue
        for task in tasks(source):
            for module in task.modules:
                if module.name in MODULES and isinstance(module.settings, Mapping):
                    yield from _patterns(module.name, module.settings)


def _patterns(name: str, settings: Mapping) -> Iterator[Finding]:
    for key in KEYS:
        given = settings.scalar(key)
        if given is not None and "*" in EXPRESSION.sub("", given.value) and "/" in given.value:
            state = settings.scalar("state")
            removes = name == "file" and state is not None and state.value == "absent"
            yield finding(
                given.value,
                f"{name} expands no pattern: it looks for a file with this name, "
                + ("finds none, and removes nothing" if removes else "and the play stops here"),
                severity="warning" if removes else None,
                advice="find the files with the module find, or with_fileglob, and loop over them",
            )
