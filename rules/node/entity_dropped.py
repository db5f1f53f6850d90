"""A subscription, service, timer or callback group of a C++ node is destroyed as soon as it is made.

## What it finds
In C++ sources of nodes, `create_subscription`, `create_service`, `create_wall_timer`, `create_timer` and
`rclcpp_action::create_server` whose pointer is thrown away, or kept only in a local variable of a function that uses it
nowhere else and returns. Also `create_callback_group` in a local variable that the function only gives to the timers,
services and clients that it makes; a subscription keeps the group of its options. Functions that spin, sleep or wait,
and `main`, are left out.

## Why it matters on a robot
An rclcpp node and its callback groups hold only weak pointers to these objects, and timers, services and clients hold
none to their group. When the last shared pointer goes, the object is destroyed: a watchdog never runs, commands never
arrive, and a service is not there. It compiles without a warning, and nothing is logged. In rclpy the node keeps them,
so the same line in Python works.

## Bad
```cpp
Drive() : Node("drive") {
  create_wall_timer(100ms, [this] { watchdog(); });
}
```

## Good
```cpp
Drive() : Node("drive") {
  watchdog_timer_ = create_wall_timer(100ms, [this] { watchdog(); });
}
```

## When to ignore it
When a class of your own, with a method of this name, keeps the object.

## References
- rclcpp, callback_group.hpp: `subscription_ptrs_`, `timer_ptrs_` and `service_ptrs_` are vectors of weak pointers
- rclcpp, node_topics.cpp and node_timers.cpp: the node itself keeps none of them
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

LOST = {
    "subscription": "its callback never runs",
    "timer": "its callback never runs",
    "service": "no client finds it",
    "action server": "no client finds it",
    "callback group": "its callbacks never run",
}


@rule("error", silent="the call succeeds, and the object is gone before the first message")
def entity_dropped(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        if not node.dropped:
            continue
        first, *others = node.dropped
        when = f"when '{first.variable}' goes out of scope" if first.variable else "at once"
        yield finding(
            first.made,
            f"The {first.kind} is destroyed {when}: {LOST[first.kind]}",
            advice="keep the returned pointer in a member of the class",
            related=[note(each.made, f"this {each.kind} is not kept either") for each in others],
            severity=robot.nodes.lowered(node.source, "error"),
        )
