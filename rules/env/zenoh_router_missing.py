"""Nothing starts the zenoh router that the nodes need.

## What it finds
A process with `RMW_IMPLEMENTATION=rmw_zenoh_cpp` whose whole environment is known and sets none of
`ZENOH_ROUTER_CHECK_ATTEMPTS`, `ZENOH_SESSION_CONFIG_URI` and `ZENOH_CONFIG_OVERRIDE`, when no unit, launch file, script
or compose service of the tree mentions `rmw_zenohd` or `zenohd`. In a repository, which may not hold all of the robot,
only the processes of units, as a warning.

## Why it matters on a robot
By default nodes find each other through a router on the same machine. Without one they do not discover each other.

## Bad
```ini
Environment=RMW_IMPLEMENTATION=rmw_zenoh_cpp
ExecStart=/opt/lawn/start
```

## Good
```ini
# zenoh-router.service
ExecStart=/opt/lawn/ros2-env ros2 run rmw_zenoh_cpp rmw_zenohd
# lawn.service
After=zenoh-router.service
```

## When to ignore it
When the router runs in a container or on an image that is not in the tree.

## References
- rmw_zenoh, README: the zenoh router
- https://github.com/ros2/rmw_zenoh/issues/439
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

ELSEWHERE = ("ZENOH_ROUTER_CHECK_ATTEMPTS", "ZENOH_SESSION_CONFIG_URI", "ZENOH_CONFIG_OVERRIDE")
ROUTER = regex(r"zenohd\b|zenoh[-_]router", hints="zenoh")


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "Unable to connect to a Zenoh router",
        "Have you started a router",
        "Scouting delay elapsed before start conditions are met",
        "orchestrator: Unable to connect to",
    ],
)
def zenoh_router_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("rmw_zenoh_cpp") or at_least(robot.target.ros, "humble") is False:
        return
    if any(source.says(ROUTER) for source in robot.sources):
        return
    for process in robot.ros.processes:
        environment = process.environment
        rmw = environment.get("RMW_IMPLEMENTATION")
        if rmw is None or rmw.text != "rmw_zenoh_cpp":
            continue
        if not (process.unit or (process.launcher and robot.tree.complete)):
            continue
        if all(environment.defines(name) is False for name in ELSEWHERE):
            yield finding(
                rmw.value,
                f"Nothing starts a zenoh router on this robot: the nodes of {process.name} do not discover each other",
                advice="add a unit that runs ros2 run rmw_zenoh_cpp rmw_zenohd, and order the others after it",
                related=[note(process.where, f"{process.name} waits for it")],
                severity=None if robot.tree.complete else "warning",
            )
            return
