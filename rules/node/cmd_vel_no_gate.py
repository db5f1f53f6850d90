"""Nothing limits the velocity between the planner and the motors.

## What it finds
A node that is not a teleoperation publishes a velocity to which another node subscribes directly. Reported when no
node of the launch file limits or selects velocities: no collision monitor, smoother, multiplexer, or node with gate
or safety in its name.

## Why it matters on a robot
A jump in the plan, a wrong unit or a node that hangs reaches the motors unchanged.

## Bad
```python
Node(package="mower", executable="planner"),   # publishes cmd_vel
Node(package="mower", executable="base"),      # subscribes cmd_vel
```

## Good
```python
Node(package="mower", executable="planner", remappings=[("cmd_vel", "cmd_vel_raw")]),
Node(package="nav2_collision_monitor", executable="collision_monitor", parameters=[zones]),
Node(package="mower", executable="base"),
```

## When to ignore it
When the motor controller limits velocity and acceleration itself and stops when commands stop.

## References
- Nav2, collision monitor and velocity smoother
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("info", confidence="medium", silent="velocities reach the motors as they are sent")
def cmd_vel_no_gate(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for running in robot.topics.entries:
        if running.simulated or any(map(topics.is_gate, running.nodes)):
            continue
        for publisher, subscription in topics.ungated(running):
            if publisher.where not in seen:
                seen.add(publisher.where)
                yield finding(
                    publisher.where,
                    f"{publisher.topic} goes from {publisher.node.label()} to {subscription.node.label()} unchanged: "
                    "nothing limits or stops it",
                    advice="put a gate with limits and a timeout between them",
                    related=[note(subscription.where, f"{subscription.node.label()} obeys it here")],
                )
