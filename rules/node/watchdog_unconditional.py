"""The watchdog is fed even when the robot is stuck.

## What it finds
A timer of a node that sends `WATCHDOG=1` to systemd without any condition.

## Why it matters on a robot
`WatchdogSec=` restarts a service that hangs. If the notifier is a separate node, its timer keeps running while the
drivers that it vouches for are stuck: the watchdog proves that the notifier runs, and nothing more.

## Bad
```python
def beat(self):
    self.notifier.notify('WATCHDOG=1')
```

## Good
```python
def beat(self):
    if self.last_scan_age() < 1.0:
        self.notifier.notify('WATCHDOG=1')
```

## When to ignore it
When the notifier is in the same single-threaded executor as the code that can hang, so that a hang also stops the
timer.

## References
- sd_notify(3), WATCHDOG=1; systemd.service(5), WatchdogSec=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("info", confidence="medium", silent="the watchdog is fed, so it reports nothing")
def watchdog_unconditional(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        for call, callback in nodes.fed_without_condition(robot.nodes.syntax(file), node):
            yield finding(
                file.span_of(call),
                f"{callback}() feeds the watchdog even when the robot is stuck",
                advice="send WATCHDOG=1 only while the monitored messages are recent and their diagnostics are good",
            )
