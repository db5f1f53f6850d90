"""A netplan file is hidden by another one with the same name.

## What it finds
The same file name in two of netplan's folders. `/run/netplan` overrides `/etc/netplan`, which overrides
`/lib/netplan`.

## Why it matters on a robot
Netplan does not merge the hidden file but skips it as a whole. Whoever edits it sees no change.

## Bad
```
/run/netplan/10-robot.yaml
/etc/netplan/10-robot.yaml
```

## Good
```
/run/netplan/20-test.yaml
/etc/netplan/10-robot.yaml
```

## When to ignore it
If the file in /etc is meant to replace the one of a package in /lib: this is what the folders are for.

## References
- netplan-generate(8), "Handling multiple files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="netplan does not report files that another one replaces")
def file_shadowed(robot: Robot) -> Iterator[Finding]:
    for hidden, winner in robot.netplan.shadowed:
        yield finding(
            hidden.source,
            f"{winner.source.name} has the same name, so netplan does not read this file",
            advice="give one of them another name",
            related=[note(winner.source, "netplan reads this file")],
        )
