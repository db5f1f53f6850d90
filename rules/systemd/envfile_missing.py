"""EnvironmentFile= names a file that does not exist.

## What it finds
`EnvironmentFile=` with a file that does not exist in a complete root file system; in a repository, a file that nothing
of it ships or makes, in a folder for which it ships a file of nearly the same name, or that it installs in another
folder (a warning). Paths with a leading `-` or wildcards are exempt, and so are files below `/run` and `/tmp`, which
are created at run time.

## Why it matters on a robot
The service does not start: "Failed to load environment files: No such file or directory", result `resources`.
With `Restart=` it tries again and again without running a line of the robot's software. `systemd-analyze
verify` does not check this.

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

## When to ignore it
When the file is created on the robot before the service starts, for example at the first boot or by a fleet
agent.

## References
- systemd.exec(5), "EnvironmentFile="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

RUNTIME = ("/run/", "/var/run/", "/tmp/", "/var/tmp/", "/proc/", "/dev/", "/sys/")


@rule(
    "error",
    symptoms=[
        "Failed to load environment files: No such file or directory",
        "Failed with result 'resources'",
        "Failed to run 'start' task: No such file or directory",
    ],
)
def envfile_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        for file in robot.units.environment_files(unit):
            if file.path is None or file.optional or file.path.startswith(RUNTIME):
                continue
            sibling = robot.filesystem.shipped_sibling(file.path)
            if file.missing:
                yield finding(
                    file.value,
                    f"{file.path} does not exist: {unit.name} fails to start",
                    advice="ship the file, or prefix the path with '-' if the service can do without it",
                )
            elif sibling:
                yield finding(
                    file.value,
                    f"The tree has {sibling} but not {file.path}: {unit.name} fails to start unless something else "
                    "installs it",
                    advice=f"ship the file, or name {sibling}",
                    severity="warning",
                    confidence="medium",
                )
