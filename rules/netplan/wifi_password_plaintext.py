"""A Wi-Fi password stands in the file.

## What it finds
A literal password of an access point or of 802.1X. A 64-digit key is reported as info: it opens the network
as well as the passphrase does. Placeholders, templates and files in folders of examples are not the
password of a robot.

## Why it matters on a robot
The file is copied to every robot and lives in version control: everyone with the repository is in the robot
network, and changing the password means changing every robot.

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

## References
- robot-bringup guide, "Static IP Configuration"
- CWE-256, CWE-798
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.templates import is_example
from bringup_lint.api.templates import is_stand_in


@rule("warning", tags=["CWE-256", "CWE-798"])
def wifi_password_plaintext(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for password in interface.passwords:
            source = password.span.source
            if not password or is_stand_in(password) or source.template or source.mode is not None:
                continue
            key = len(password) == 64 and all(char in "0123456789abcdefABCDEF" for char in password)
            yield finding(
                password,
                f"The {'key' if key else 'password'} of {interface.name} stands in the file",
                advice="keep it out of version control: write it on the robot, into a file with mode 0600",
                severity="info" if key or is_example(source.name) else None,
                secrets=[password],
            )
