"""A keyword that sshd no longer supports: the line does nothing.

## What it finds
A keyword that older releases of OpenSSH supported, and that current releases ignore with a message.

## Why it matters on a robot
The line protects nothing. It breaks nothing either.

## Bad
```
UsePrivilegeSeparation yes
```

## Good
```
# privilege separation is always on
```

## When to ignore it
When the same file is deployed to robots with an OpenSSH so old that it still needs the keyword.

## References
- OpenSSH release notes
- sshd: "Deprecated option UsePrivilegeSeparation"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import explained

TEXTS = {"deprecated": ("sshd no longer supports {where}: the line does nothing", "delete it")}


@rule("info", symptoms=["Deprecated option"])
def deprecated_option(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        yield from explained(sshd.problems, TEXTS)
