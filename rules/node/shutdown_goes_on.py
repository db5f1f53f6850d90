"""A function shuts the context down because of a device, and then uses that device.

## What it finds
`rclcpp::shutdown()` in a branch that is there because something is not connected, not open or null, when the branch
does not leave the function, and the function then uses the same thing. It is a warning where a null pointer is used,
else an info: what is published after the shutdown goes nowhere.

## Why it matters on a robot
`rclcpp::shutdown()` ends nothing: it returns, and `spin()` notices it after the callback. Until then the function goes
on as if nothing was wrong. It follows a null pointer, which ends the process without a destructor, or reads from a port
that is closed: the last lines of the log then tell of something else than what has failed.

## Bad
```cpp
if (port_ == nullptr) { RCLCPP_FATAL(get_logger(), "no board"); rclcpp::shutdown(); }
state_ = port_->read();
```

## Good
```cpp
if (port_ == nullptr) { RCLCPP_FATAL(get_logger(), "no board"); rclcpp::shutdown(); return; }
state_ = port_->read();
```

## When to ignore it
When using it then is known to do nothing.

## References
- rclcpp, context.cpp: `shutdown()` marks the context, and wakes those who wait
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="only what the device answers then is logged, if anything is")
def shutdown_goes_on(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        places = [each for each in driver.shut_contexts if each.owner is None]
        places.sort(key=lambda each: not each.is_null)
        for first in places[:1]:
            why = "which is null: the process crashes" if first.is_null else "which it has just found to be of no use"
            yield finding(
                first.shutdown,
                f"This returns, and the function goes on with {first.name}, {why}",
                advice="return after it",
                related=[
                    note(first.behind, "used all the same"),
                    *(note(each.shutdown, "the same") for each in places[1:]),
                ],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning") if first.is_null else "info",
            )
