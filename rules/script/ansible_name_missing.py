"""A play names a role, a handler, a file, a variable or hosts that do not exist.

## What it finds
In Ansible's playbooks and roles:
- a role of `roles:`, `include_role` or `import_role` of which no folder `roles/NAME` and no requirements file speaks;
- a handler of `notify:` that no handler of the tree is called, by its name or its `listen`;
- a file of `copy: src`, `template: src`, `include_tasks` or `import_tasks` that is not in the folders in which Ansible
  looks for it;
- a name of `hosts:` that the inventories of the tree lack and that one of their groups is nearly called;
- a variable that an expression such as `{{ base_ip }}` reads, where no file of the tree says its name otherwise: it
  stands in no inventory, default, command or guide. Only in trees with an inventory, and not where roles come from
  elsewhere or variables are encrypted;
- a plugin of `ansible_connection` or `connection` that neither Ansible nor a usual collection has.

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import missing_names

TEXTS = {
    "role": ("There is no role {}: the play does not start", "correct the name, or add the role"),
    "handler": ("No handler is called '{}': the play stops when this task changes something", "write its exact name"),
    "hosts": ("The inventory has no {}: the play is skipped, and its hosts get nothing", "did you mean {}?"),
    "connection": ("Ansible has no connection {}: it reaches no host that has it", "write ssh, or local"),
    "variable": ("Nothing gives {} a value: the play stops at this task", "set it in the defaults of the role"),
    "file": ("Ansible finds no {}: the play stops at this task", "correct the name, or add the file"),
}


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "the role * was not found in",
        "The requested handler * was not found",
        "Could not find or access",
        "The task includes an option with an undefined variable.",
        "the connection plugin '*' was not found",
        "Could not match supplied host pattern, ignoring:",
    ],
)
def ansible_name_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("ansible"):
        return
    found: dict[tuple[Source, str, str, str], list[Located]] = {}
    for missing in missing_names(robot.files, robot.of_kind("ansible")):
        where = missing.where
        found.setdefault((where.span.source, missing.what, str(where), missing.meant), []).append(where)
    for (_, what, name, meant), (first, *others) in found.items():
        message, advice = TEXTS[what]
        yield finding(
            first,
            message.format(name),
            advice=advice.format(meant),
            related=[note(other, "named here too") for other in others[:20]],
        )
