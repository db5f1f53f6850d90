"""A default route is written as 0.0.0.0/0.

## What it finds
`to: 0.0.0.0/0` or `to: ::/0`.

## Why it matters on a robot
It works. `to: default` shows the intent, and a typing mistake in it is an error instead of a route to another
network.

## Bad
```yaml
routes: [{to: 0.0.0.0/0, via: 10.0.0.1}]
```

## Good
```yaml
routes: [{to: default, via: 10.0.0.1}]
```

## When to ignore it
If the robot runs Ubuntu 18.04 or 20.04, whose netplan may not know `default`.

## References
- netplan YAML reference, "Default routes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="safe", silent="netplan reads both forms")
def route_to_default_old(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for route in interface.routes:
            to = route.value("to")
            if to in ("0.0.0.0/0", "::/0"):
                family_known = route.value("via") is not None
                change = fix("write default", (to, "default")) if family_known else None
                yield finding(to, f"'to: {to}' is the default route", advice="write 'to: default'", fix=change)
