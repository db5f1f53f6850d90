"""A task of Ansible needs root and does not ask for it.

## What it finds
Tasks that install packages, manage services or accounts, or write below `/etc`, `/usr`, `/lib` and `/boot`, without
`become`, in a file in which most of such tasks have `become: true` of their own. All of a file are one finding. The
tree has to hold the plays. It is info where the tasks only see to it that a folder is there which every Linux has, or
which an earlier task of the file makes as root: it needs no root while the folder is as the task wants it.

Silent if the tree gives the right in another way: `become` in a play, a role's entry or an include, `ansible_become` or
`ansible_user=root` in the inventory, `become` in `ansible.cfg`, and `ansible-playbook --become` in a script or in the
README. Silent, too, for tasks in check mode, with expected failures, on other hosts, and of the user's own services.

## Why it matters on a robot
The play ends here with "Permission denied", in the middle of the set-up: the services of the robot that come after it
are never installed.

## Bad
```yaml
- name: Install chrony
  ansible.builtin.apt: {name: chrony}
  become: true
- name: Configure chrony
  ansible.builtin.template: {src: chrony.conf.j2, dest: /etc/chrony/chrony.conf}
```

## Good
```yaml
- name: Install chrony
  ansible.builtin.apt: {name: chrony}
  become: true
- name: Configure chrony
  ansible.builtin.template: {src: chrony.conf.j2, dest: /etc/chrony/chrony.conf}
  become: true
```

## When to ignore it
When the role is only run as root, for example in the build of an image.

## References
- Ansible, "Understanding privilege escalation: become"
"""

import itertools
import re
from collections.abc import Iterable
from collections.abc import Iterator

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

ALWAYS = frozenset(
    "apt apt_key apt_repository package dnf user group hostname timezone modprobe sysctl mount ufw".split()
)
SERVICES = frozenset({"systemd", "systemd_service", "service"})
CHANGES = ("state", "enabled", "masked", "daemon_reload", "daemon_reexec")
FILES = frozenset({"copy", "template", "file", "lineinfile", "blockinfile", "get_url", "unarchive", "replace"})
OF_ROOT = regex(r"/(?:etc|usr|lib|boot)/")
FOLDERS = frozenset(
    "/etc /etc/apt /etc/apt/apt.conf.d /etc/apt/keyrings /etc/apt/preferences.d /etc/apt/sources.list.d /etc/cron.d "
    "/etc/cron.daily /etc/default /etc/init.d /etc/logrotate.d /etc/modprobe.d /etc/modules-load.d /etc/profile.d "
    "/etc/security /etc/security/limits.d /etc/skel /etc/ssh /etc/ssl /etc/ssl/certs /etc/sudoers.d /etc/sysctl.d "
    "/etc/systemd /etc/systemd/network /etc/systemd/system /etc/systemd/user /etc/tmpfiles.d /etc/udev "
    "/etc/udev/rules.d /usr/bin /usr/lib /usr/lib/systemd /usr/lib/systemd/system /usr/local /usr/local/bin "
    "/usr/local/etc /usr/local/include /usr/local/lib /usr/local/sbin /usr/local/share /usr/local/src /usr/sbin "
    "/usr/share /usr/share/keyrings /usr/src /lib/firmware /lib/modules /lib/systemd /lib/systemd/system /lib/udev "
    "/lib/udev/rules.d /boot/dtb /boot/efi /boot/firmware /boot/grub /boot/overlays".split()
)
"""Those that Debian, Ubuntu or the image of a board brings."""
USUAL = {"mode": ("0755",), "owner": ("root",), "group": ("root",), "recurse": ("false", "no")}
"""What these folders have, so that a task which asks for it changes nothing."""
LEAST = 2
"""Tasks of the file that ask for root."""
EXCUSES = ("ignore_errors", "failed_when", "delegate_to", "check_mode", "connection", "remote_user")
MOST_FILES = 2000
HOSTS = regex(r"^-?[ \t]*hosts[ \t]*:", re.M)
GIVEN = regex(
    r"\bansible_become\b|\bansible_(?:ssh_)?user[\"']?[ \t]*[=:][ \t]*[\"']?root\b"
    r"|^[ \t]*(?:become[ \t]*=[ \t]*(?:true|yes|1)|remote_user[ \t]*=[ \t]*root)\b",
    re.M | re.I,
)
CALLED = regex(
    r"\bsudo[ \t]{1,9}(?:-\S{1,40}[ \t]{1,9}){0,9}ansible-playbook\b"
    r"|\bansible-playbook\b(?:\\\r?\n|[^\n|;&\\]){0,400}?[ \t]"
    r"(?:-\w{0,20}b\w{0,20}|--become|-u[ \t]*root|--user[= ]root)(?=[ \t\r\n`\"']|$)"
)


@rule("warning", confidence="medium", symptoms=["Could not open lock file /var/lib/dpkg/lock-frontend", "not writable"])
def become_missing(robot: Robot) -> Iterator[Finding]:
    sources = [source for source in robot.of_kind("ansible") if source.judged and "become" in source.text]
    found = [each for source in sources for each in _of_file(source)]
    if found and not _is_given_elsewhere(robot):
        yield from found


def _of_file(source: Source) -> Iterator[Finding]:
    needing = [(each, module) for each in tasks(source) if (module := _module_of_root(each)) is not None]
    asking = [module for each, module in needing if each.own_become]
    without = [(each, module) for each, module in needing if each.become is None and not _is_excused(each)]
    if len(asking) >= LEAST and len(asking) > len(without) > 0:
        first, *others = (module for _, module in without)
        only_folders = all(_finds_folder(each, [by for by, _ in needing]) for each, _ in without)
        when = "where the folder is not there yet" if only_folders else "with a denied permission"
        yield finding(
            first,
            f"This {first.rpartition('.')[2]} task runs without root: the play stops here {when}",
            advice="write become: true, as the other tasks of this file do",
            related=[note(asking[0], "this task asks for root"), *(note(other, "and this one") for other in others)],
            severity="info" if only_folders else None,
        )


def _is_given_elsewhere(robot: Robot) -> bool:
    """Whether something around the tasks may make them root."""
    found = [play for source in _playbooks(robot) for play in plays(source)]
    if not found or any(play.get("become") is not None or play.get("remote_user") is not None for play in found):
        return True
    if any(_entry_asks(each) for play in found for each in play.sequence("roles") or ()):
        return True
    if any(each.includes and each.become for source in robot.files.of_kind("ansible") for each in tasks(source)):
        return True
    texts = [source.text for source in robot.files.of_kind("ansible-vars")]
    texts += [source.text for name in ("ansible.cfg", ".ansible.cfg") for source in _named(robot, name)]
    if any(GIVEN.search(text) for text in texts):
        return True
    callers = [source for source in robot.of_kind("shell-script") if source.judged]
    return any(CALLED.search(source.text) for source in [*callers, *_named(robot, "README.md")])


def _playbooks(robot: Robot) -> Iterator[Source]:
    """The files that hold plays, wherever they are."""
    paths = (path for path in robot.tree.paths if path.endswith((".yml", ".yaml")))
    for path in itertools.islice(paths, MOST_FILES):
        source = robot.tree.read(path, judged=False)
        if source is not None and HOSTS.search(source.text):
            yield source


def _entry_asks(entry: Node) -> bool:
    return isinstance(entry, Mapping) and entry.get("become") is not None


def _named(robot: Robot, name: str) -> Iterator[Source]:
    yield from filter(None, map(robot.tree.read, robot.tree.named(name)))


def _module_of_root(task: Task) -> Located | None:
    """The module of a task that only root may do."""
    for module in task.modules:
        name, settings = module.name, module.settings
        if not isinstance(settings, Mapping) or (settings.get("name") is None and name in ("user", "group")):
            continue
        if name in ALWAYS or (name in SERVICES and _changes(settings) and _scope(settings) in ("", "system")):
            return module.key
        path = settings.scalar("dest") or settings.scalar("path")
        if name in FILES and path is not None and OF_ROOT.match(path.value):
            return module.key
    return None


def _finds_folder(task: Task, others: Iterable[Task]) -> bool:
    """Whether all that a task does is to see to it that a folder is there, as it surely is already."""
    wanted = list(_folders(task))
    earlier = itertools.takewhile(lambda each: each is not task, others)
    made = {path for each in earlier if each.own_become and not each.conditional for path, _ in _folders(each)}
    return bool(wanted) and all(usual and (path in FOLDERS or path in made) for path, usual in wanted)


def _folders(task: Task) -> Iterator[tuple[str, bool]]:
    """The folders that a task makes, each with whether it asks for no other owner and mode than folders of the system
    have."""
    for module in task.modules:
        settings = module.settings
        if module.name == "file" and isinstance(settings, Mapping):
            state, path = settings.scalar("state"), settings.scalar("path") or settings.scalar("dest")
            if state is not None and state.value == "directory" and path is not None:
                asked = ((settings.scalar(key), usual) for key, usual in USUAL.items())
                yield path.value.rstrip("/"), all(each is None or each.value in usual for each, usual in asked)


def _changes(settings: Mapping) -> bool:
    """Whether a service is changed: without these, the module only asks for its state."""
    return any(settings.get(key) is not None for key in CHANGES)


def _scope(settings: Mapping) -> str:
    scope = settings.scalar("scope")
    return "" if scope is None else str(scope.value)


def _is_excused(task: Task) -> bool:
    when = task.keys.get("when")
    of_root = isinstance(when, Scalar) and "root" in when.value
    return of_root or any(task.keys.get(key) is not None for key in EXCUSES)
