"""The sandbox hides the devices that the service opens.

## What it finds
A service that names a device below /dev, and one of these settings:

- PrivateDevices=yes;
- DevicePolicy=closed or strict without DeviceAllow=.

The device can be on the command line, in the environment, in a script, or in the launch file that the service
starts.

## Why it matters on a robot
The device node does not exist for the service, or opening it fails. The driver reports "No such file" or
"Operation not permitted", although the device, its link and its group are right.

## Bad
```ini
[Service]
ExecStart=/opt/ros/jazzy/lib/rover_lidar/driver --port /dev/rover/lidar
PrivateDevices=yes
```

## Good
```ini
[Service]
ExecStart=/opt/ros/jazzy/lib/rover_lidar/driver --port /dev/rover/lidar
DevicePolicy=closed
DeviceAllow=char-ttyUSB rw
```

## When to ignore it
When the service names the device but never opens it, for example because it passes the path to another
service.

## References
- systemd.exec(5), PrivateDevices=; systemd.resource-control(5), DevicePolicy= and DeviceAllow=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.supervision import devices_opened_by
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import delete_lines

PSEUDO = regex(
    r"/dev/(?:null|zero|full|u?random|tty|ptmx|pts|shm|mqueue|hugepages|log|std(?:in|out|err)|fd|console)(?:/|$)"
)


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "could not open port",
        "No such file or directory: '/dev/",
        "/dev/*Operation not permitted",
    ],
)
def private_devices(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        closed = _closed(unit)
        if closed is None or robot.units.supervision(unit).in_container:
            continue
        key, value = closed
        opened = devices_opened_by(unit, robot.units, robot.launch, robot.devices)
        used = [use for use in opened if not PSEUDO.match(use.path)]
        if not used:
            continue
        lines = [line for line in unit.assignments(key, "Service") if line.value is value]
        yield finding(
            value,
            f"{key}={value} prevents {unit.name} from opening {used[0].path}",
            advice="remove it, or use DevicePolicy=closed with a DeviceAllow= line for each device",
            related=[note(use.path, "opened here") for use in used[:5]],
            fix=fix(f"remove {key}=", *map(delete_lines, lines), safe=False) if unit.editable and lines else None,
        )


def _closed(unit: Unit) -> tuple[str, Located] | None:
    """The setting that closes /dev, and its value."""
    private = unit.flag("PrivateDevices")
    if private:
        return "PrivateDevices", private.where
    policy = unit.get("DevicePolicy")
    if policy is not None and policy in ("closed", "strict") and not unit.has("DeviceAllow"):
        return "DevicePolicy", policy
    return None
