"""A node connects to its MQTT broker once, at its start, and ends when the broker does not answer yet.

## What it finds
`connect()` of a client of paho-mqtt which the constructor of a Python node calls, by itself, through a method or
through a class of the workspace, outside every `try` that takes OSError. Silent where something is seen to start the
node again: `respawn` or `on_exit` in a launch file, a unit or container that runs it by itself, a loop of a script, a
`try` around the call that makes the node; and where the code tries by itself whether the broker answers. For
information where no launch file of the tree starts the node.

## Why it matters on a robot
At boot the broker starts at the same time as the node, or is on another computer and the network is not up yet.
`connect()` then raises ConnectionRefusedError, "No route to host" or a timeout. The node ends with a traceback, nothing
starts it again, and the robot runs without its link, although the broker answers a second later.

## Bad
```python
self.client.connect(self.broker, 1883)
self.client.loop_start()
```

## Good
```python
self.client.connect_async(self.broker, 1883)
self.client.loop_start()  # tries again until the broker answers
```

## When to ignore it
When what starts the node waits for the broker.

## References
- paho-mqtt, client.py: `connect()` opens the socket and hands on its exception; the thread of `loop_start()` tries the
  first connection again and again
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

MENTIONED = regex(r"\bpaho\b", hints="paho")


@rule(
    "warning",
    symptoms=["ConnectionRefusedError: [Errno 111] Connection refused", "OSError: [Errno 113] No route to host"],
)
def server_unreached(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(MENTIONED):
        return
    for each in nodes.unreached_servers(robot.nodes):
        yield finding(
            each.file.span_of(each.node),
            "connect() raises when the broker does not answer yet, and nothing catches it: the node exits at its "
            "start, and nothing starts it again",
            advice="call connect_async(): the thread of loop_start() tries again until the broker answers",
            related=[note(each.where, "the connection")] if each.where is not None else [],
            severity=robot.nodes.lowered(each.file.source, "warning") if each.is_launched else "info",
        )
