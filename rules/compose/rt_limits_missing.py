"""A real-time controller in a container cannot get its priority.

## What it finds
A service that starts `ros2_control_node` with neither `ulimits: rtprio` nor `cap_add: SYS_NICE`. A privileged
service has the capability and is not reported.

## Why it matters on a robot
`pthread_setschedparam` fails. The control loop runs as an ordinary process and misses its period under load.

## Bad
```yaml
control:
  command: ros2 run controller_manager ros2_control_node
```

## Good
```yaml
control:
  command: ros2 run controller_manager ros2_control_node
  ulimits: {rtprio: 99, memlock: -1}
  cap_add: [SYS_NICE]
```

## When to ignore it
When the controller is slow enough for ordinary scheduling, such as 50 Hz for a demonstration without real motors.

## References
- ros2_control documentation, "Determinism"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.yaml import Mapping


@rule(
    "warning",
    symptoms=[
        "Could not enable FIFO RT scheduling policy",
        "unable to set realtime scheduling: Operation not permitted",
        "Your system/user seems not to be setup for FIFO scheduling",
    ],
)
def rt_limits_missing(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        word = next((word for word in service.scripts if "ros2_control_node" in word), None)
        limits = service.get("ulimits")
        limited = isinstance(limits, Mapping) and limits.get("rtprio") is not None
        may = {"SYS_NICE", "CAP_SYS_NICE", "ALL"} & {item.upper() for item in service.items("cap_add")}
        if word is not None and not service.is_privileged and not limited and not may:
            yield finding(
                word,
                f"'{service.name}' cannot get a real-time priority: it has neither an rtprio limit nor SYS_NICE",
                advice="add ulimits: {rtprio: 99, memlock: -1} and cap_add: [SYS_NICE]",
            )
