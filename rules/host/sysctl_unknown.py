"""A kernel parameter that no kernel has.

## What it finds
A name in sysctl.conf or a file of sysctl.d, also one that a script or an Ansible task writes, in the folders
`net.core`, `net.ipv4`, `net.ipv6`, `vm`, `kernel`, `fs` and `fs.inotify`, that is misspelt, lacks its end, or belongs
to another of these folders. Names that are like none of Linux 4.19 to 6.18 are not judged.

## Why it matters on a robot
systemd-sysctl and sysctl report it and go on: "Couldn't write ..., ignoring: No such file or directory". The parameter
keeps its default after each boot: large messages are lost, or the robot forwards no packets.

## Bad
```ini
net.ipv4.rmem_max = 16777216
```

## Good
```ini
net.core.rmem_max = 16777216
```

## When to ignore it
When a module of its own brings the parameter.

## References
- sysctl.d(5)
- https://docs.kernel.org/admin-guide/sysctl/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "Couldn't write '*' to '*', ignoring: No such file or directory",
        "sysctl: cannot stat /proc/sys/*: No such file or directory",
    ],
)
def sysctl_unknown(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("sysctl"):
        return
    for setting, meant in robot.sysctl.unknown:
        source = setting.key.span.source
        if source.judged and not source.template and not setting.key.startswith("-"):
            yield finding(
                setting.key,
                f"No kernel has {setting.name}: the parameter that is meant keeps its default",
                advice=f"did you mean {meant}?",
            )
