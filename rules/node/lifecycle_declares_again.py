"""A lifecycle node declares its parameters each time it is configured.

## What it finds
`declare_parameter()` in `on_configure()` of a lifecycle node in C++ or Python, in the same step of a plugin of Nav2, or
in a method that this calls, where nothing asks `has_parameter()` before, takes the exception, or undeclares the
parameter in `on_cleanup()`. Once a node.

## Why it matters on a robot
The parameters stay when the node is cleaned up. The next transition "configure" declares them again, which raises
`ParameterAlreadyDeclaredException`: the transition fails, the node goes to its error state and is finalized. So it can
be configured once in its life. A reset by the lifecycle manager, and the second try after a sensor was not ready at the
first, do not bring it up again; only a new process does.

## Bad
```cpp
CallbackReturn on_configure(const State &) { declare_parameter("rate", 10.0); return CallbackReturn::SUCCESS; }
```

## Good
```cpp
Filter() : LifecycleNode("filter") { declare_parameter("rate", 10.0); }
```

## When to ignore it
When the process always ends when the node was cleaned up or could not be configured.

## References
- https://design.ros2.org/articles/node_lifecycle.html, transitions "cleanup" and "configure"
- rclcpp, node_parameters.cpp: `declare_parameter` throws when the parameter has been declared; rclpy, node.py
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["parameter '*' has already been declared", "rclpy.exceptions.ParameterAlreadyDeclaredException"],
)
def lifecycle_declares_again(robot: Robot) -> Iterator[Finding]:
    for found in nodes.declared_again(robot.nodes):
        yield finding(
            found.place,
            f"The second {found.function}() declares a parameter again, which raises an exception: after a cleanup or a"
            " failure, the node cannot be configured any more",
            advice="declare the parameters in the constructor, or only those for which has_parameter() is false",
            severity=robot.nodes.lowered_if_vendored(found.place.source, "warning"),
        )
