"""Automatic updates can reboot a running robot.

## What it finds
`Unattended-Upgrade::Automatic-Reboot` with `"true"` or another value that means yes.

## Why it matters on a robot
After a kernel update the robot reboots at once, in the middle of a mission, with powered motors.

## Bad
```
Unattended-Upgrade::Automatic-Reboot "true";
```

## Good
```
Unattended-Upgrade::Automatic-Reboot "false";
```

## When to ignore it
When `Automatic-Reboot-Time` is an hour at which the robot is always parked with its motors off.

## References
- unattended-upgrades, README
- robotics-security guide
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule

IF = regex(r"\{%-?[ \t]*if\b")
END = regex(r"\{%-?[ \t]*endif\b")
REBOOT = regex(r"^[ \t]*Unattended-Upgrade::Automatic-Reboot[ \t]+\"?(\w+)\"?[ \t]*;", re.M | re.I)


@rule("error", fix="unsafe", symptoms=["Found /var/run/reboot-required, rebooting"])
def apt_auto_reboot(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("apt-conf"):
        for match in REBOOT.finditer(source.text):
            value = source.located(match.start(1), match.end(1))
            if value.lower() in ("true", "1", "yes", "on", "with", "enable"):
                yield finding(
                    value,
                    "Automatic updates can reboot a running robot",
                    advice='write "false", and reboot when the robot is parked',
                    fix=fix("write false", (value, "false")),
                    severity="info" if _is_optional(source, match.start()) else None,
                )


def _is_optional(source: Source, at: int) -> bool:
    """Whether a condition of a template is open before a line, so that the line may be left out."""
    before = source.text[:at]
    return len(IF.findall(before)) > len(END.findall(before))
