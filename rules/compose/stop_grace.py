"""Docker kills the container before launch has stopped its nodes.

## What it finds
A service that runs `ros2 launch` with a `stop_grace_period` below 15 seconds, or without one (10 seconds).

## Why it matters on a robot
`ros2 launch` gives its nodes 5 seconds after SIGINT and 5 more after SIGTERM before it kills them. Docker's 10
seconds are over before that ends.

## Bad
```yaml
nav:
  command: ros2 launch nav nav.launch.py
```

## Good
```yaml
nav:
  command: ros2 launch nav nav.launch.py
  stop_grace_period: 20s
```

## When to ignore it
When all nodes stop within a second or two and you have measured it.

## References
- launch, ExecuteProcess: sigterm_timeout and sigkill_timeout
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.yaml import first_key


@rule(
    "info",
    fix="unsafe",
    symptoms=["exited with code 137", "failed to terminate * seconds after receiving *, escalating to SIGTERM"],
)
def stop_grace(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        text, seconds = service.scalar("stop_grace_period"), service.stop_grace
        if service.launches is None or (text is not None and (seconds is None or seconds >= 15)):
            continue
        if text is None and service.launches.span.start < service.body.span.start:
            continue
        add = first_key(service.body, "stop_grace_period: 20s")
        given = f"{seconds if text else 10:g} s"
        yield finding(
            text or service.name,
            f"Docker kills '{service.name}' after {given}; ros2 launch may need longer to stop its nodes",
            advice="write stop_grace_period: 20s",
            fix=fix("write stop_grace_period: 20s", (text, "20s") if text else add),
        )
