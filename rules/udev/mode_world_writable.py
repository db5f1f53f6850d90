"""Every user can write to a device node.

## What it finds
`MODE` with write permission for others, such as `0666` or `0777`. Device nodes that are open by design (null,
fuse, kvm, graphics) are not reported.

## Why it matters on a robot
Any process of any user, including a compromised web service, can drive the motor controller. `GROUP=` on the
same line does not restrict that.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", MODE="0666", GROUP="dialout"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", MODE="0660", GROUP="dialout"
```

## When to ignore it
If every process on the computer may use the device, for example a game pad of a demonstration robot with a
single user and no network services.

## References
- udev(7), MODE
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="safe", tags=["CWE-732"])
def mode_world_writable(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if line.is_open_by_design:
            continue
        for token in line.line.assignments("MODE"):
            if not re.fullmatch(r"0*[0-7]{1,4}", token.value) or not int(token.value, 8) & 0o002:
                continue
            grouped = line.line.first("GROUP") is not None
            yield finding(
                token.value,
                f"With mode {token.value} every user and service can write to the device"
                + ", so GROUP has no effect" * grouped,
                advice="write 0660" if grouped else "write 0660 and name the group that needs the device with GROUP=",
                fix=fix("let only the owner and the group write", (token.value, "0660"), safe=grouped),
            )
