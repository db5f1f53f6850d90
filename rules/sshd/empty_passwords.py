"""Accounts without a password can log in over SSH.

## What it finds
`PermitEmptyPasswords yes`, for everyone or in a Match block.

## Why it matters on a robot
One account that was made without a password, for a demonstration, opens the robot to the whole network.

## Bad
```
PermitEmptyPasswords yes
```

## Good
```
PermitEmptyPasswords no
```

## References
- sshd_config(5), "PermitEmptyPasswords"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", tags=["CWE-258"])
def empty_passwords(robot: Robot):
    for sshd in robot.sshd:
        first = sshd.get("PermitEmptyPasswords")
        for option in sshd.all("PermitEmptyPasswords"):
            counts = option is first or not option.everywhere
            if counts and option.value.lower() == "yes" and option.span.source.judged:
                yield finding(
                    option.value,
                    "Accounts without a password can log in",
                    advice="PermitEmptyPasswords no",
                    fix=fix("PermitEmptyPasswords no", (option.value, "no")),
                )
