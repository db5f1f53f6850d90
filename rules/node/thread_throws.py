"""An exception leaves the function of a thread, which ends the whole program.

## What it finds
In C++, a `throw` in the function that a `std::thread` runs, or in a function of the file that it calls, when no `try`
takes it, and what failed is an answer of the system, a device or another node: a socket, a file, a future, a transform,
or what a handler passes on. It is an info where the thread starts only `if (!queue.empty())`, and nothing of the
package fills the queue.

## Why it matters on a robot
No caller can take what leaves the function of a thread: C++ calls `std::terminate`. Where the same exception in
`main()` or in a callback could be logged and answered, here the process aborts at once, with all nodes in it, and
without any destructor that would stop the motors. A port that is still in use after a restart is enough.

## Bad
```cpp
receiver_ = std::thread([this] {
  if (bind(socket_, address, size) < 0) { throw std::runtime_error("bind"); }
  receive();
});
```

## Good
```cpp
if (bind(socket_, address, size) < 0) { throw std::runtime_error("bind"); }
receiver_ = std::thread([this] { receive(); });
```

## When to ignore it
When the process is meant to abort.

## References
- C++ standard, [thread.thread.constr]: an exception that leaves the function calls std::terminate
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["terminate called after throwing an instance of 'std::runtime_error'"])
def thread_throws(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.thread_throws:
            idle = found.queue and nodes.is_never_filled(robot.nodes, driver.source, found.queue)
            yield finding(
                found.thrown,
                f"No handler can take what {found.function} throws here, in a thread of its own: the process aborts",
                advice="do it before the thread starts, or catch it in the thread, log it and call rclcpp::shutdown()",
                related=[note(found.started, "starts the thread")],
                severity="info" if idle else robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
