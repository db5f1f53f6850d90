"""A driver service does not check whether its devices exist.

## What it finds
A ROS service whose name marks it as a driver and that nothing makes wait for its devices: it has no
ExecStartPre= or ExecCondition=, no `.device` unit in BindsTo=, Requires=, Requisite=, Wants= or After=, and
no Condition or Assert on a path. One-shot services are exempt.

## Why it matters on a robot
The driver starts before its devices exist. It then fails and uses up the start limit, or it runs without the
sensor.

## Bad
```ini
# rover-lidar.service
[Service]
ExecStart=/opt/ros/jazzy/lib/rover_lidar/driver
```

## Good
```ini
[Unit]
BindsTo=dev-rover-lidar.device
After=dev-rover-lidar.device

[Service]
ExecStart=/opt/ros/jazzy/lib/rover_lidar/driver
```

## When to ignore it
When the driver itself waits for its device and reconnects, or when it drives no local device, for example a
lidar on Ethernet.

## References
- systemd.device(5), systemd.unit(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

DRIVER = regex(
    r"(?:^|[-_.@])(?:drivers?|lidar|laser|cameras?|imu|motors?|gps|gnss|sensors?|hardware|hw|can)(?=[-_.@]|$)",
    hints="driver lidar laser camera imu motor gps gnss sensor hardware hw can",
)
PATH_CHECKS = tuple(
    f"{kind}{test}" for kind in ("Condition", "Assert") for test in ("PathExists", "PathExistsGlob", "FileNotEmpty")
)
PULLS = ("BindsTo", "Requires", "Wants", "After", "Requisite")


@rule("info", silent="what is logged is the error of the driver itself")
def device_check_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        if not unit.complete or unit.get("Type") == "oneshot" or not DRIVER.search(unit.stem):
            continue
        if unit.has("ExecStartPre") or unit.has("ExecCondition") or any(unit.has(key, "Unit") for key in PATH_CHECKS):
            continue
        if any(word.endswith(".device") for key in PULLS for word in unit.words(key)):
            continue
        yield finding(
            unit.where,
            f"{unit.name} starts whether or not its devices exist",
            advice="order it after its device units with BindsTo= and After=, or check for them in ExecStartPre=",
        )
