"""A callback of a C++ node reads a member that has no value yet.

## What it finds
A number or truth value, or an array of them, that a class of nodes declares without a value, and that only its
callbacks name, when a callback reads it before anything can have set it: because only another callback does, or only
the same one, later. The same for hardware and controllers of ros2_control, in `read()`, `write()` and `update()`.
Members that a constructor, `on_init()`, `on_configure()` or any other function names are left out, and reads behind
conditions that may know whether there is a value.

## Why it matters on a robot
Such a member holds whatever was in that memory before: seldom the same on the robot as on the desk. The first
difference of encoder ticks moves the odometry by metres, a speed is published that nobody measured, and a flag that is
to wait for the first message is already true.

## Bad
```cpp
double last_ticks_;
void on_ticks(const Int32 & m) { travel(m.data - last_ticks_); last_ticks_ = m.data; }
```

## Good
```cpp
double last_ticks_ = 0.0;
```

## When to ignore it
When the object is made in memory that is zero.

## References
- class_loader makes hardware and controllers by `new T`, without parentheses: that sets no member
- C++ standard, [dcl.init]: a member without an initialiser has an indeterminate value
- C++ Core Guidelines, C.48: prefer default member initializers
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="no compiler warns of members, and a debug build often finds zero there")
def member_unset(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.unset_members(robot.nodes):
        source = first.read.source
        when = "the first time it runs" if first.set_later is None else "until another callback has set it"
        yield finding(
            first.read,
            f"'{first.name}' has no value {when}: {first.callback} uses whatever was in memory",
            advice=f"give it a value where {first.owner} declares it: {first.name}{{}}",
            related=[
                *([note(first.declared, "declared without a value")] if first.declared is not None else []),
                *([note(first.set_later, "set here, in another callback")] if first.set_later is not None else []),
                *(note(each.read, f"'{each.name}' has the same mistake") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(source, "warning"),
        )
