"""NetworkManager ignores a profile because of its owner or mode.

## What it finds
A profile in /etc/NetworkManager/system-connections that group or others can read or write, or that root does not own
although root owns the system around it. Only root file systems and running robots are checked, because a checkout
does not keep mode and owner.

## Why it matters on a robot
NetworkManager ignores such a file, because it may contain a password: the robot comes up without that network. Until
then, every user on the robot can read the passphrase.

## Bad
```ini
-rw-r--r-- root root depot.nmconnection
```

## Good
```ini
-rw------- root root depot.nmconnection
```

## When to ignore it
If the image build or an installer sets owner and mode later.

## References
- nm-settings-keyfile(5)
- CWE-732
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

FOLDER = "/etc/NetworkManager/system-connections/"


@rule("error", symptoms=["File permissions", "are insecure"], tags=["CWE-732"])
def file_mode(robot: Robot) -> Iterator[Finding]:
    for profile in robot.networkmanager.judged:
        source = profile.source
        path = source.robot_path or ""
        if source.mode is None or not path.startswith(FOLDER):
            continue
        readable = bool(source.mode & 0o077)
        foreign = source.uid not in (None, 0) and {each.uid for each in robot.of_kind("os-release")} == {0}
        if not readable and not foreign:
            continue
        why = f"its mode is {source.mode & 0o777:04o}" if readable else "root does not own it"
        secret = ", and others can read the password in it" if source.mode & 0o044 and any(profile.secrets) else ""
        yield finding(
            source,
            f"NetworkManager ignores {source.basename}: {why}{secret}",
            advice=f"chown root:root {path} && chmod 600 {path}",
        )
