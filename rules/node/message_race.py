"""A callback of a C++ node replaces a message while another thread reads it.

## What it finds
A member to which a subscription assigns its whole message, and that a function reads which the file runs in a thread of
its own (`std::thread`, as the execution of an action often is), or `update()` of a controller of ros2_control, which
the controller manager calls in its real-time thread; when neither the source nor its header locks anything, or uses an
atomic or a real-time buffer.

## Why it matters on a robot
The executor runs the callback at any time, also in the middle of the other function. A copied message has texts and
vectors whose memory the assignment may free: the process then crashes, after hours, in a place that has nothing to do
with it. Without these, positions are half of one message and half of another. A shared pointer is no safer: to assign
it while another thread copies it is a race as well.

## Bad
```cpp
void on_joints(const JointState & message) { joints_ = message; }
void execute() { for (size_t i = 0; i < joints_.name.size(); i++) { ... } }   // std::thread
```

## Good
```cpp
void on_joints(const JointState & message) { std::lock_guard lock(mutex_); joints_ = message; }
void execute() { const auto joints = [this] { std::lock_guard lock(mutex_); return joints_; }(); ... }
```

## When to ignore it
When the thread only runs while no message can come.

## References
- C++ standard, [intro.races]: conflicting actions in two threads are undefined behaviour
- https://control.ros.org/jazzy/doc/realtime_tools/doc/index.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="a crash or a wrong number, once in hours", tags=["CWE-362"])
def message_race(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.races(robot.nodes):
        told = first.callback.replace("a lambda", "A lambda")
        where = "the control loop" if first.is_update else "its own thread"
        yield finding(
            first.replaced,
            f"{told} replaces '{first.name}' while {first.reader}() reads it in {where}, without a lock: "
            "it may read half of two messages, or freed memory",
            advice="hand it over in a realtime_tools::RealtimeBuffer" if first.is_update else "guard both with a mutex",
            related=[
                note(first.read, f"read here, by {first.reader}()"),
                *(note(each.replaced, f"'{each.name}' has the same mistake") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.replaced.source, "warning"),
        )
