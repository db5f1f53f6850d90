"""Ansible looks for a file of the robot on the computer that runs it.

## What it finds
The modules copy and unarchive with an absolute `src` and without `remote_src`, where that file is one of the robot: an
earlier task of the same file puts it there, or the copy is a backup beside it in `/etc`, `/boot`, `/usr`, `/var` or
`/opt`. Only in trees whose inventory has other hosts (`ansible_host`, `ansible_port` and the like), and not in plays
for localhost.

## Why it matters on a robot
`src` is a path of the computer that runs Ansible. If the file is there too, the robot gets that one: the "backup" of
its chrony.conf is the laptop's. Otherwise the play stops here.

## Bad
```yaml
- name: Keep the old configuration
  ansible.builtin.copy: {src: /etc/chrony/chrony.conf, dest: /etc/chrony/chrony.conf.orig}
```

## Good
```yaml
- name: Keep the old configuration
  ansible.builtin.copy: {src: /etc/chrony/chrony.conf, dest: /etc/chrony/chrony.conf.orig, remote_src: true}
```

## When to ignore it
When the file of the computer that runs Ansible is meant.

## References
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/copy_module.html, "remote_src"
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import plays
from bringup_lint.api.shell import roles_of
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar

READING = frozenset(("copy", "unarchive"))
WRITING = frozenset(("copy", "template", "get_url"))
OF_SYSTEM = regex(r"/(?:etc|boot|usr|var|opt)/")
OTHER_HOSTS = regex(r"\bansible_(?:ssh_)?(?:host|port|pass(?:word)?|private_key_file)[ \t]*[:=]")
READS = regex(r"\bsrc[ \t]*[:=][ \t]*[\"']?/")
ROLE = regex(r"/roles/(?P<name>[^/]+)/")
LOCAL = ("localhost", "127.0.0.1")
ELSEWHERE = ("delegate_to", "local_action", "connection")


@rule("warning", confidence="medium", symptoms=["Could not find or access * on the Ansible Controller."])
def controller_file(robot: Robot) -> Iterator[Finding]:
    sources = [each for each in robot.of_kind("ansible") if each.judged and READS.search(each.text)]
    if not sources or not any(OTHER_HOSTS.search(each.text) for each in robot.of_kind("ansible-vars")):
        return
    users = _users(robot)
    for source in sources:
        if not _is_local(source, users):
            yield from _of_file(source)


def _of_file(source: Source) -> Iterator[Finding]:
    made: dict[str, Located] = {}
    for task in tasks(source):
        if any(task.keys.get(key) is not None for key in ELSEWHERE):
            continue
        for module in task.modules:
            if not isinstance(module.settings, Mapping):
                continue
            if module.name in READING:
                yield from _wrong(module.settings, made)
            dest = module.settings.scalar("dest")
            if module.name in WRITING and dest is not None:
                made[_target(module.settings, dest.value)] = dest.value


def _target(settings: Mapping, dest: str) -> str:
    """The path of the file that a task writes: a folder as its dest gets the name that the file has."""
    url = settings.scalar("url")
    return dest + posixpath.basename(url.value) if dest.endswith("/") and url is not None else dest


def _wrong(settings: Mapping, made: dict[str, Located]) -> Iterator[Finding]:
    src, dest = settings.scalar("src"), settings.scalar("dest")
    if src is None or dest is None or not src.value.startswith("/") or settings.get("remote_src") is not None:
        return
    before = made.get(src.value)
    if before is not None:
        yield _finding(src.value, before, "the robot has it from here")
    elif OF_SYSTEM.match(src.value) and posixpath.split(src.value)[0] == posixpath.split(dest.value)[0] != "":
        if dest.value != src.value:
            yield _finding(src.value, dest.value, "kept beside it, on the robot")


def _finding(src: Located, other: Located, text: str) -> Finding:
    return finding(
        src,
        f"{src} is looked for on the computer that runs Ansible, not on the robot",
        advice="write remote_src: true",
        related=[note(other, text)],
    )


def _users(robot: Robot) -> dict[str, bool]:
    """The roles that plays name, and an empty name for all plays -> whether they are all for the computer that runs
    Ansible."""
    found: dict[str, bool] = {}
    for play in (play for each in robot.files.of_kind("ansible") for play in plays(each)):
        is_local = _is_for_local(play)
        for name in {"", *map(str, roles_of(play))}:
            found[name] = found.get(name, True) and is_local
    return found


def _is_local(source: Source, users: dict[str, bool]) -> bool:
    """Whether all plays that use a file are for the computer that runs Ansible."""
    own = plays(source)
    role = ROLE.search(f"/{source.name}")
    return all(map(_is_for_local, own)) if own else users.get("" if role is None else role["name"], False)


def _is_for_local(play: Mapping) -> bool:
    hosts, connection = play.get("hosts"), play.scalar("connection")
    return (isinstance(hosts, Scalar) and hosts.value in LOCAL) or (
        connection is not None and connection.value == "local"
    )
