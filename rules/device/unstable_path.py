"""A device path contains a number that changes.

## What it finds
`/dev/ttyUSB0`, `/dev/ttyACM1`, `/dev/video2` and similar paths. The severity depends on the place:

- Error: units and their environment files, compose, launch and parameter files.
- Warning: scripts, and default values of shell variables.
- Info: the default of a launch argument.

On-board ports (ttyS, ttyTHS, ttyAMA), links by id or path, and files for simulation are not reported.

## Why it matters on a robot
The numbers follow the order in which devices are found. After a reboot the IMU is ttyUSB1 and the motor controller
ttyUSB0: each driver talks to the wrong device.

## Bad
```ini
[Service]
Environment=IMU_PORT=/dev/ttyUSB0
```

## Good
```ini
[Service]
Environment=IMU_PORT=/dev/robot/imu
```

## When to ignore it
When the robot has exactly one device of this kind and no free port where a second one could be plugged in.

## References
- udev(7), SYMLINK
- https://github.com/RoverRobotics-archive/roverrobotics_ros2/issues/16
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

_SEVERITY = {"script": "warning", "default": "warning", "argument": "info"}


@rule("error", symptoms=["could not open port /dev/ttyUSB0", "Could not open device /dev/ttyUSB0"])
def unstable_path(robot: Robot) -> Iterator[Finding]:
    for use, links in robot.devices.unstable:
        severity = _SEVERITY.get(use.certainty)
        names = " or ".join(link.path for link in links[:3])
        yield finding(
            use.path,
            f"{use.path} is numbered in the order of discovery: after a reboot it may be another device",
            advice=f"use {names}" if links else "create a link with a udev rule, or use a path below /dev/serial/by-id",
            related=[note(link.name, f"creates {link.path}") for link in links[:3]],
            severity=severity,
            chain=robot.provenance.chain_to(use.path, f"{use.path} is opened"),
        )
