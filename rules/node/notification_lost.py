"""A thread waits for a notification that may have come already.

## What it finds
`wait(lock)` of a condition variable without a condition, in no loop and right after the lock was taken, in C++ sources.
Functions that wait for one more of what keeps coming (`wait_for_status`, `next_frame`) are left out.

## Why it matters on a robot
A condition variable remembers nothing: `notify_one()` wakes who waits at that moment. When the device answers before
the thread has come to `wait()`, which is a matter of load and of luck, the thread waits forever: the start-up hangs, or
a command never returns. It also wakes up without a notification now and then, and goes on too early.

## Bad
```cpp
std::unique_lock<std::mutex> lock(mutex_);
started_condition_.wait(lock);
```

## Good
```cpp
std::unique_lock<std::mutex> lock(mutex_);
started_condition_.wait(lock, [this] { return is_started_; });
```

## When to ignore it
When the other thread notifies again and again.

## References
- C++ standard, [thread.condition]: a wait may unblock spuriously, and nothing remembers a notification
- C++ Core Guidelines, CP.42: don't wait without a condition
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the program hangs at this line, now and then", tags=["CWE-833"])
def notification_lost(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.blind_waits(robot.nodes):
        yield finding(
            first.place,
            f"A notification of {first.name} that comes before this wait is lost, and the wait never ends: nothing "
            "looks, while it holds the mutex, whether it is over already",
            advice="set a flag under the mutex before notifying, and hand the wait a lambda that returns it",
            related=[
                note(first.lock, "only here the lock is taken"),
                *(note(each.place, "the same here") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning"),
        )
