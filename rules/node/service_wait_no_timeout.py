"""The node silently waits for a service without a timeout.

## What it finds
`wait_for_service()` or `wait_for_server()` without a timeout in a callback, or in the constructor of a node when no
message before it says what the node waits for.

## Why it matters on a robot
If the other node does not start, or has another name or domain, this node hangs. Its process exists and `ros2 node
list` shows it, but no log line says what it waits for, and none of its timers or stop commands run.

## Bad
```python
self.dock = self.create_client(Trigger, 'dock')
self.dock.wait_for_service()
```

## Good
```python
while not self.dock.wait_for_service(timeout_sec=2.0):
    self.get_logger().warning('waiting for the service dock')
```

## When to ignore it
When the wait is in a tool that a person starts and watches, or when the node logs the wait in another thread.

## References
- https://docs.ros.org/en/jazzy/p/rclpy/, rclpy.client.Client.wait_for_service
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import wait_in_loop


@rule("warning", fix="unsafe", symptoms=["service not available, waiting again..."])
def service_wait_no_timeout(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        for call, service, where, logged in nodes.waits(robot.nodes.ending(file), node):
            at_start = where == "__init__"
            if logged and at_start:
                continue
            what = f"'{service}'" if service else "the service"
            silently = "" if logged else " without any message"
            loop = wait_in_loop(file.span_of(call), f"Waiting for {service or 'the service'}")
            yield finding(
                file.span_of(call),
                f"If {what} never appears, the node hangs {'at start' if at_start else f'in {where}()'}{silently}",
                advice="wait with timeout_sec= in a loop that logs what it waits for",
                related=[note(service, "declared here")] if isinstance(service, Located) else [],
                severity=robot.nodes.lowered(file.source, "warning"),
                fix=fix("wait in a loop that logs", codemod=loop, safe=False) if loop else None,
            )
