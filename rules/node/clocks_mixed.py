"""A C++ callback subtracts or compares times of different clocks, which throws.

## What it finds
A member of type `rclcpp::Time` that the class makes without a clock, as `rclcpp::Time last_;` or `{0, 0}`, or with
`RCL_SYSTEM_TIME`, and a callback that compares it with `now()` of the node or the stamp of a message, or takes their
difference, before anything else has set the member: because only the same callback sets it, after that, or because
only a subscription does and the callback is that of a timer or of another subscription. Silent where a condition or an
early return guards the first time.

## Why it matters on a robot
A default-made `rclcpp::Time` has the clock `RCL_SYSTEM_TIME`, those of nodes and messages `RCL_ROS_TIME`. The operators
throw `std::runtime_error` for two different clocks. In a callback nobody catches it: the node terminates with its first
message or tick. Tests that set the member first don't show it.

## Bad
```cpp
rclcpp::Time last_;
void on_odom(const Odometry & m) { const auto dt = rclcpp::Time(m.header.stamp) - last_; last_ = m.header.stamp; }
```

## Good
```cpp
rclcpp::Time last_{0, 0, RCL_ROS_TIME};
```

## When to ignore it
When the node is made with another `clock_type`.

## References
- rclcpp, time.hpp: the default of `clock_type` is `RCL_SYSTEM_TIME`, and `RCL_ROS_TIME` for a message
- rclcpp, time.cpp: `operator-`, `operator<` and the others throw when the clocks differ
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "can't subtract times with different time sources",
        "can't compare times with different time sources",
    ],
)
def clocks_mixed(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.clock_mixes(robot.nodes):
        use = first.use
        when = "until the first message comes" if use.set_later is not None else "the first time"
        set_later = [note(use.set_later, "only a message sets it")] if use.set_later is not None else []
        yield finding(
            use.place,
            f"This throws {when}: '{use.name}' is made with the system clock, and the other time has the ROS clock",
            advice=f"make it with the clock of the node: rclcpp::Time {use.name}{{0, 0, RCL_ROS_TIME}};",
            related=[
                note(first.member.name, "made with the system clock here"),
                *set_later,
                *(note(each.use.place, f"'{each.use.name}' has the same mistake") for each in others),
            ],
            severity=robot.nodes.lowered(use.place.source, "error"),
            confidence="medium" if use.set_later is not None else None,
        )
