"""A script or play lets root log in over SSH.

## What it finds
`PermitRootLogin yes` or `PermitEmptyPasswords yes` that a script or an Ansible task writes into the configuration of
sshd with `sed`, `echo ... >>`, `lineinfile` or `replace`. Silent where the same file writes `no` later.

## Why it matters on a robot
Root is the one name that everybody knows, and its password is then all that is between the network and the motors, on
every robot that is set up so.

## Bad
```sh
sed -i 's/^#\\?PermitRootLogin.*/PermitRootLogin yes/' /etc/ssh/sshd_config
```

## Good
```sh
sed -i 's/^#\\?PermitRootLogin.*/PermitRootLogin no/' /etc/ssh/sshd_config
```

## When to ignore it
When something that is not in the script closes the access again.

## References
- sshd_config(5), "PermitRootLogin" and "PermitEmptyPasswords"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping

FILE = regex(r"(?:^|/)sshd_config(?:\.d/[^/]*)?$")
OPENS = regex(r"(?:^|(?<=\n)|(?<=\\n))[ \t]*(?P<key>PermitRootLogin|PermitEmptyPasswords)[ \t=]+yes\b")
REPLACED = regex(r"s(?P<mark>[/|#@,])(?:(?!(?P=mark)).)*(?P=mark)(?P<new>(?:(?!(?P=mark)).)*)")
CLOSES = r"{key}[ \t=]+(?:no|prohibit-password|without-password|forced-commands-only)\b"
MODULES = {"lineinfile": "line", "replace": "replace", "blockinfile": "block"}


@rule("error", tags=["CWE-250"], symptoms=["Failed password for root from"])
def ssh_opened(robot: Robot) -> Iterator[Finding]:
    for place, text in _changes(robot):
        opens = OPENS.search(text)
        if opens is not None and not _is_closed_again(place, opens["key"]):
            yield finding(
                place,
                "Everybody who knows the password of root may log in over SSH"
                if opens["key"] == "PermitRootLogin"
                else "Accounts without a password may log in over SSH",
                advice=f"write {opens['key']} no",
            )


def _is_closed_again(place: Located, key: str) -> bool:
    """Whether the same file closes later what it opens."""
    return re.compile(CLOSES.format(key=re.escape(key))).search(place.span.source.text, place.span.end) is not None


def _changes(robot: Robot) -> Iterator[tuple[Located, str]]:
    """The lines that scripts and plays put into the configuration of sshd, each with its place."""
    for _, run in robot.scripts.run("sed"):
        if any(map(FILE.search, run.arguments)) and any(word.startswith(("-i", "--in-place")) for word in run.words):
            for word in run.words[1:]:
                yield from ((word, match["new"]) for match in REPLACED.finditer(word))
    for _, did in robot.scripts.written("sshd_config"):
        if did.appends and FILE.search(did.path) and did.text is not None:
            yield did.where, str(did.text)
    for source in robot.of_kind("ansible"):
        if source.judged and "sshd_config" in source.text:
            for task in tasks(source):
                yield from _of_task(task.modules)


def _of_task(modules: Iterator[tuple[Located, object]]) -> Iterator[tuple[Located, str]]:
    for module, settings in modules:
        key = MODULES.get(module.rpartition(".")[2])
        if key is None or not isinstance(settings, Mapping):
            continue
        path = settings.scalar("path") or settings.scalar("dest")
        text = settings.scalar(key)
        state = settings.scalar("state")
        if state is not None and state.value == "absent":
            continue
        if path is not None and text is not None and FILE.search(path.value):
            yield text.value, str(text.value)
