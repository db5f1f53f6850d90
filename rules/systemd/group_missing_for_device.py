"""The user of a service is not in the group of its device.

## What it finds
A service in a root file system with `/etc/group`, when all of this is true:

- it has `User=`;
- its own files, environment files or launch files name a device that a udev rule gives to a group (`GROUP=`
  with a mode such as 0660, or the usual group of serial ports and cameras);
- neither `/etc/group` nor `SupplementaryGroups=` makes the user a member of that group.

## Why it matters on a robot
Opening the device fails: "Permission denied: '/dev/robot/imu'". The person who tried the driver in a terminal
was a member of dialout. The user of the service is not.

## Bad
```ini
[Service]
User=rover
Environment=PORT=/dev/robot/imu
```

## Good
```ini
[Service]
User=rover
SupplementaryGroups=dialout
Environment=PORT=/dev/robot/imu
```

## When to ignore it
When an ACL (`TAG+="uaccess"`, setfacl) gives the user access, or when provisioning adds the user to the
group.

## References
- systemd.exec(5), "SupplementaryGroups="
- udev(7), "GROUP"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "[Errno 13] Permission denied: '/dev/",
        "could not open port /dev/*: [Errno 13] Permission denied",
        "/dev/*: Permission denied",
        "Permission denied: '/dev/",
        "/dev/*Permission denied",
        "IO Exception (13): Permission denied",
        "open device error | device: *, errno: 13",
        "open device error | device: *, errno: 13. Please re-run with superuser privileges.",
        "Cannot open '/dev/*: 13, Permission denied",
        "/dev/*errno: 13",
        "/dev/*Error 13",
        "No access to /dev/mem",
        "can not open gpiochip",
        "DeviceError:serial:open: Permission denied",
    ],
)
def group_missing_for_device(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for closed in robot.closed_devices:
        unit, group = closed.unit, closed.group
        if (unit.name, group) in seen:
            continue
        seen.add((unit.name, group))
        yield finding(
            closed.user,
            f"User {closed.user} is not in group {group}: opening {closed.use.path} fails",
            advice=f"add SupplementaryGroups={group}",
            related=[
                note(closed.use.path, "the device that the service opens"),
                note(closed.link.name, f"created for group {group}"),
            ],
            fix=fix(
                f"add SupplementaryGroups={group}",
                unit.new_line("Service", f"SupplementaryGroups={group}"),
                safe=False,
            ),
        )
