"""Several running nodes publish one velocity command.

## What it finds
Topics called `cmd_vel`, and topics with `cmd_vel` in their name that carry `Twist` or `TwistStamped`, with
publishers in more than one node. Tools count too. The servers of nav2 count as one, because the behavior tree lets
only one of them act at a time.

## Why it matters on a robot
The base obeys the message that arrived last: a stop is followed by a go. Nothing arbitrates, and nothing warns.

## Bad
```yaml
endpoints:
- {topic: /cmd_vel, publisher: /joystick, type: geometry_msgs/msg/Twist}
- {topic: /cmd_vel, publisher: /velocity_smoother, type: geometry_msgs/msg/Twist}
```

## Good
```yaml
endpoints:
- {topic: /cmd_vel_joy, publisher: /joystick, type: geometry_msgs/msg/Twist}
- {topic: /cmd_vel_nav, publisher: /velocity_smoother, type: geometry_msgs/msg/Twist}
- {topic: /cmd_vel, publisher: /twist_mux, type: geometry_msgs/msg/Twist}
```

## When to ignore it
When the nodes take turns by design, for example through a lifecycle state, and you have tested that only one
publishes at a time.

## References
- twist_mux, README
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

BY_TURNS = ("controller_server", "behavior_server", "recoveries_server", "docking_server", "following_server")


@rule("error", silent="several publishers of one topic are normal for ROS", tags=["CWE-362"])
def cmd_vel_publishers(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    for topic in observed.velocities:
        sources = {source(each.node): each for each in reversed(topic.publishers)}
        if len(sources) < 2:
            continue
        first, *others = sorted(
            reversed(sources.values()), key=lambda each: observed.named_at(each).source is observed.graph.source
        )
        names = ", ".join(str(each.node) for each in (first, *others))
        yield finding(
            observed.named_at(first),
            f"{len(sources)} nodes publish {topic.name} ({names}): the base obeys the last message",
            advice="give each its own topic and let a mux with priorities (twist_mux) publish the result",
            related=[note(observed.named_at(each), f"{each.node} publishes it too") for each in others],
        )


def source(name: str) -> str | tuple[str, str]:
    """The node, or nav2 for those that take turns."""
    namespace, _, bare = name.rpartition("/")
    return (namespace, "nav2") if bare in BY_TURNS else name
