"""EnvironmentFile= names a file that does not exist.

## What it finds
In a root file system: `EnvironmentFile=` without a leading `-` and without wildcards, on a file that is not
there. Files below `/run` and `/tmp`, which something makes at run time, are left out.

## Why it matters on a robot
The service does not start: "Failed to load environment files: No such file or directory", result
`resources`. With `Restart=` it tries again and again without running a line of the robot's software.
`systemd-analyze verify` does not look.

## Bad
```ini
[Service]
EnvironmentFile=/etc/rover/ros.env
```

## Good
```ini
[Service]
# shipped with the image
EnvironmentFile=/etc/rover/ros.env
```

## References
- systemd.exec(5), "EnvironmentFile="
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

RUNTIME = ("/run/", "/var/run/", "/tmp/", "/var/tmp/", "/proc/", "/dev/", "/sys/")


@rule(
    "error",
    symptoms=[
        "Failed to load environment files: No such file or directory",
        "Failed with result 'resources'",
    ],
)
def envfile_missing(robot: Robot):
    for unit in robot.units.services:
        for file in robot.units.environment_files(unit):
            if file.missing and not file.optional and not file.path.startswith(RUNTIME):
                yield finding(
                    file.value,
                    f"{file.path} does not exist: {unit.name} fails to start",
                    advice="ship the file, or put '-' before the path if the service can do without it",
                )
