"""netplan reads only files whose names end in .yaml.

## What it finds
A file in a netplan folder whose name ends in `.yml`.

## Why it matters on a robot
Netplan looks for `*.yaml` and skips everything else without a message: the interface stays unconfigured, or
keeps the settings of another file.

## Bad
```
/etc/netplan/10-robot.yml
```

## Good
```
/etc/netplan/10-robot.yaml
```

## When to ignore it
If the file is disabled on purpose by its suffix.

## References
- netplan-generate(8), "Handling multiple files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="netplan does not read the file and does not report it")
def yml_suffix(robot: Robot) -> Iterator[Finding]:
    for source in robot.netplan.unread:
        yield finding(
            source,
            "netplan reads *.yaml only: this file is ignored",
            advice=f"rename it to {source.basename[:-4]}.yaml",
        )
