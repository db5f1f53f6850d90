"""An action server whose goals nobody can cancel.

## What it finds
Action servers of Python nodes whose execution asks `is_cancel_requested`, while no request to cancel can get through:
an `ActionServer` without `cancel_callback`, or a loop that asks in a node which one thread runs. Silent where
the execution is `async`, or where `handle_accepted_callback` may run it in another thread.

## Why it matters on a robot
Without `cancel_callback`, rclpy rejects each request. With one thread, the executor is busy with the goal, and takes
the request only after the goal has ended. In both cases the operator presses stop, or the mission is aborted, and the
robot goes on to the end of its goal.

## Bad
```python
self.server = ActionServer(self, Dock, 'dock', self.execute)

def execute(self, goal_handle):
    while not goal_handle.is_cancel_requested:
        self.step()
```

## Good
```python
self.server = ActionServer(self, Dock, 'dock', self.execute, cancel_callback=lambda _: CancelResponse.ACCEPT)
# and in main():
rclpy.spin(node, executor=MultiThreadedExecutor())
```

## When to ignore it
When something else than rclpy runs the callbacks of the node.

## References
- rclpy, action/server.py: `default_cancel_callback` rejects all requests
- https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

REJECTED = "rclpy rejects each request to cancel a goal of this server, because it has no cancel_callback"
UNSEEN = (
    "This loop never sees a request to cancel the goal: {}() keeps the only thread of the executor, which would take "
    "the request"
)


@rule("warning", silent="the client only learns that its request was rejected, or waits for the answer")
def cancel_ignored(robot: Robot) -> Iterator[Finding]:
    for found in nodes.ignored_cancels(robot.nodes):
        server, asked = found.file.span_of(found.server), found.file.span_of(found.asked)
        severity = robot.nodes.lowered_if_vendored(found.file.source, "warning")
        if found.is_rejected:
            yield finding(
                server,
                REJECTED,
                advice="give it cancel_callback=lambda request: CancelResponse.ACCEPT",
                related=[note(asked, f"never true in {found.execute}()")],
                severity=severity,
            )
        else:
            yield finding(
                asked,
                UNSEEN.format(found.execute),
                advice="spin with a MultiThreadedExecutor",
                related=[note(server, "the server is made here")],
                severity=severity,
            )
