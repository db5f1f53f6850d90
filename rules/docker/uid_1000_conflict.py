"""uid 1000 is already taken by the user 'ubuntu'.

## What it finds
`useradd -u 1000` or `groupadd -g 1000` on an image based on Ubuntu 23.04 or later (ros:jazzy and later), unless the
user `ubuntu` is removed or changed first, or `-o` allows the same id twice.

## Why it matters on a robot
Since 23.04 the Ubuntu image has a user `ubuntu` with uid and gid 1000. A build that worked for Humble stops with
`UID 1000 is not unique`.

## Bad
```dockerfile
FROM ros:jazzy
RUN useradd -u 1000 -m robot
```

## Good
```dockerfile
FROM ros:jazzy
RUN userdel -r ubuntu && useradd -u 1000 -m robot
```

## When to ignore it
When the base image is your own rebuild without the user `ubuntu`, under the name of the official one.

## References
- https://bugs.launchpad.net/cloud-images/+bug/2005129
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.ros import distros_since
from bringup_lint.api.shell import Command

UBUNTU_24 = regex(
    r"(?:^|/)(?:ubuntu:(?:2[3-9]\.|noble|questing|plucky|resolute|latest)|ubuntu$"
    rf"|(?:osrf/)?ros:(?:{'|'.join(distros_since('jazzy'))})\b)"
)
OPTIONS = {
    "useradd": ("-u", "--uid", "UID"),
    "adduser": ("", "--uid", "UID"),
    "groupadd": ("-g", "--gid", "GID"),
}


@rule("warning", symptoms=["UID * is not unique", "GID '*' already exists"])
def uid_1000_conflict(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            if not UBUNTU_24.search(stage.origin):
                continue
            for command in commands_of(stage):
                if command.name in ("userdel", "deluser", "usermod", "groupmod") and "ubuntu" in command.words:
                    break
                word = _takes_1000(command)
                if word is not None:
                    kind = OPTIONS[command.name][2]
                    yield finding(
                        word,
                        f"{kind} 1000 is taken by 'ubuntu' in {stage.origin}: the build stops",
                        advice="remove that user first (userdel -r ubuntu), or use another id",
                    )


def _takes_1000(command: Command) -> Located | None:
    if command.name not in OPTIONS or {"-o", "--non-unique"} & set(command.words):
        return None
    short, long, _ = OPTIONS[command.name]
    for before, word in zip(command.words, command.words[1:], strict=False):
        if before in (short, long) and word == "1000":
            return word
    return next((word for word in command.words if word in (f"{long}=1000", f"{short}1000") and short), None)
