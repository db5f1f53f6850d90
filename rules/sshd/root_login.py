"""Root may log in over SSH.

## What it finds
An effective `PermitRootLogin yes`. `prohibit-password`, also as the default, is an info.

## Why it matters on a robot
The name is known, so only the password is left to guess, and what gets in owns the robot. Nothing tells who
it was.

## Bad
```
PermitRootLogin yes
```

## Good
```
PermitRootLogin no
```

## References
- sshd_config(5), "PermitRootLogin"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", tags=["CWE-250"])
def root_login(robot: Robot):
    for sshd in robot.sshd:
        value = sshd.says("PermitRootLogin", "prohibit-password")
        option = sshd.get("PermitRootLogin")
        if (
            not sshd.files
            or value in (None, "no", "forced-commands-only")
            or (option and not option.span.source.judged)
        ):
            continue
        keys = "" if value == "yes" else " with a key"
        yield finding(
            option.value if option else sshd.where,
            f"Root may log in over SSH{keys}" + ("" if option else ": this is the default"),
            advice="PermitRootLogin no, and sudo for those who need it",
            fix=fix("PermitRootLogin no", (option.value, "no"), safe=value == "yes") if option else None,
            severity=None if value == "yes" else "info",
        )
