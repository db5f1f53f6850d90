"""A lifecycle node overrides on_activate() and leaves its publishers inactive.

## What it finds
A lifecycle node whose own `on_activate()` calls neither that of the base class nor that of its publishers, though the
node publishes on lifecycle publishers: in Python those of `create_lifecycle_publisher`, in C++ those that the node's
`create_publisher` makes.

## Why it matters on a robot
`on_activate()` of the base class is what activates the publishers. An override that does not call it leaves them
inactive: the node reports that it is active, and each message is dropped with one warning in the log.

## Bad
```cpp
CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
{
  return CallbackReturn::SUCCESS;
}
```

## Good
```cpp
CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
{
  return LifecycleNode::on_activate(state);
}
```

## When to ignore it
When a class that the linter does not see activates the publishers.

## References
- rclcpp_lifecycle, lifecycle_node_interface_impl.cpp and lifecycle_publisher.hpp
- rclpy, lifecycle/node.py
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Trying to publish message on the topic *, but the publisher is not activated"])
def lifecycle_never_active(robot: Robot) -> Iterator[Finding]:
    for source, transition, publishers in nodes.inactive_publishers(robot.nodes):
        names = [f"'{each.name}'" for each in publishers if each.name]
        what = names[0] if len(names) == 1 == len(publishers) else f"{len(publishers)} topics"
        if not names and len(publishers) == 1:
            what = "what it publishes"
        yield finding(
            transition,
            f"on_activate() does not activate the publishers of the node: each message on {what} is dropped",
            advice="call on_activate() of the base class with the state, and return what it returns",
            related=[note(each.span, "stays inactive") for each in publishers],
            severity=robot.nodes.lowered(source, "error"),
        )
