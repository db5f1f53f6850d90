"""Tasks of Ansible write to /home/root.

## What it finds
`/home/{{ ansible_user }}` in the tasks of plays whose hosts are a group with `ansible_user: root`, by `group_vars` or
the `[group:vars]` of an inventory: in the playbook, and in the roles that the play names.

## Why it matters on a robot
The home folder of root is /root. `lineinfile` and `blockinfile` end the play with "Path /home/root/.bashrc does not
exist"; modules that make folders put the workspace where no login looks for it.

## Bad
```yaml
# group_vars/drone.yml: ansible_user: root
- ansible.builtin.lineinfile:
    path: /home/{{ ansible_user }}/.bashrc
    line: source /opt/ros/jazzy/setup.bash
```

## Good
```yaml
- ansible.builtin.lineinfile:
    path: "{{ ansible_user_dir }}/.bashrc"
    line: source /opt/ros/jazzy/setup.bash
```

## When to ignore it
When something makes /home/root on these hosts.

## References
- https://docs.ansible.com/ansible/latest/reference_appendices/special_variables.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import plays
from bringup_lint.api.shell import roles_of
from bringup_lint.api.yaml import Scalar

HOME = regex(r"/home/\{\{ ?ansible_user ?\}\}(?=[/\"'\s])")
OF_GROUP = regex(r"/group_vars/(?P<group>[^/.]+)(?:\.ya?ml|/[^/]+)?$")
ROOT = regex(r"(?m)^[ \t]*ansible_user[ \t]*[=:][ \t]*[\"']?(?P<user>root)\b")
SECTION = regex(r"(?m)^\[(?P<group>[^\]:\n]+):vars\][^\[]*?\n[ \t]*ansible_user[ \t]*=[ \t]*(?P<user>root)\b")
ROLE = regex(r"/roles/(?P<name>[^/]+)/(?:tasks|handlers)/")


@rule("warning", confidence="medium", symptoms=["Destination /home/root/.bashrc does not exist !"])
def home_of_root(robot: Robot) -> Iterator[Finding]:
    writing = [(each, match) for each in robot.of_kind("ansible") if (match := HOME.search(each.text)) and each.judged]
    groups = dict(_groups(robot)) if writing else {}
    if not groups:
        return
    roles: dict[str, Located] = {}
    for source in robot.of_kind("ansible"):
        for play in plays(source):
            hosts = play.get("hosts")
            user = groups.get(str(hosts.value)) if isinstance(hosts, Scalar) else None
            if user is not None:
                roles.update(dict.fromkeys(map(str, roles_of(play)), user))
                roles[source.name] = user
    for source, match in writing:
        role = ROLE.search(f"/{source.name}")
        user = roles.get(role["name"] if role is not None else source.name)
        if user is not None:
            yield finding(
                source.located(*match.span()),
                "ansible_user is root here, and /home/root does not exist: the home of root is /root",
                advice="write {{ ansible_user_dir }}",
                related=[note(user, "the user of these hosts")],
            )


def _groups(robot: Robot) -> Iterator[tuple[str, Located]]:
    """The groups whose user is root, each with the place that says it."""
    for source in robot.of_kind("ansible-vars"):
        group = OF_GROUP.search(f"/{source.name}")
        user = ROOT.search(source.text) if group is not None else None
        if group is not None and user is not None:
            yield group["group"], source.located(*user.span("user"))
        for match in SECTION.finditer(source.text):
            yield match["group"], source.located(*match.span("user"))
