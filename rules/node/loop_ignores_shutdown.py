"""A C++ program goes on after it was told to end.

## What it finds
In `main` between `rclcpp::init()` and `rclcpp::shutdown()`, and in the constructors of nodes: `while (true)`,
`for (;;)`, and loops that sleep until something comes, when nothing in them asks `rclcpp::ok()`, leaves the loop,
counts tries or time, or looks at a flag by which a signal could end it. Programs that treat signals themselves are left
out.

## Why it matters on a robot
`rclcpp::init()` takes SIGINT and SIGTERM for itself: they only make `rclcpp::ok()` false. A loop that does not ask
never ends, launch and systemd wait their whole time-out and then send SIGKILL, and no destructor stops the motors. A
constructor that waits for a device like that also keeps the other components of its container from being loaded.

## Bad
```cpp
while (!port_.open(device)) {
  std::this_thread::sleep_for(1s);
}
```

## Good
```cpp
while (rclcpp::ok() && !port_.open(device)) {
  std::this_thread::sleep_for(1s);
}
```

## When to ignore it
When something that the loop calls throws an exception after the shutdown.

## References
- rclcpp, signal_handler.cpp: the handler shuts the context down, and calls the one that was there before
- https://docs.ros.org/en/jazzy/p/rclcpp/ (`rclcpp::ok`)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the process is killed after the time-out of launch or systemd")
def loop_ignores_shutdown(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        if not node.deaf_loops:
            continue
        first, *others = node.deaf_loops
        where = "main()" if first.function == "main" else f"the constructor of {first.function}"
        until = "" if first.is_forever else " while it waits"
        yield finding(
            first.span,
            f"SIGINT and SIGTERM do not end this loop in {where}{until}: launch and systemd have to kill the process",
            advice="ask rclcpp::ok() in its condition",
            related=[note(each.span, "nor this one") for each in others],
            severity=robot.nodes.lowered(node.source, "warning"),
        )
