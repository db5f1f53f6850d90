"""A file with secrets is open to others.

## What it finds
In a root file system: environment files with secrets that others may read or the group may write, private
keys of SSH and SROS2 that group or others may read.

## Why it matters on a robot
Every account on the robot, also the one that the camera service runs under, can read the password or act as
the robot. sshd does not start with a host key that others may read.

## Bad
```ini
-rw-r--r-- root root /etc/robot/secrets.env
```

## Good
```ini
-rw-r----- root robot /etc/robot/secrets.env
```

## References
- sshd(8), "FILES"
- CWE-732
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-732"], symptoms=["Permissions 0644 for", "UNPROTECTED PRIVATE KEY FILE"])
def file_mode(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("ssh-private-key", "sros2-key"):
        if source.mode is not None and source.judged and source.mode & 0o077 and not is_group_of_keys(source):
            yield finding(
                source,
                f"{source.basename} is a private key, and others may read it (mode {source.mode:04o})",
                advice=f"chmod 600 {source.robot_path or source.name}",
            )
    told = set()
    for secret in robot.secrets:
        source = secret.value.span.source
        if secret.holder != "env-file" or source.name in told or source.mode is None or secret.sample:
            continue
        told.add(source.name)
        if source.mode & 0o027:
            yield finding(
                source,
                f"{source.basename} holds secrets, and others may read or change it (mode {source.mode:04o})",
                advice=f"chmod 640 {source.robot_path or source.name}, owned by root",
            )


def is_group_of_keys(source):
    """Keystores whose keys only the group of the nodes may read."""
    return source.kind == "sros2-key" and "/private/" not in source.name and not source.mode & 0o037
