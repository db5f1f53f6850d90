"""Stop or velocity commands can be lost or arrive late.

## What it finds
Three mistakes in Python nodes:

- An emergency stop topic is published or subscribed with best effort.
- A velocity command is published or subscribed with best effort by a node without a timer. A timer could repeat the
  command, or notice that none arrives.
- A subscription of either kind queues more than ten messages. Info where the file has a time-out for velocities.

## Why it matters on a robot
Best effort sends a message once. On a busy network the one stop command is the one that is lost. A node that falls
behind works through its queue: with 100 queued commands at 20 Hz, the robot does what was requested five seconds
ago.

## Bad
```python
self.stop = self.create_publisher(Bool, "emergency_stop", qos_profile_sensor_data)
self.create_subscription(Twist, "cmd_vel", self.drive, 100)
```

## Good
```python
self.stop = self.create_publisher(Bool, "emergency_stop", 1)
self.create_subscription(Twist, "cmd_vel", self.drive, 1)
```

## When to ignore it
When another channel, such as a safety controller, stops the robot, and the topic only displays the state.

## References
- ROS 2 documentation, "Quality of Service settings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics
from bringup_lint.api.nodes import Endpoint
from bringup_lint.api.nodes import Timer

QUEUE = 10


@rule("warning", silent="a lost best effort message leaves no trace")
def qos_command_best_effort(robot: Robot) -> Iterator[Finding]:
    for endpoints, timers, relay in _nodes(robot):
        for endpoint in endpoints:
            if endpoint.name is None or endpoint.qos is None or endpoint.role not in ("publisher", "subscription"):
                continue
            stop, drive = topics.is_stop(endpoint.name), topics.is_velocity(endpoint.name, endpoint.type)
            related = [
                note(endpoint.name, f"{endpoint.name} is set up here"),
                *topics.used_at(endpoint.qos.span, endpoint.span),
            ]
            if endpoint.qos.reliability == "BEST_EFFORT" and (stop or (drive and not timers)):
                yield finding(
                    endpoint.qos.span,
                    f"The {endpoint.role} of {endpoint.name} is best effort: a single "
                    f"{'stop' if stop else 'command'} that the network drops is never sent again",
                    advice="use a reliable profile with depth 1",
                    related=related,
                    severity=None if stop or (endpoint.role == "publisher" and not relay) else "info",
                )
            elif (relay and timers) or endpoint.role != "subscription":
                continue
            elif (stop or drive) and (endpoint.qos.depth or 0) > QUEUE:
                watched = drive and not stop and nodes.guards_commands(endpoint.span.source.text)
                yield finding(
                    endpoint.qos.span,
                    f"{endpoint.name} queues {endpoint.qos.depth} commands: a node that falls behind does what "
                    f"was requested {endpoint.qos.depth} messages ago",
                    advice="use depth 1, so that only the newest command applies",
                    related=related,
                    severity="info" if watched else None,
                )


def _nodes(robot: Robot) -> Iterator[tuple[list[Endpoint], list[Timer], bool]]:
    """The endpoints of each Python class and C++ file for the robot, with all timers of its node, and whether the node
    passes a stream of commands on."""
    for node in robot.nodes.classes:
        if robot.nodes.is_for_robot(node.source):
            yield node.endpoints, node.all_timers, nodes.relays(node)
    for source in robot.nodes.cpp:
        if robot.nodes.is_for_robot(source.source):
            yield source.endpoints, source.timers, False
