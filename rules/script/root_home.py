"""A script or task that root runs writes to the login file of root.

## What it finds
`~/.bashrc`, `~/.profile` and the like (also with `$HOME`) that a set-up script writes to, where the script runs as
root: it asks for it (`$EUID`, `id -u`), or says in a comment or its usage that it is called with `sudo`, or installs
packages and writes to /etc without `sudo`. Only where the robot has a user of its own, by the script or by `User=` of a
unit.

Also tasks of Ansible with `become: true` that write to `~/.bashrc` and the like, themselves or by `item` of their loop.
Silent with `become_user` or `ansible_become`, where the file writes the home of a user, too, where hosts, `ansible.cfg`
or a call name root or another user, and where only images are built with Ansible.

## Why it matters on a robot
With sudo, `~` is /root. The shells of the robot's user know nothing of ROS, of the workspace and of the domain:
commands that people type on the robot fail or see no topic, while the services run.

## Bad
```sh
# usage: sudo ./provision.sh
adduser --disabled-password rover
echo "source /opt/ros/jazzy/setup.bash" >> ~/.bashrc
```

## Good
```sh
# usage: sudo ./provision.sh
adduser --disabled-password rover
echo "source /opt/ros/jazzy/setup.bash" >> /home/rover/.bashrc
```

## When to ignore it
When people log in as root.

## References
- sudo(8), sudoers(5), "always_set_home" and "set_home"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Task
from bringup_lint.api.shell import Written
from bringup_lint.api.shell import plays
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar

LOGIN = regex(r"(?:~|\{\{ HOME \}\})/\.(?:bashrc|bash_profile|bash_aliases|profile|zshrc)")
ASKS = regex(r"(?:\bEUID\b|\bid[ \t]+-u\b)[^\n]{0,60}(?:-ne|!=|-gt)[ \t]*[\"']?0")
REFUSES = regex(r"(?:(?!\b(?:fi|else|sudo[ \t]+[^\n]{0,20}\$(?:0|\{?BASH_SOURCE)))[\s\S]){0,300}?\bexit\b")
"""Up to the end of the branch; a script that calls itself again with sudo goes on in another process."""
OTHER_HOME = regex(r"\bSUDO_USER\b|^[ \t]*(?:export[ \t]+)?HOME=|\bsudo[ \t]+(?:-\w+[ \t]+)*-u\b|\bsu[ \t]+-", re.M)
INSTALLERS = ("apt", "apt-get")
ADDS = ("useradd", "adduser")
WRITERS = frozenset(("lineinfile", "blockinfile", "copy", "template", "replace"))
OF_TASK = regex(r"(?:~|\$HOME|\$\{HOME\})/\.(?:bashrc|bash_profile|bash_aliases|profile|zshrc)")
ITEM = regex(r"\{\{[ \t]*item[ \t]*\}\}")
OTHER_USER = regex(
    r"\b(?:ansible_)?become_user[ \t]*[:=](?![ \t]*root\b)|\bansible_become[ \t]*[:=]|\bbecome[ \t]*:[ \t]*[\"']?\{\{"
    r"|\bHOME[ \t]*:"
)
"""Who the task runs as is decided otherwise."""
OF_USER = regex(r"(?:/home/[^/\s\"']{1,60}|\}\})/\.(?:bashrc|bash_profile|bash_aliases|profile|zshrc)")
ROOT_HOSTS = regex(
    r"\b(?:ansible_(?:ssh_)?user|remote_user)[\"']?[ \t]*[=:][ \t]*[\"']?root\b"
    r"|\b(?:ansible_)?become_user[\"']?[ \t]*=|\bansible_become(?:_user)?[\"']?[ \t]*[=:]"
)
ROOT_CALLS = regex(
    r"\bansible-p(?:laybook|ull)\b[^\n]{0,200}(?:[ \t]-u[ \t]*root\b|--user[ =]root\b|--become-user|-e[ \t])"
)
CONFIGURED = regex(r"^[ \t]*(?:remote_user[ \t]*=[ \t]*root\b|become_user[ \t]*=)", re.M)
PLAYBOOK = regex(r"\bansible-p(?:laybook|ull)\b")


@rule("warning", confidence="medium", silent="the script succeeds; only the user's shell lacks the lines")
def root_home(robot: Robot) -> Iterator[Finding]:
    yield from _of_scripts(robot)
    found = [each for source in robot.of_kind("ansible") if source.judged for each in _of_tasks(source)]
    if found and not _is_of_root(robot):
        yield from found


def _of_scripts(robot: Robot) -> Iterator[Finding]:
    has_user: bool | None = None
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or OTHER_HOME.search(source.text):
            continue
        did = robot.scripts.done(source)
        written = [each for each in did if isinstance(each, Written) and LOGIN.match(each.path)]
        if not written or not _is_root(source, did):
            continue
        if has_user is None:
            has_user = _has_user(robot)
        if not has_user and not _adds_user(did):
            continue
        if robot.scripts.is_for_image(source):  # root is the only user there
            continue
        first, *others = written
        yield finding(
            first.where,
            f"Root runs this script, so that {first.where} is the login file of root: the robot's user never reads it",
            advice="write the home of the user, or a file in /etc/profile.d",
            related=[note(other.where, "this, too") for other in others[:5]],
        )


def _is_root(source: Source, did: list[Run | Written]) -> bool:
    """Whether the script runs as root: it says so, or does throughout what only root may do."""
    asks = ASKS.search(source.text)
    if (asks and REFUSES.match(source.text, asks.end())) or _is_called_with_sudo(source):
        return True
    if "sudo" in source.text:
        return False
    installs = any(isinstance(each, Run) and each.name in INSTALLERS and "install" in each.words for each in did)
    writes = any(isinstance(each, Written) and each.path.startswith("/etc/") and not each.refused for each in did)
    copies = any(
        isinstance(each, Run) and each.name in ("cp", "install") and each.arguments[-1:] and _is_etc(each)
        for each in did
    )
    return installs and (writes or copies)


def _is_called_with_sudo(source: Source) -> bool:
    """Whether a comment of the script, or the usage that it prints, says that it is called so."""
    name = rf"(?:{re.escape(source.basename)}|\$0)"
    command = rf"sudo[ \t]+(?:bash[ \t]+)?\S{{0,60}}{name}(?![^\s\"'])"
    called = rf"[^\n]{{0,80}}\b{command}"
    return re.search(rf"^(?:#{called}|[^\n]{{0,60}}\b[Uu]sage:[ \t]*{command})", source.text, re.M) is not None


def _is_etc(run: Run) -> bool:
    return run.arguments[-1].startswith("/etc/")


def _adds_user(did: list[Run | Written]) -> bool:
    return any(isinstance(each, Run) and each.name in ADDS and len(each.words) > 1 for each in did)


def _has_user(robot: Robot) -> bool:
    """Whether a service runs as somebody else than root."""
    users = (unit.identity.user for unit in robot.units.services if unit.fragment is not None)
    return any(user is not None and user not in ("root", "0") for user in users)


def _of_tasks(source: Source) -> Iterator[Finding]:
    """What the tasks of a file write as root to the login file of whoever they run as."""
    if "become" not in source.text or not OF_TASK.search(source.text):
        return
    if OTHER_USER.search(source.said) or OF_USER.search(source.said):
        return
    written = [place for task in tasks(source) if task.become and (place := _login_file(task)) is not None]
    if written:
        first, *others = written
        yield finding(
            first,
            f"With become, {first} is the login file of root: the user of the robot never reads it",
            advice="write become: false in this task, or the home of the user",
            related=[note(other, "this, too") for other in others[:5]],
        )


def _login_file(task: Task) -> Located | None:
    """The login file that a task writes to."""
    for module in task.modules:
        if module.name not in WRITERS or not isinstance(module.settings, Mapping):
            continue
        path = module.settings.scalar("path") or module.settings.scalar("dest")
        state = module.settings.scalar("state")
        if path is None or (state is not None and state.value == "absent"):
            continue
        if OF_TASK.fullmatch(path.value):
            return path.value
        items = (task.keys.sequence("loop") or task.keys.sequence("with_items")) if ITEM.fullmatch(path.value) else None
        for item in items or ():
            if isinstance(item, Scalar) and OF_TASK.fullmatch(item.value):
                return item.value
    return None


def _is_of_root(robot: Robot) -> bool:
    """Whether the tasks may be meant for root, or run as somebody else: in images, or by the inventory."""
    sources = robot.files.of_kind("ansible", "ansible-vars")
    if any(ROOT_HOSTS.search(source.said) for source in sources):
        return True
    if any(play.get("become_user") is not None for source in robot.files.of_kind("ansible") for play in plays(source)):
        return True
    if any(CONFIGURED.search(robot.tree.head(path, 64 * 1024)) for path in robot.tree.named("ansible.cfg")):
        return True
    called = [each for each in robot.files.of_kind("dockerfile", "shell-script") if PLAYBOOK.search(each.said)]
    images = [each for each in called if each.kind == "dockerfile" or robot.scripts.is_for_image(each)]
    return any(ROOT_CALLS.search(each.said) for each in called) or (bool(images) and len(images) == len(called))
