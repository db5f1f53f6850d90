"""A oneshot service with Restart=always: systemd refuses the unit.

## What it finds
Type=oneshot with Restart=always or Restart=on-success, after all drop-ins.

## Why it matters on a robot
systemd refuses the whole unit: a oneshot service is complete when its process has exited successfully.

## Bad
```ini
[Service]
Type=oneshot
ExecStart=/usr/bin/robot-setup
Restart=always
```

## Good
```ini
[Service]
Type=oneshot
ExecStart=/usr/bin/robot-setup
Restart=on-failure
```

## When to ignore it
Never: systemd refuses the unit.

## References
- systemd.service(5), "Restart="
- journal: "Restart= set to either always or on-success, which isn't allowed for Type=oneshot services. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["which isn't allowed for Type=oneshot services"])
def oneshot_restart(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind, policy = unit.get("Type"), robot.units.restart(unit)
        if kind is not None and policy.refused:
            yield finding(
                policy.where,
                f"Type=oneshot does not allow Restart={policy.restart}: systemd refuses {unit.name}",
                advice="use Restart=on-failure, or Type=exec for a process that keeps running",
                related=[note(kind, "the type is set here")],
            )
