"""A request is sent before its service is found, and the node waits forever for the answer.

## What it finds
`rclpy.spin_until_future_complete()` without a time-out for the answer to a `call_async()` that follows the making of
its client at once, in a Python file where nothing waits for a service or asks whether it is there. And requests and
goals that are sent behind an `if not client.wait_for_service(timeout_sec=...)` that only logs and goes on: an info
where the wait for the answer has a time-out, and what comes after it asks whether there is an answer.

## Why it matters on a robot
A new client needs a moment until it has found its service, even if that runs already. DDS keeps a request for nobody
who comes later: it is lost, no answer comes, and the node hangs where it starts, without a word. At boot, when the
other node starts later, it hangs each time.

## Bad
```python
client = node.create_client(Trigger, 'calibrate')
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future)
```

## Good
```python
client = node.create_client(Trigger, 'calibrate')
while not client.wait_for_service(timeout_sec=1.0):
    node.get_logger().info('waiting for calibrate')
future = client.call_async(Trigger.Request())
rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
```

## When to ignore it
Never: `wait_for_service()` returns at once where the service is there.

## References
- rclpy, client.py: `wait_for_service`, `call_async`
- rmw, qos_profiles.h: `rmw_qos_profile_services_default` is volatile
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the node waits for the answer without a word", tags=["CWE-833"])
def request_lost(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for found in nodes.lost_requests(robot.nodes.ending(file)):
            service = f" to {found.client.name}" if found.client.name is not None else ""
            yield finding(
                file.span_of(found.spin),
                f"The request{service} is sent before the service is found, and is lost: this waits forever",
                advice="call wait_for_service(timeout_sec=...) before, and give the spin a timeout_sec",
                related=[
                    note(found.client.span, "makes the client"),
                    note(file.span_of(found.sent), "sends the request"),
                ],
                severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
            )
        for vain in nodes.sent_in_vain(robot.nodes.syntax(file)):
            server = "service" if vain.kind == "request" else "server"
            end = "this waits forever" if vain.waits else "its answer never comes"
            if vain.is_limited:
                end = "the wait for its answer ends with its time-out"
            yield finding(
                file.span_of(vain.sent),
                f"The {vain.kind} is sent even when the {server} is not there: it is lost then, and {end}",
                advice=f"return where the {server} is not there",
                related=[note(file.span_of(vain.asked), "only logs that it is not there, and goes on")],
                severity="info" if vain.is_limited else robot.nodes.lowered_if_vendored(file.source, "warning"),
            )
