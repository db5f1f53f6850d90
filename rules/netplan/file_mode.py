"""Other users can read or write a netplan file.

## What it finds
A netplan file in /etc or /run with permissions for group or others. Only root file systems and running robots
are checked, because a checkout does not keep the mode.
- **error**: the file contains a password or a private key.
- **warning**: any other file.

## Why it matters on a robot
Every user who logs in can read the password of the robot's network. Netplan 0.106 and later print a warning
at every run.

## Bad
```
-rw-r--r-- root root /etc/netplan/10-robot.yaml
```

## Good
```
-rw------- root root /etc/netplan/10-robot.yaml
```

## When to ignore it
If the mode in the tree is not the mode on the robot, because the image build or an installer sets it.

## References
- netplan security guidance, "Permissions for … are too open"
- CWE-732
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["are too open. Netplan configuration should NOT be accessible by others"],
    tags=["CWE-732"],
)
def file_mode(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        secrets = {secret.path for interface in plan.interfaces.values() for secret in interface.secrets}
        for file in plan.files:
            source = file.source
            if source.mode is None or not source.mode & 0o077 or not plan.whole or "lib" in source.name.split("/"):
                continue
            holds = source.name in secrets
            yield finding(
                source,
                f"Other users can access {source.basename}" + (" and the password in it" if holds else ""),
                advice=f"chmod 600 {source.robot_path or source.name}",
                severity="error" if holds else None,
            )
