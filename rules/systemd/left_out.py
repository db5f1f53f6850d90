"""A unit that the installation leaves out.

## What it finds
A unit with WantedBy= in `files/` of a role of Ansible, whose name no task, script, unit or guide of the tree says. Only
the tasks of the role look there. Silent if they copy whole folders, or files whose names are made of parts.

## Why it matters on a robot
The unit is in the repository and looks as if it ran. It is not on the robot: logs are not cleared, the watchdog of the
application does not watch, and `systemctl status` says "could not be found".

## Bad
```yaml
# roles/base/tasks/main.yml; roles/base/files/ holds rover.service and clear-logs.service
- copy: {src: rover.service, dest: /etc/systemd/system/rover.service}
```

## Good
```yaml
- copy: {src: rover.service, dest: /etc/systemd/system/rover.service}
- copy: {src: clear-logs.service, dest: /etc/systemd/system/clear-logs.service}
```

## When to ignore it
When the unit is installed by hand, or kept for a later time.

## References
- ansible.builtin.copy, `src`: below `files/` of the role
- systemd.unit(5), "UNIT FILE LOAD PATH"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import left_out_units


@rule("warning", confidence="medium", symptoms=["Unit * could not be found."])
def left_out(robot: Robot) -> Iterator[Finding]:
    units = left_out_units(robot.files, robot.units) if robot.of_kind("ansible") else ()
    for unit in units:
        yield finding(
            unit.where,
            f"{unit.name} is not installed: no task of the role copies it, and nothing else of the tree names it",
            advice="copy it to /etc/systemd/system and enable it, or remove the file",
        )
