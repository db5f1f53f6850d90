"""A member is made of another one that is made after it.

## What it finds
In classes of C++ nodes, a value of a member that uses a member which the class declares further down: a
`TransformListener` that gets its buffer, a number that is computed of another, a smart pointer that is followed.

## Why it matters on a robot
C++ makes members in the order of their declarations, whatever the order in the list of a constructor is. The other
member is memory without a value at that time: the listener works with a buffer that does not exist yet, a rate is any
number, and a pointer leads anywhere. It may work in one build and crash at the start in the next.

## Bad
```cpp
tf2_ros::TransformListener listener_{buffer_};
tf2_ros::Buffer buffer_{get_clock()};
```

## Good
```cpp
tf2_ros::Buffer buffer_{get_clock()};
tf2_ros::TransformListener listener_{buffer_};
```

## When to ignore it
Never: exchange the two declarations.

## References
- C++ standard, [class.base.init]: non-static data members are initialised in the order of their declarations
- g++ 12: `-Wuninitialized`, `-Wreorder`
- tf2_ros, transform_listener.cpp: the constructor calls the buffer
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["is used uninitialized [-Wuninitialized]", "will be initialized after [-Wreorder]"])
def member_early(robot: Robot) -> Iterator[Finding]:
    for found in nodes.early_members(robot.nodes):
        yield finding(
            found.used,
            f"{found.name} is made before {found.used.text}, which has no value yet: what it gets is whatever was in "
            "memory",
            advice=f"declare {found.used.text} above {found.name}",
            related=[note(found.declared, "made first"), note(found.later, "made later")],
            severity=robot.nodes.lowered(found.used.source, "warning"),
        )
