"""The answer of a service is read before it can be there.

## What it finds
`future.result()` after `call_async()` or `send_goal_async()`, when nothing in between waits for the future, asks
whether it is done, or runs the executor. It is an info where nothing takes the result, as where all that call the
function which returns it drop its value.

Also a field of the response that is read of the future itself: `future.success`, where a local variable keeps the
future and nothing else.

## Why it matters on a robot
`call_async()` only sends the request, and `result()` of a future that is not done is None. The node takes the request
for failed, or stops with `AttributeError: 'NoneType' object has no attribute 'success'`, while the other node carries
it out. A future has no fields of the response: the node stops with AttributeError each time.

## Bad
```python
future = self.arm.call_async(SetBool.Request(data=True))
return future.result().success
```

## Good
```python
future = self.arm.call_async(SetBool.Request(data=True))
future.add_done_callback(self.on_armed)
```

## When to ignore it
When the client is not one of rclpy, and its `result()` waits.

## References
- rclpy.task.Future.result (tried with rclpy 7.1: None)
- https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "AttributeError: 'NoneType' object has no attribute 'success'",
        "AttributeError: 'Future' object has no attribute '*'",
    ],
)
def result_before_response(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for field in nodes.fields_of_futures(robot.nodes.syntax(file)):
            yield finding(
                file.span_of(field.read),
                f"A future has no '{field.read.attr}', only its result() has: AttributeError each time",
                advice="read it of result() when the answer is there, in a callback of add_done_callback()",
                related=[note(file.span_of(field.asked), "the future comes from here")],
                severity=robot.nodes.lowered(file.source, "error"),
            )
        found = sorted(nodes.early_results(robot.nodes, robot.nodes.syntax(file)), key=lambda each: not each.is_used)
        if not found:
            continue
        first, *others = found
        yield finding(
            file.span_of(first.read),
            "result() does not wait: here it is None, because the answer cannot be there yet",
            advice="read it in a callback of add_done_callback(), or await the future in an async callback",
            related=[
                note(file.span_of(first.asked), "the request is sent here"),
                *(note(file.span_of(each.read), "here, too") for each in others[:10]),
            ],
            severity=robot.nodes.lowered(file.source, "warning") if first.is_used else "info",
        )
