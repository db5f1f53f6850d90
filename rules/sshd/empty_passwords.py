"""Accounts without a password can log in over SSH.

## What it finds
`PermitEmptyPasswords yes`, for everyone or in a Match block.

## Why it matters on a robot
One account without a password, created for a demonstration, opens the robot to the whole network.

## Bad
```
PermitEmptyPasswords yes
```

## Good
```
PermitEmptyPasswords no
```

## When to ignore it
On an emulator or a test container that no network but its host's can reach. Never on a robot.

## References
- sshd_config(5), "PermitEmptyPasswords"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", tags=["CWE-258"], symptoms=["Accepted none for"])
def empty_passwords(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        first = sshd.get("PermitEmptyPasswords")
        for option in sshd.all("PermitEmptyPasswords"):
            counts = option is first or not option.everywhere
            if counts and option.value.lower() == "yes" and option.span.source.judged:
                yield finding(
                    option.value,
                    "Accounts without a password can log in",
                    advice="set PermitEmptyPasswords no",
                    fix=fix("set PermitEmptyPasswords no", (option.value, "no")),
                )
