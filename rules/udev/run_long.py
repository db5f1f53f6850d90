"""A rule starts something that lasts.

## What it finds
`RUN` or `PROGRAM` with `ros2`, `roslaunch`, a launch file, a long `sleep`, `nohup`, a shell that goes to the
background, or `systemd-run --scope`.

## Why it matters on a robot
udev kills everything that an event started when the event ends, at the latest after 180 s, background
processes included. The driver dies seconds after the device appears.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", RUN+="/usr/local/bin/start.sh &"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", TAG+="systemd", ENV{SYSTEMD_WANTS}+="imu.service"
```

## References
- udev(7), RUN: "only be used for very short-running foreground tasks"
- systemd.device(5), SYSTEMD_WANTS=
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_LASTING = (
    (
        re.compile(r"\bros2\s+(?:launch|run)\b|\broslaunch\b|\brosrun\b|\S+\.launch(?:\.py|\.xml|\.yaml)?\b"),
        "a ROS program",
    ),
    (re.compile(r"\bnohup\b|\bsetsid\b|\bdisown\b"), "a process that is to outlive it"),
    (re.compile(r"(?<!&)&\s*(?:['\"]?\s*)\Z"), "a background process"),
    (re.compile(r"\bsleep\s+(?:[1-9]\d+|[6-9])\b"), "a long wait"),
    (re.compile(r"\bsystemd-run\b(?=.*--scope)"), "a scope inside the event"),
)
_HANDED_OVER = re.compile(
    r"\bsystemd-run\b(?!.*--scope)|\bsystemctl\b.*--no-block|--no-block\b.*\bsystemctl\b|\bat\s+now\b"
)


@rule("warning", symptoms=["Spawned process", "timed out, killing", "is taking a long time"])
def run_long(robot: Robot):
    for line in robot.udev.judged:
        for command in line.commands:
            if _HANDED_OVER.search(command.text):
                continue
            for pattern, what in _LASTING:
                found = pattern.search(command.text)
                if found:
                    yield finding(
                        command.text.part(*found.span()),
                        f"udev kills {what} with the event that started it, at the latest after 180 s",
                        advice='start a unit instead: TAG+="systemd", ENV{SYSTEMD_WANTS}+="name.service"',
                    )
                    break
