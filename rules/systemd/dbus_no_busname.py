"""A D-Bus service without BusName=: systemd refuses the unit.

## What it finds
A service with Type=dbus and no BusName=, after all drop-ins.

## Why it matters on a robot
systemd needs the bus name to know when the service is ready. Without it, systemd refuses the whole unit.

## Bad
```ini
[Service]
Type=dbus
ExecStart=/usr/bin/robot-battery
```

## Good
```ini
[Service]
Type=dbus
BusName=org.example.Battery
ExecStart=/usr/bin/robot-battery
```

## When to ignore it
Never: systemd does not load the unit.

## References
- systemd.service(5), "BusName="
- journal: "Service is of type D-Bus but no D-Bus service name has been specified. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["no D-Bus service name has been specified"])
def dbus_no_busname(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind = unit.get("Type")
        if kind == "dbus" and unit.fragment and not unit.uncertain and not unit.has("BusName"):
            yield finding(kind, f"Type=dbus without BusName=: systemd refuses {unit.name}", advice="add BusName=")
