"""A service counts as active after its process has ended, so that Restart= does not start it again.

## What it finds
`RemainAfterExit=yes` with `Restart=always` or `Restart=on-success` in a service of another type than `oneshot`, after
all drop-ins.

## Why it matters on a robot
When the program ends with success, as many do after SIGTERM, a closed connection or an error that they only log,
systemd shows the service as "active (exited)" and starts nothing again: `RemainAfterExit=` counts first. `systemctl
start` does nothing either, because the service counts as active.

## Bad
```ini
[Service]
Type=simple
ExecStart=/opt/rover/bin/camera
RemainAfterExit=yes
Restart=always
```

## Good
```ini
[Service]
Type=simple
ExecStart=/opt/rover/bin/camera
Restart=always
```

## When to ignore it
When the program is to stay down after an end with success.

## References
- systemd.service(5), "RemainAfterExit=", "Restart="
- systemd, src/core/service.c, `service_enter_running()`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["Active: active (exited)"])
def restart_after_success(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        restart, remains = unit.get("Restart"), unit.flag("RemainAfterExit")
        if remains and restart in ("always", "on-success") and unit.get("Type") != "oneshot":
            yield finding(
                remains.where,
                f"When the process of {unit.name} ends with success, the service stays 'active (exited)' and "
                f"Restart={restart} does not start it again",
                advice="remove RemainAfterExit=, which is for Type=oneshot",
                related=[note(restart, "has no effect after success")],
            )
