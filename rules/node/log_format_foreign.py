"""A C++ node logs a text from elsewhere as a format.

## What it finds
`RCLCPP_INFO(logger, text.c_str())` and the like with nothing but a text that is not written there. It is a warning
where a message, request or result holds the text, else an info. Once a source, with the other places.

## Why it matters on a robot
The macros take a format, as printf does. A `%` in the text, as in a file name, a URL or "battery at 20 % now", is read
as a conversion of an argument that is not there: the log shows garbage, or the node crashes while it reports an error.

## Bad
```cpp
RCLCPP_INFO(get_logger(), msg->data.c_str());
```

## Good
```cpp
RCLCPP_INFO(get_logger(), "%s", msg->data.c_str());
```

## When to ignore it
When the text surely never has a `%`.

## References
- https://docs.ros.org/en/jazzy/Tutorials/Demos/Logging-and-logger-configuration.html
- gcc(1), `-Wformat-security`
- CWE-134: Use of Externally-Controlled Format String
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the log shows garbage, or the node crashes", tags=["CWE-134"])
def log_format_foreign(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.format_texts(robot.nodes):
        yield finding(
            first.place,
            f"{first.macro} takes this text as a format: a % in it prints garbage or crashes the node",
            advice=f'write "%s", {first.text}',
            related=[note(each.place, "the same here") for each in others],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning") if first.is_foreign else "info",
        )
