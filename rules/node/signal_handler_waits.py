"""A signal handler in C++ logs or locks.

## What it finds
A function that the package registers with `signal()` or `sa_handler` for SIGINT, SIGTERM, SIGHUP or SIGQUIT, and that
logs with `RCLCPP_INFO` and the like, or locks a mutex.

## Why it matters on a robot
A signal interrupts a thread wherever it is. If that is in a log call, or while it holds the mutex, the handler waits
for a lock that its own thread holds: the node neither goes on nor ends. Then launch and systemd send SIGKILL, and what
the node should do at its end, such as stopping a motor or a scanner, does not happen.

## Bad
```cpp
void on_signal(int) { RCLCPP_INFO(rclcpp::get_logger("rover"), "stopping"); rclcpp::shutdown(); }
```

## Good
```cpp
std::atomic<bool> is_stopped{false};
void on_signal(int) { is_stopped = true; }
```

## When to ignore it
When all threads but one block the signals, and that one never logs.

## References
- signal-safety(7): what a handler may call
- rclcpp::init installs handlers of its own, which only wake a thread
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the node hangs at its end, now and then", tags=["CWE-479"])
def signal_handler_waits(robot: Robot) -> Iterator[Finding]:
    for handler, registered in nodes.waiting_handlers(robot.nodes):
        what = "the log" if handler.is_log else "this mutex"
        yield finding(
            handler.place,
            f"A signal that comes while its thread uses {what} makes {handler.name}() wait for itself: the node hangs",
            advice="only set a std::atomic flag in the handler, and log and stop where the program looks at it",
            related=[note(registered, "registered here")],
            severity=robot.nodes.lowered_if_vendored(handler.place.span.source, "warning"),
        )
