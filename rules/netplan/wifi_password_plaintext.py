"""A file contains a Wi-Fi password in clear text.

## What it finds
A literal password of an access point or of 802.1X in a repository:
- **warning**: a passphrase, or a key of 64 digits, which opens the network just as well.
- **info**: a file in a folder of examples.

Placeholders and templates are not reported. On the robot, netplan/file-mode checks who can read the file.

## Why it matters on a robot
The file is copied to every robot and kept in version control. Everyone with access to the repository can join
the robot's network, and a new password has to be set on every robot.

## Bad
```yaml
access-points:
  depot: {password: warehouse-7}
```

## Good
```yaml
access-points:
  depot: {password: "${DEPOT_PSK}"}     # filled in on the robot, mode 0600
```

## When to ignore it
If the network is a test network in the laboratory that gives access to nothing else, and the repository is
private.

## References
- robot-bringup guide, "Static IP Configuration"
- CWE-256, CWE-798
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.templates import is_example
from bringup_lint.api.templates import is_stand_in

KEY = "WPA key (the 64 hex digits are as good as the password)"


@rule("warning", silent="netplan reads the password where it is", tags=["CWE-256", "CWE-798"])
def wifi_password_plaintext(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for password in interface.passwords:
            source = password.span.source
            if not password or is_stand_in(password) or source.template or source.mode is not None:
                continue
            own = any(
                str(point.mode or "") == "ap" and password in point.passwords for point in interface.access_points
            )
            if own and not is_example(source.name):
                yield _of_access_point(password, interface.name)
                continue
            key = len(password) == 64 and all(char in "0123456789abcdefABCDEF" for char in password)
            yield finding(
                password,
                f"The {KEY if key else 'Wi-Fi password'} of {interface.name} is in the file in clear text",
                advice="keep it out of version control: write it on the robot, into a file with mode 0600",
                severity="info" if is_example(source.name) else None,
                secrets=[password],
            )


def _of_access_point(password: Located, interface: str) -> Finding:
    return finding(
        password,
        f"Every robot with this file opens a network on {interface} with a password that anybody can look up",
        advice="make a password for each robot at its first boot",
        secrets=[password],
    )
