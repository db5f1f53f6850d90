"""A driver service that does not look whether its devices are there.

## What it finds
A ROS service whose name says that it drives hardware, without ExecStartPre=, without a `.device` unit in
BindsTo=, Requires=, Wants= or After=, and without a Condition or Assert on a path.

## Why it matters on a robot
The driver starts before its devices exist, fails, and uses up the start limit; or it comes up without the
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

## References
- systemd.device(5), systemd.unit(5)
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

DRIVER = re.compile(
    r"(?:^|[-_.@])(?:drivers?|lidar|laser|cameras?|imu|motors?|gps|gnss|sensors?|hardware|hw|can)(?=[-_.@]|$)"
)
PATH_CHECKS = tuple(
    f"{kind}{test}" for kind in ("Condition", "Assert") for test in ("PathExists", "PathExistsGlob", "FileNotEmpty")
)
PULLS = ("BindsTo", "Requires", "Wants", "After", "Requisite")


@rule("info")
def device_check_missing(robot: Robot):
    for unit in robot.units.ros:
        if not unit.complete or unit.get("Type") == "oneshot" or not DRIVER.search(unit.stem):
            continue
        if unit.has("ExecStartPre") or unit.has("ExecCondition") or any(unit.has(key, "Unit") for key in PATH_CHECKS):
            continue
        if any(word.endswith(".device") for key in PULLS for word in unit.words(key)):
            continue
        yield finding(
            unit.where,
            f"{unit.name} starts whether its devices are there or not",
            advice="order it after its device units with BindsTo= and After=, or check them in ExecStartPre=",
        )
