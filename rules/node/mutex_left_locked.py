"""A function returns early and leaves a mutex locked.

## What it finds
In C++ sources of nodes and drivers a `return` between `mutex.lock()` and the statement of the same block that calls
`mutex.unlock()`, with no unlock before it; the same for `pthread_mutex_lock` and `pthread_mutex_unlock`. Guards, whose
destructor unlocks, are left out.

## Why it matters on a robot
The early return is the path for what seldom happens: a broken packet, a file that cannot be opened. After the first one
the mutex stays locked for good, and every later lock waits forever: the driver neither reads nor drives any more, while
its process stays alive, so that neither launch nor systemd starts it again.

## Bad
```cpp
mutex_.lock();
if (packet.empty()) { return; }
state_ = decode(packet);
mutex_.unlock();
```

## Good
```cpp
std::lock_guard<std::mutex> lock(mutex_);
if (packet.empty()) { return; }
state_ = decode(packet);
```

## When to ignore it
When something that the function calls before has unlocked the mutex.

## References
- C++ Core Guidelines, CP.20: use RAII, never plain lock()/unlock()
- pthread_mutex_lock(3p)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the thread waits in pthread_mutex_lock, and logs nothing", tags=["CWE-667"])
def mutex_left_locked(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.left_locked:
            yield finding(
                found.left,
                f"This return leaves {found.mutex} locked: whatever locks it next waits forever",
                advice=f"lock it with std::lock_guard, or unlock {found.mutex} before",
                related=[note(found.locked, "locked here")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "error"),
            )
