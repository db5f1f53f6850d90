"""A micro-ROS executor has room for fewer handles than are added to it.

## What it finds
`rclc_executor_init()` with a literal number of handles, when the same function adds more subscriptions, timers,
services or clients to that executor. Calls under a condition are not counted.

## Why it matters on a robot
The executor allocates its handles once. With 0 the initialisation itself fails, and each `rclc_executor_add_...` beyond
the number returns an error: that callback never runs. Most firmware does not look at the result, so that the node
appears in `ros2 node list` while it ignores its commands.

## Bad
```cpp
rclc_executor_init(&executor, &support.context, 1, &allocator);
rclc_executor_add_timer(&executor, &timer);
rclc_executor_add_subscription(&executor, &command, &message, &on_command, ON_NEW_DATA);
```

## Good
```cpp
rclc_executor_init(&executor, &support.context, 2, &allocator);
```

## When to ignore it
Never.

## References
- rclc, executor.c: `number_of_handles is 0`, and `Buffer overflow of 'executor->handles'. Increase 'max_handles'`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Buffer overflow of 'executor->handles'. Increase 'max_handles'", "number_of_handles is 0"])
def executor_handles(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        for each in node.few_handles:
            handles = "handle" if each.room == 1 else "handles"
            verb = "is" if each.added == 1 else "are"
            yield finding(
                each.place,
                f"The executor has room for {each.room} {handles}, but {each.added} {verb} added: "
                "the callbacks of the rest never run",
                advice=f"initialise it with at least {each.added}",
                related=[note(each.refused, "this one is refused")],
                severity=robot.nodes.lowered(node.source, "error"),
            )
