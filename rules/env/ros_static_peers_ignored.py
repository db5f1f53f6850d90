"""The static peers are never contacted.

## What it finds
ROS_STATIC_PEERS together with a discovery range of OFF or SYSTEM_DEFAULT, or with ROS_LOCALHOST_ONLY=1, in one
environment on Iron and newer.

## Why it matters on a robot
The listed machines are not contacted: the base station never sees the robot. rcl says so only with
ROS_LOCALHOST_ONLY=1.

## Bad
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=OFF
ROS_STATIC_PEERS=10.0.0.2
```

## Good
```sh
ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET
ROS_STATIC_PEERS=10.0.0.2
```

## When to ignore it
When discovery is switched off on purpose and the peers are kept for a quick return.

## References
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Improved-Dynamic-Discovery.html
- https://github.com/clearpathrobotics/clearpath_common/issues/269
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least
from bringup_lint.api.systemd import Environment
from bringup_lint.api.systemd import Variable


@rule(
    "warning", symptoms=["'localhost_only' is enabled, 'automatic_discovery_range' and 'static_peers' will be ignored."]
)
def ros_static_peers_ignored(robot: Robot) -> Iterator[Finding]:
    if not at_least(robot.target.ros, "iron"):
        return
    for process in robot.ros.processes:
        environment = process.environment
        peers = environment.get("ROS_STATIC_PEERS")
        if not peers or not peers.text or not environment.complete:
            continue
        reason = _reason(environment)
        if reason is not None:
            yield finding(
                peers.value,
                f"{process.name} never contacts these peers: {reason.name}={reason.text}",
                advice="use ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET or LOCALHOST with static peers",
                related=[note(reason.value, "set here")],
            )


def _reason(environment: Environment) -> Variable | None:
    if environment.text("ROS_LOCALHOST_ONLY") == "1":
        return environment.get("ROS_LOCALHOST_ONLY")
    if environment.text("ROS_AUTOMATIC_DISCOVERY_RANGE") in ("OFF", "SYSTEM_DEFAULT"):
        return environment.get("ROS_AUTOMATIC_DISCOVERY_RANGE")
    return None
