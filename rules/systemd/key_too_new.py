"""A key, value or specifier that the robot's systemd does not know yet.

## What it finds
A key, a word of a value or a specifier that came with a later release than the one the robot runs. The
release is the configured one, or follows from the operating system or ROS distribution that the tree names;
without either the rule is silent.

## Why it matters on a robot
What works on the developer's laptop is ignored on the robot: with systemd 249 (Ubuntu 22.04)
Type=notify-reload turns into Type=simple and RestartSteps= does nothing. An unknown specifier stops the
unit from loading.

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

## References
- systemd.directives(7), the NEWS file of systemd
- journal: "Unknown key name 'RestartSteps' in section 'Service', ignoring."
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["Unknown key name", "Failed to parse service type", "Failed to resolve unit specifiers"],
)
def key_too_new(robot: Robot):
    target = robot.target
    if not target.systemd_known:
        return
    has = f"the robot has {target.systemd} ({target.systemd_why})"
    for line in robot.units.lines:
        if line.directive.since > target.systemd:
            message = f"{line.key}= needs systemd {line.directive.since}, {has} and ignores the line"
            yield finding(line.key, message, advice="drop the line, or state the newer release in the configuration")
            continue
        for problem in line.problems:
            if problem.code == "too-new":
                what = "the line" if problem.effect == "line" else "the word"
                message = f"{line.key}={problem.where} needs systemd {problem.since}, {has} and ignores {what}"
                severity = "error" if line.key == "Type" else None
                yield finding(problem.where, message, advice=f"use {problem.expected}", severity=severity)
            elif problem.code == "specifier-too-new":
                message = f"{problem.where} needs systemd {problem.since}, {has}: {line.consequence(problem)}"
                yield finding(problem.where, message, advice="write the value in full", severity="error")
