"""A socket activates a service that does not exist.

## What it finds
A socket unit whose service is neither in the tree nor in the distribution. The service is the one in
Service=, otherwise the service of the same name, or its template with Accept=yes. It is an error in a
complete root file system, and a warning elsewhere.

## Why it matters on a robot
The socket does not start, or accepts connections that nobody ever serves.

## Bad
```ini
# robot-api.socket, while the service is robot-web.service
[Socket]
ListenStream=8080
```

## Good
```ini
[Socket]
ListenStream=8080
Service=robot-web.service
```

## When to ignore it
When another package ships the service.

## References
- systemd.socket(5), "Service=", "Accept="
- journal: "Socket service robot-api.service not loaded, refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["not loaded, refusing"])
def socket_missing_service(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "socket" or unit.fragment is None or unit.is_template or unit.uncertain:
            continue
        if robot.units.is_distribution_unit(unit.name):
            continue
        accept = unit.flag("Accept")
        named = unit.get("Service", "Socket")
        target = str(named or (f"{unit.stem}@.service" if accept else f"{unit.stem}.service"))
        if target.startswith("systemd-"):
            continue
        if (named is not None and unit.is_opaque(named)) or robot.units.exists(target, unit) is not False:
            continue
        yield finding(
            named or unit.where,
            f"{unit.name} activates {target}, which does not exist",
            advice="ship the service, or name the right one in Service=",
            severity=None if robot.tree.complete else "warning",
            confidence="high" if robot.tree.complete else "medium",
        )
