"""Root may log in over SSH.

## What it finds
An effective `PermitRootLogin yes`. `prohibit-password`, which is also the default, is an info.

## Why it matters on a robot
The user name is known, so that only the password is left to guess. Whoever gets in controls the whole robot,
and no log shows who it was.

## Bad
```
PermitRootLogin yes
```

## Good
```
PermitRootLogin no
```

## When to ignore it
When an image has no account but root, or a fleet tool logs in as root with a key and a restricted command.

## References
- sshd_config(5), "PermitRootLogin"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", tags=["CWE-250"], symptoms=["Failed password for root from"])
def root_login(robot: Robot) -> Iterator[Finding]:
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
            advice="set PermitRootLogin no, and give sudo to those who need it",
            fix=fix("set PermitRootLogin no", (option.value, "no"), safe=value == "yes") if option else None,
            severity=None if value == "yes" else "info",
        )
