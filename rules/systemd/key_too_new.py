"""A key, value or specifier that the robot's systemd does not know yet.

## What it finds
A key, a word of a value or a specifier that needs a newer systemd than the robot's. The robot's release is
the one in the configuration, or follows from the operating system or ROS distribution that the tree names. If
the release is unknown, nothing is reported. It is an error for Type= and for specifiers.

## Why it matters on a robot
What works on the developer's laptop has no effect on the robot. With systemd 249 (Ubuntu 22.04),
Type=notify-reload becomes Type=simple, and RestartSteps= does nothing. An unknown specifier prevents the unit
from loading.

## Bad
```ini
# robot with Ubuntu 22.04 (systemd 249)
[Service]
ExecStart=/usr/bin/robot-drivers
RestartSteps=5
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
RestartSec=5
```

## When to ignore it
When the same file is deployed to robots with older and newer releases, and the older ones can do without the
setting.

## References
- systemd.directives(7), the NEWS file of systemd
- journal: "Unknown key name 'RestartSteps' in section 'Service', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "Unknown key name",
        "Failed to parse service type",
        "Failed to resolve unit specifiers",
        "Unknown key '*' in section [*], ignoring.",
    ],
)
def key_too_new(robot: Robot) -> Iterator[Finding]:
    target = robot.target
    if not target.systemd_known:
        return
    has = f"the robot has {target.systemd} ({target.systemd_why})"
    for line in robot.units.lines:
        if line.directive.since > target.systemd:
            message = f"{line.key}= needs systemd {line.directive.since}; {has} and ignores the line"
            yield finding(line.key, message, advice="remove the line, or set the newer release in the configuration")
            continue
        for problem in line.problems:
            if problem.code == "too-new":
                what = "the line" if problem.effect == "line" else "the word"
                message = f"{line.key}={problem.where} needs systemd {problem.since}; {has} and ignores {what}"
                severity = "error" if line.key == "Type" else None
                yield finding(problem.where, message, advice=f"use {problem.expected}", severity=severity)
            elif problem.code == "specifier-too-new":
                message = f"{problem.where} needs systemd {problem.since}; {has}: {line.consequence(problem)}"
                yield finding(problem.where, message, advice="write the value in full", severity="error")
