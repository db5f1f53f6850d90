"""A whole ROS service logs at level debug without a rate limit of its own.

## What it finds
A ROS service that starts with the log level debug for all nodes (`--log-level debug`, `log_level:=debug`,
`ros2 launch --debug`) and has neither LogRateLimitIntervalSec= nor LogRateLimitBurst=.

## Why it matters on a robot
The journal's rate limit then drops lines of the service at random, including warnings. The disk and the CPU
pay for text that nobody reads.

## Bad
```ini
[Service]
ExecStart=/opt/rover/setup-and-run ros2 launch rover base.launch.py log_level:=debug
```

## Good
```ini
[Service]
ExecStart=/opt/rover/setup-and-run ros2 launch rover base.launch.py log_level:=info
```

## When to ignore it
While you debug this service, on a robot that is not in operation.

## References
- systemd.exec(5), LogRateLimitIntervalSec=; journald.conf(5), RateLimitBurst=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", symptoms=["Suppressed * messages from"])
def log_flood(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        if unit.get("LogRateLimitIntervalSec") or unit.get("LogRateLimitBurst"):
            continue
        for process in robot.units.started(unit):
            for _, found in process.ros:
                word = _debug([*found.command.words])
                if word is not None:
                    yield finding(
                        word,
                        f"All nodes of {unit.name} log at level debug: the journal's rate limit drops lines at random",
                        advice="lower the level, or set LogRateLimitIntervalSec= and LogRateLimitBurst=",
                    )


def _debug(words: list[Located]) -> Located | None:
    for before, word in zip(["", *words], words, strict=False):
        if word.lower() in ("log_level:=debug", "--log-level=debug") or (
            before == "--log-level" and word.lower() == "debug"
        ):
            return word
        if word in ("--debug", "-d") and len(words) > 2 and "launch" in words[:3]:
            return word
    return None
