"""netplan reads only files that end in .yaml.

## What it finds
A file that ends in `.yml` in a netplan folder.

## Why it matters on a robot
Netplan looks for `*.yaml` and passes over everything else without a word: the interface stays unconfigured,
or keeps what another file says.

## Bad
```
/etc/netplan/10-robot.yml
```

## Good
```
/etc/netplan/10-robot.yaml
```

## References
- netplan-generate(8), "Handling multiple files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def yml_suffix(robot: Robot) -> Iterator[Finding]:
    for source in robot.netplan.unread:
        yield finding(
            source,
            "netplan reads *.yaml only: this file is ignored",
            advice=f"rename it to {source.basename[:-4]}.yaml",
        )
