"""A timer starts a unit that does not exist.

## What it finds
A timer whose Unit=, or the service of the same name, is neither in the tree nor in the distribution. It is an
error in a complete root file system, and a warning elsewhere, because the unit may be elsewhere.

## Why it matters on a robot
The timer refuses to start with "Unit ... not found", and its job never runs.

## Bad
```ini
# robot-backup.timer, while the service is robot-sync.service
[Timer]
OnCalendar=daily
```

## Good
```ini
[Timer]
OnCalendar=daily
Unit=robot-sync.service
```

## When to ignore it
When another package ships the unit.

## References
- systemd.timer(5), "Unit="
- journal: "Refusing to start, unit robot-backup.service to trigger not loaded."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api import systemd


@rule("error", symptoms=["Refusing to start, unit * to trigger not loaded"])
def timer_missing_service(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.type != "timer" or unit.fragment is None or unit.is_template or unit.uncertain:
            continue
        if robot.units.is_distribution_unit(unit.name):
            continue
        named = unit.get("Unit", "Timer")
        target = str(named or f"{unit.stem}.service")
        if not systemd.is_unit_name(target):
            continue
        if (named is not None and unit.is_opaque(named)) or robot.units.exists(target, unit) is not False:
            continue
        yield finding(
            named or unit.where,
            f"{unit.name} triggers {target}, which does not exist",
            advice="ship the service, or name the right one in Unit=",
            severity=None if robot.tree.complete else "warning",
            confidence="high" if robot.tree.complete else "medium",
        )
