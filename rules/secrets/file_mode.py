"""Other users can read a file with secrets.

## What it finds
In a root file system: environment files with secrets that others can read or change, and private keys of SSH and SROS2
that the group or others can read.

## Why it matters on a robot
Every account on the robot, including the one of the camera service, can read the password or impersonate the robot.
sshd does not start with a host key that others can read.

## Bad
```ini
-rw-r--r-- root root /etc/robot/secrets.env
```

## Good
```ini
-rw-r----- root robot /etc/robot/secrets.env
```

## When to ignore it
When the values are examples, or the key is a test key that opens nothing.

## References
- sshd(8), "FILES"
- CWE-732
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-732"], symptoms=["Permissions * for * are too open.", "UNPROTECTED PRIVATE KEY FILE"])
def file_mode(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("ssh-private-key", "sros2-key"):
        if source.mode is not None and source.judged and source.mode & 0o077 and not is_told(robot, source):
            yield finding(
                source,
                f"{source.basename} is a private key, and others can read it (mode {source.mode:04o})",
                advice=f"chmod 600 {source.robot_path or source.name}",
            )
    told = set()
    for secret in robot.secrets:
        source = secret.value.span.source
        if secret.holder != "env-file" or source.name in told or source.mode is None or secret.sample:
            continue
        told.add(source.name)
        yield finding(
            source,
            f"{source.basename} contains secrets, and others can read or change it (mode {source.mode:04o})",
            advice=f"chmod 640 {source.robot_path or source.name}, owned by root",
        )


def is_told(robot: Robot, source: Source) -> bool:
    """Whether the mode of a key is right, or sros2/key-permissions says what it lets others do."""
    if source.kind != "sros2-key" or source.mode is None:
        return False
    authority = "/private/" in f"/{source.name}"
    return is_group_of_keys(source) or (robot.tree.complete and bool(source.mode & (0o077 if authority else 0o007)))


def is_group_of_keys(source: Source) -> bool:
    """Keystores whose keys only the group of the nodes can read."""
    of_group = source.mode is not None and not source.mode & 0o037
    return of_group and source.kind == "sros2-key" and "/private/" not in source.name
